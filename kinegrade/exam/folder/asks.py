"""What an exam asks: its answer boxes, the same on every paper."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kinegrade.numbers.amounts import add_amounts
from kinegrade.sign_conventions import Convention


@dataclass(frozen=True, slots=True)
class Ask:
    """One answer box, the same on every paper; `unit` is "1" for a pure number.

    `sign` is the sign convention in words, as it stands on papers; "" where it is not known.
    `convention` is its keyword, None for one that the template's author put into words. The points
    of a `bonus` come on top of the maximum.
    """

    question: str
    ask: str
    unit: str
    points: Fraction
    sign: str = ""
    convention: Convention | None = None
    bonus: bool = False

    @property
    def column(self) -> str:
        """Its column in the answer sheet."""
        return f"{self.question}.{self.ask}"


def add_counted(asks: Iterable[Ask]) -> Fraction:
    """The maximum: the points of these asks, without those that are a bonus."""
    return add_amounts(ask.points for ask in asks if not ask.bonus)


def list_questions(asks: Sequence[Ask]) -> tuple[str, ...]:
    """The questions to which these asks belong, in their order."""
    return tuple(dict.fromkeys(ask.question for ask in asks))
