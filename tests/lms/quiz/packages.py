"""Reading packages back: their files, their numbers, and whether the elements stand where a
standard lets them.
"""

from __future__ import annotations

import re
import zipfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from xml.etree.ElementTree import Element, fromstring


def files_of(package: Path) -> dict[str, str]:
    """The texts of a package's files by name, in the order in which they stand there."""
    with zipfile.ZipFile(package) as archive:
        return {name: archive.read(name).decode() for name in archive.namelist()}


def listing(package: Path) -> str:
    """All files of a package one below the other."""
    return "".join(f"=== {name}\n{text.rstrip()}\n" for name, text in files_of(package).items())


def bare(text: str) -> Element:
    """A document without namespaces, which stand on the roots alone."""
    return fromstring(
        re.sub(r' xmlns(:xsi)?="[^"]*"| xsi:schemaLocation="[^"]*"| xml:lang="[^"]*"', "", text)
    )


def misplaced(
    root: Element, models: Mapping[str, str], attributes: Mapping[str, str]
) -> Iterator[str]:
    """What breaks the rules: `models` are regular expressions over the names of children, each
    followed by a blank, with `#` where text may stand; `attributes` are the names an element may
    have, those with `!` it must have.
    """
    for node in root.iter():
        if node.tag not in models:
            yield f"{node.tag}: unknown"
            continue
        model = models[node.tag]
        children = "".join(f"{child.tag} " for child in node)
        if not re.fullmatch(model.replace("#", ""), children):
            yield f"{node.tag}: holds {children}"
        texts = (node.text or "") + "".join(child.tail or "" for child in node)
        if texts.strip() and "#" not in model:
            yield f"{node.tag}: text {texts.strip()[:20]!r}"
        allowed = attributes.get(node.tag, "").split()
        unknown = set(node.attrib) - {name.rstrip("!") for name in allowed}
        missing = {name[:-1] for name in allowed if name.endswith("!")} - set(node.attrib)
        if unknown or missing:
            yield f"{node.tag}: attributes {sorted(unknown)} too many, {sorted(missing)} missing"
