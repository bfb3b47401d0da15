"""Whether a student was given the questions of the student's paper, judged by the right answers in
a download.

A quiz may contain variants that all students draw from, or another student's paper. Marked with the
key of the student's paper, such answers would all be wrong, so they are reported instead.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.cell_text import trim
from kinegrade.language.message import Message

_NUMBER = re.compile(r"[-+]?\d{1,30}(?:[.,]\d{1,60})?(?:[eE][-+]?\d{1,3})?")
_SHARE = 0.02  # a quiz may state the middle of the interval that is right, to three figures
_NEXT_TO_NOTHING = 1e-6


def right_answers(exam: ExamFolder, student: str) -> Mapping[str, float]:
    """The right answers on a student's paper by column; none where the key has no line for the
    student. Raises ExamError.
    """
    line = exam.keys.find_line(student)
    return {
        f"{question.question}.{name}": float(answer.value)
        for question in (line.questions if line else ())
        for name, answer in question.asks.items()
        if answer.value is not None
    }


def difference(
    columns: Sequence[str], stated: Sequence[str], right: Mapping[str, float]
) -> Message | None:
    """How the right answers stated by a download differ from those of the student's paper; None
    where they agree.

    A stated answer may have a decimal comma and a unit; a text that does not begin with a number is
    not compared.

    >>> difference(["q1.v_B"], ["-1,5 m/s"], {"q1.v_B": 2.5})
    Message('responses.right-answer', ask='q1.v_B', there='-1,5 m/s', paper='2.5')
    """
    for column, text in zip(columns, stated, strict=False):
        value = value_of(text)
        if value is not None and column in right and not agree(value, right[column]):
            paper = f"{right[column]:.6g}"
            return Message("responses.right-answer", ask=column, there=text, paper=paper)
    return None


def value_of(text: str) -> float | None:
    """The number at the beginning of a right answer, None where there is none."""
    found = _NUMBER.match(trim(text))
    return float(found[0].replace(",", ".")) if found else None


def agree(stated: float, right: float, share: float = _SHARE) -> bool:
    """Whether two numbers differ by no more than that share of the second."""
    return abs(stated - right) <= max(share * abs(right), _NEXT_TO_NOTHING)
