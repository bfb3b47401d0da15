"""The lines of the key (key.jsonl), each a typed record: what a paper asks, and its answers."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

import msgspec


class StatedTolerance(msgspec.Struct, frozen=True, gc=False, omit_defaults=True):
    """Right within max(relative*|answer|, absolute), or to so many significant `figures`."""

    relative: Decimal
    absolute: Decimal
    figures: int | None = None


class StatedNumber(msgspec.Struct, frozen=True, gc=False, omit_defaults=True):
    """A number with its unit: as an exact expression where it has one, to double precision, and
    with many correct digits.
    """

    exact: str | None
    value: Decimal
    unit: str
    decimal: str | None = None

    @property
    def text(self) -> str:
        """The number as it is written out: exactly, or to double precision."""
        return self.exact or str(self.value)


class StatedAnswer(msgspec.Struct, frozen=True, gc=False, omit_defaults=True, kw_only=True):
    """What is right for an ask, and what known mistakes lead to, by the mistake's id.

    `period` is a full turn for an angle that is right with any number of turns.
    """

    exact: str | None = None
    value: Decimal | None = None
    unit: str
    decimal: str | None = None
    tolerance: StatedTolerance
    period: Decimal | None = None
    points: Decimal
    mistakes: dict[str, str] = {}


class KeyQuestion(msgspec.Struct, frozen=True, gc=False, omit_defaults=True, kw_only=True):
    """A question of one paper: `drawn` are its parameters' values in their units, as drawn."""

    question: str
    template: str = ""
    parameters: dict[str, StatedNumber] = {}
    drawn: dict[str, str] = {}
    asks: dict[str, StatedAnswer]

    @property
    def values(self) -> Mapping[str, str]:
        """The parameters' values as texts in their units: as drawn, else as the key states them."""
        return self.drawn or {name: each.text for name, each in self.parameters.items()}


class KeyLine(msgspec.Struct, frozen=True, gc=False, omit_defaults=True, kw_only=True):
    """The key of one paper. `printed` are its questions in their order on the paper, empty where
    that is the bank's; `place` is the one dealt to the student.
    """

    student: str
    paper: str = ""
    version: str = ""
    place: int | None = None
    printed: tuple[str, ...] = ()
    questions: tuple[KeyQuestion, ...]

    @property
    def order(self) -> tuple[str, ...]:
        """The questions in their order on the paper."""
        return self.printed or tuple(each.question for each in self.questions)
