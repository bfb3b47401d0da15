"""The script of a practice sheet: plain files, each with one purpose, joined in this order."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from importlib.resources import files

_FOR_READERS = re.compile(
    r"^ *(?://[^\n]*|/\*\*(?:(?!\*/).)*\*/) *\n|^ +", re.MULTILINE | re.DOTALL
)
READER = ("keyboard", "number", "formula", "unit", "sense", "answer")
JUDGE = ("judge", "guess", "unpack", "follow")
MOTION = ("poses", "poles", "drawing", "graph", "motion")
PAGE = ("words", "explain", "score", *MOTION, "question")


@cache
def join_scripts(*, scorm: bool = False) -> str:
    """The whole script, which tells the score to a system around the page or to nobody."""
    report = "scorm" if scorm else "alone"
    return read_scripts((*READER, *JUDGE, *PAGE, report, "sheet"))


def read_scripts(names: Iterable[str]) -> str:
    """The files of these names, one after the other, without comments and indentation."""
    folder = files("kinegrade.practice") / "scripts"
    texts = ((folder / f"{name}.js").read_text(encoding="utf-8") for name in names)
    return "\n" + "".join(_FOR_READERS.sub("", text) for text in texts)
