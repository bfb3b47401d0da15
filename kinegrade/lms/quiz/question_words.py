"""Notes beside a question where a system cannot do all that the exam does; for plain text and for
HTML.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class QuestionWords:
    """Sentences in one language; `{}` takes a text."""

    tag: str  # the language as XML names it
    changed_unit: str  # takes the unit here and the one on paper
    any_turns: str
    half_turn: str
    figure_on_paper: str


_ENGLISH = QuestionWords(
    tag="en",
    changed_unit="Mind the unit: {} here, not {}.",
    any_turns="Whole turns may be added or taken off, as long as the angle stays within two turns "
    "of zero.",
    half_turn="Give the angle within half a turn of zero (−180° to 180°).",
    figure_on_paper="(The figure is on your paper.)",
)
_CHINESE = QuestionWords(
    tag="zh-CN",
    changed_unit="注意单位：此处用 {}，不用 {}。",
    any_turns="角度可加减整周，但须在正负两周以内。",
    half_turn="角度请取正负半周以内的值（−180° 至 180°）。",
    figure_on_paper="（图见你的试卷。）",
)
WORDS: Mapping[str, QuestionWords] = {"en": _ENGLISH, "zh": _CHINESE}
