"""What stands in the way of somebody on a practice sheet: who wants dark colours, a zoom of 400 %,
no motion, paper, or has a screen reader.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from tests.browsers.page import Page
from tests.practice.typed_sheet import open_sheet

_OPEN_ALL = """
for (const each of document.querySelectorAll("details")) each.open = true;
for (const form of document.querySelectorAll("form")) {
  form.querySelectorAll("input").forEach((box, place) => (box.value = ["abc", "3", ""][place % 3]));
  form.requestSubmit();
}
for (const each of document.querySelectorAll(".solution, .poles, .centrodes")) each.click();
"""
_NARROW = 320  # pixels: 1,280 at a zoom of 400 %
_NAMED = ("button", "textbox", "slider", "checkbox", "image", "group", "heading")  # by any name
_SHOWN = "[...document.querySelectorAll({!r})].filter((each) => each.checkVisibility()).length"


def find_barriers(page: Page, file: Path) -> Iterator[str]:
    """A line for each, with everything on the sheet open and answered."""
    for scheme in ("light", "dark"):
        page.size(1280, 900)
        page.prefer(color_scheme=scheme)
        open_sheet(page, file)
        page.run(_OPEN_ALL)
        yield from (f"{scheme}: {fault}" for fault in page.faults())
    yield from _list_misnamed(page.tree())
    page.size(_NARROW, 900)
    wide = page.run("document.documentElement.scrollWidth")
    if wide > _NARROW:
        yield f"{wide} pixels wide in a window of {_NARROW}"
    page.prefer("print", color_scheme="dark")
    if page.run("getComputedStyle(document.body).backgroundColor") != "rgb(255, 255, 255)":
        yield "dark on paper"
    for shown in ("button", "input[type=range]", "input[type=checkbox]"):
        if page.run(_SHOWN.format(shown)):
            yield f"{shown} on paper"


def _list_misnamed(tree: Mapping[str, Any]) -> Iterator[str]:
    """What a screen reader cannot name, and boxes to type into that it names alike."""
    named = [(role, name) for role, name in list_names(tree) if role in _NAMED]
    yield from (f"without a name: {role}" for role, name in named if not name)
    boxes = [name for role, name in named if role == "textbox"]
    yield from (f"twice: {name}" for name in sorted(set(boxes)) if boxes.count(name) > 1)


def list_names(node: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """The role and the name of a node and of all within it."""
    yield node["role"], str(node.get("name", "")).strip()
    for child in node.get("children", ()):
        yield from list_names(child)
