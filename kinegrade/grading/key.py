"""An exam as grading sees it: who was asked what, and the key of each paper.

`exam_folder` fills these values; `sheet`, `judge` and `marks` use them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Ask:
    """One answer box, the same on every paper; `unit` is "1" for a pure number.

    `sign` is the convention in English, "counter-clockwise positive", as it stands on papers; "" where it is not known.
    """

    question: str
    ask: str
    unit: str
    points: Fraction
    sign: str = ""

    @property
    def column(self) -> str:
        """Its column in the answer sheet."""
        return f"{self.question}.{self.ask}"


@dataclass(frozen=True, slots=True)
class Key:
    """The right answer and how far from it is still right: exact fractions, all in the unit of the ask.

    `period` is a full turn for an angle that is right with any number of turns more or less.
    """

    value: Fraction
    tolerance: Fraction
    period: Fraction | None = None


@dataclass(frozen=True, slots=True)
class Examinee:
    """Whose paper it is, and its key by answer column."""

    student: str
    name: str
    keys: Mapping[str, Key]


@dataclass(frozen=True, slots=True)
class Exam:
    """The asks in the order of the paper, the examinees in the order of the roster."""

    asks: tuple[Ask, ...]
    examinees: tuple[Examinee, ...]

    @property
    def questions(self) -> tuple[str, ...]:
        """The questions in the order of the paper."""
        return tuple(dict.fromkeys(ask.question for ask in self.asks))
