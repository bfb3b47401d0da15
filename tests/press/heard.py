"""A PDF as a screen reader says it: its elements in their order, what stands in for formulas and
figures in place of their letters, nothing of what only decorates.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from io import BytesIO

import pikepdf

from tests.press.glyphs import read_marked_texts

_HEADING = re.compile(r"H([1-6])")
_LINES = {"P": "\n", "LI": "\n", "TR": "\n", "Div": "\n", "Table": "\n", "L": "\n"}
_BEFORE = _LINES | {"TD": " | ", "TH": " | ", "Figure": "\npicture: "}
_BEFORE |= dict.fromkeys(("Span", "Strong", "LBody", "Formula"), " ")
_PUNCTUATION = re.compile(r"(?<=\() | (?=[.,;:)])")
Texts = Mapping[tuple[int, int], str]  # by the number of a page's object and of a marked content


def say(pdf: bytes) -> str:
    """A line for each heading, paragraph, entry of a list and row of a table."""
    with pikepdf.open(BytesIO(pdf)) as document:
        return say_element(document.Root.StructTreeRoot, read_texts(document))


def read_texts(document: pikepdf.Pdf) -> Texts:
    """The letters of every marked content of a document."""
    return {
        (page.objgen[0], number): text
        for page in document.pages
        for number, text in read_marked_texts(page).items()
    }


def say_element(element: pikepdf.Object, texts: Texts) -> str:
    """What is said of an element and all below it, as `say` has it."""
    lines = "".join(_say_element(element, 0, texts)).splitlines()
    said = (_PUNCTUATION.sub("", " ".join(line.split())) for line in lines)
    return "\n".join(line for line in said if line)


def _say_element(element: pikepdf.Object, page: int, texts: Texts) -> Iterator[str]:
    page = element.Pg.objgen[0] if "/Pg" in element else page
    kind = str(element.get("/S", "/Document"))[1:]
    heading = _HEADING.fullmatch(kind)
    if heading:
        yield f"\nheading {heading[1]}: "
    else:
        yield _BEFORE.get(kind, "")
    if "/Alt" in element:
        yield str(element.Alt)
    else:
        for kid in list_kids(element):
            if isinstance(kid, int):
                yield texts.get((page, kid), "")
            elif "/S" in kid:
                yield from _say_element(kid, page, texts)
            elif "/MCID" in kid:
                place = kid.Pg.objgen[0] if "/Pg" in kid else page
                yield texts.get((place, int(kid.MCID)), "")
    if heading or kind in _LINES or kind == "Figure":
        yield "\n"


def list_kids(element: pikepdf.Object) -> list[pikepdf.Object | int]:
    """What an element holds: other elements, and numbers of marked contents."""
    kids = element.get("/K", ())
    return list(kids) if isinstance(kids, pikepdf.Array) else [kids]
