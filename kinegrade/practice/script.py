"""The script of a practice sheet: plain files, each with one purpose, joined in this order."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from importlib.resources import files

READER = ("keyboard", "number", "formula", "unit", "sense", "answer")
JUDGE = ("judge", "guess", "unpack", "follow")
PAGE = ("words", "explain", "score", "question")


@cache
def join_scripts(*, scorm: bool = False) -> str:
    """The whole script, which tells the score to a system around the page or to nobody."""
    report = "scorm" if scorm else "alone"
    return read_scripts((*READER, *JUDGE, *PAGE, report, "sheet"))


def read_scripts(names: Iterable[str]) -> str:
    """The files of these names, one after the other, without the comments for checkers."""
    folder = files("kinegrade.practice") / "scripts"
    texts = ((folder / f"{name}.js").read_text(encoding="utf-8") for name in names)
    return "\n" + "\n".join(text.removeprefix("// @ts-check\n") for text in texts)
