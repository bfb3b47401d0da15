"""The script of a practice sheet: plain files, each with one purpose, joined in this order."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable

_FOR_READERS = re.compile(
    r"^ *(?://[^\n]*|/\*\*(?:(?!\*/).)*\*/) *\n|^ +", re.MULTILINE | re.DOTALL
)
_OF_LAYOUTS = ("player",)
READER = ("keyboard", "number", "raised_dot", "formula", "unit", "sense", "answer")
JUDGE = ("judge", "guess", "unpack", "follow", "cut_off")
MOTION = ("player", "poses", "poles", "drawing", "graph", "motion")
PAGE = ("words", "explain", "score", *MOTION, "question")


@cache
def join_scripts(*, scorm: bool = False) -> str:
    """The whole script, which tells the score to a system around the page or to nobody."""
    report = "scorm" if scorm else "alone"
    return read_scripts((*READER, *JUDGE, *PAGE, report, "sheet"))


def read_scripts(names: Iterable[str]) -> str:
    """The files of these names, one after the other, without comments and indentation."""
    texts = (_find_script(name).read_text(encoding="utf-8") for name in names)
    return "\n" + "".join(_FOR_READERS.sub("", text) for text in texts)


def _find_script(name: str) -> Traversable:
    """A script of this room, or one that pages below it have as well."""
    if name in _OF_LAYOUTS:
        return files("kinegrade.press.html") / "layouts" / f"{name}.js"
    return files("kinegrade.practice") / "scripts" / f"{name}.js"
