"""The questions of an exam that are still to be marked by hand: no mark, total or percentage counts
them.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from kinegrade.language.message import Message, list_all
from kinegrade.question_numbers import find_bank_number


class OpenQuestion(NamedTuple):
    """A question that is still to be marked by hand, and its points."""

    question: str
    points: Fraction


def describe_open(questions: Sequence[OpenQuestion]) -> Message:
    """Which are open, one or more, and what totals are of meanwhile."""
    return Message(
        "marks.open",
        count=len(questions),
        questions=list_all([find_bank_number(each.question) for each in questions]),
        points=Message("marks.open-points", count=add_open_points(questions)),
    )


def add_open_points(questions: Sequence[OpenQuestion]) -> Fraction:
    """The points of all of them."""
    return sum((each.points for each in questions), Fraction(0))
