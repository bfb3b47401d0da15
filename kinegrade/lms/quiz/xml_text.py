"""XML written piece by piece: texts are escaped, what is already XML is not; no tree is kept."""

from __future__ import annotations

import re
from collections.abc import Iterable
from xml.sax.saxutils import escape

_DECLARATION = '<?xml version="1.0" encoding="UTF-8"?>\n'
_SPECIAL = re.compile('[&<>"\n\t]')
_QUOTED = {'"': "&quot;", "\n": " ", "\t": " "}


class Xml(str):
    """A text that is XML: whole elements, and texts that are escaped."""

    __slots__ = ()


def write_element(tag: str, *children: str, **attributes: str) -> Xml:
    """An element of texts and elements; a trailing underscore is dropped from the name of an
    attribute.

    >>> print(write_element("p", "a < b", write_element("br"), class_='"x"'))
    <p class="&quot;x&quot;">a &lt; b<br/></p>
    """
    named = "".join(
        f' {name.rstrip("_")}="{_write_quotable(value)}"' for name, value in attributes.items()
    )
    content = "".join(child if isinstance(child, Xml) else escape(child) for child in children)
    return Xml(f"<{tag}{named}>{content}</{tag}>" if content else f"<{tag}{named}/>")


def _write_quotable(value: str) -> str:
    """An attribute's value, escaped; most need no change."""
    return escape(value, _QUOTED) if _SPECIAL.search(value) else value


def write_on_lines(elements: Iterable[Xml]) -> Xml:
    """Elements, each on its own line, where white space between elements has no meaning."""
    return Xml("".join(f"\n{one}" for one in elements) + "\n")


def write_document(root: Xml) -> bytes:
    """A whole document."""
    return f"{_DECLARATION}{root}\n".encode()
