"""A question as one paper has it."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.exam.setting.key_mistakes import Mistaken
from kinegrade.exam.setting.setting import SetQuestion
from kinegrade.press.sheet import QuestionSheet


@dataclass(frozen=True)
class DrawnQuestion:
    """A question of one paper: as it is set, as it is laid out, and what mistakes lead to."""

    question: SetQuestion
    sheet: QuestionSheet
    mistaken: Mistaken
