"""What every law can say: why the rates of a mechanism are related."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from typing import ClassVar, Self

from kinegrade.language.message import Message
from kinegrade.mechanics.laws.turning import Arm, Turning
from kinegrade.mechanics.shapes import Circle, Line
from kinegrade.mechanics.shares import Shares
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Number


@dataclass(frozen=True)
class Reason(ABC):
    """What every law can say, and whether it `keeps_parallel` two bodies.

    The factors of a law of turning rates are the same in every position, so that they hold for the
    angles themselves.
    """

    keeps_parallel: ClassVar[bool] = False

    @abstractmethod
    def describe(self, element: Message) -> Message:
        """The relation in messages, given the name of the joint or driver that states it."""

    @property
    @abstractmethod
    def is_given(self) -> bool:
        """Whether it only states what is given."""

    @abstractmethod
    def list_factors(self, shares: Shares) -> Turning:
        """The factors of the turning rates and of a guided centre's rate; none for an equation of
        vectors.
        """

    def list_arms(self, shares: Shares) -> tuple[Arm, ...]:
        """The arms that carry wheels on circles, with the shares that are taken of them: none."""
        return ()

    def find_guided_body(self) -> str | None:
        """The moving body whose point it guides; None where it guides none."""
        return None

    def find_imposed_direction(self) -> Vector | None:
        """The direction along which a driver imposes a motion; None where none does."""
        return None

    def find_imposed_circle(self) -> tuple[str, str] | None:
        """The point that a driver moves on a circle, and its centre; None where none does."""
        return None

    def map(self, number: Callable[[Number], Number]) -> Self:
        """The law with `number` applied to its vectors, lines and circles."""
        parts = {each.name: getattr(self, each.name) for each in fields(self)}
        mapped = {
            name: part.map(number)
            for name, part in parts.items()
            if isinstance(part, (Vector, Line, Circle))
        }
        return replace(self, **mapped) if mapped else self
