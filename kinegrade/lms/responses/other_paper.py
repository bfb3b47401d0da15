"""Whether a student was put the questions of the own paper: by the right answers that a download
tells.

A quiz may hold variants that everybody draws from, or somebody else's paper. Marked by the
student's own key such answers would all be wrong, so they are told instead.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.tables import trimmed

_NUMBER = re.compile(r"[-+]?\d{1,30}(?:[.,]\d{1,60})?(?:[eE][-+]?\d{1,3})?")
_SHARE = 0.02  # a quiz may state the middle of what is right to three figures
_NEXT_TO_NOTHING = 1e-6


def right_answers(exam: ExamFolder, student: str) -> Mapping[str, float]:
    """The right answers on a student's paper by column; none where the key has no line of that
    student's. Raises ExamError.
    """
    line = exam.find_line(student)
    return {
        f"{question.question}.{name}": float(answer.value)
        for question in (line.questions if line else ())
        for name, answer in question.asks.items()
        if answer.value is not None
    }


def difference(columns: Sequence[str], told: Sequence[str], own: Mapping[str, float]) -> str:
    """How the right answers told by a download differ from those of the own paper; "" where they do
    not.

    What is told may have a decimal comma and a unit; texts that begin with no number are not
    compared.

    >>> difference(["q1.v_B"], ["-1,5 m/s"], {"q1.v_B": 2.5})
    'the right answer to q1.v_B is -1,5 m/s there and 2.5 on the own paper'
    """
    for column, text in zip(columns, told, strict=False):
        value = value_of(text)
        if value is not None and column in own and not agree(value, own[column]):
            return (
                f"the right answer to {column} is {text} there and {own[column]:.6g} on the own "
                "paper"
            )
    return ""


def value_of(text: str) -> float | None:
    """The number with which a right answer begins, None where it begins with none."""
    found = _NUMBER.match(trimmed(text))
    return float(found[0].replace(",", ".")) if found else None


def agree(told: float, own: float, share: float = _SHARE) -> bool:
    """Whether two numbers are the same within that share of themselves."""
    return abs(told - own) <= max(share * abs(own), _NEXT_TO_NOTHING)
