"""The usual sign conventions by their keywords: templates state them, folders keep them, answers in
words are read by them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, get_args

Convention = Literal["magnitude", "ccw", "cw", "+x", "-x", "+y", "-y", "unsigned", "signed"]
CONVENTIONS: tuple[Convention, ...] = get_args(Convention)
SENSES: tuple[Convention, ...] = ("ccw", "cw")  # of rotation
ALONG_AXES: tuple[Convention, ...] = ("+x", "-x", "+y", "-y")
UNSIGNED: frozenset[Convention] = frozenset({"magnitude", "unsigned"})  # never negative
OPPOSITE: Mapping[Convention, Convention] = {
    "ccw": "cw",
    "cw": "ccw",
    "+x": "-x",
    "-x": "+x",
    "+y": "-y",
    "-y": "+y",
}
