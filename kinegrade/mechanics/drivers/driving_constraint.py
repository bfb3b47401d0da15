"""What every driver says: which point it moves, and the relation that it imposes."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping
from typing import ClassVar, Self

from kinegrade.mechanics.element import Element, require_attributes
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Chain
from kinegrade.mechanics.sentence import DriverParts
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic

FindChain = Callable[[str, str], Chain]


class DrivingConstraint(Element):
    """A driver; `PATTERN` is the regular expression of its sentence, with its parts by name,
    `FORM` the same as authors read it, `EXAMPLES` are shown, and what it drives `TURNS` or moves
    along a path.
    """

    PATTERN: ClassVar[str]
    FORM: ClassVar[str]
    EXAMPLES: ClassVar[tuple[str, ...]]
    TURNS: ClassVar[bool]

    def __init_subclass__(cls) -> None:
        """Refuses a driver that lacks one of them. Raises TypeError."""
        super().__init_subclass__()
        require_attributes(cls, DrivingConstraint.__annotations__)

    @classmethod
    @abstractmethod
    def make(cls, parts: DriverParts) -> Self:
        """The driver that a sentence states."""

    @abstractmethod
    def find_driven_point(self) -> tuple[str, str] | None:
        """The point that it moves and the body of which it is a point; None for a rotation."""

    def find_frame(self) -> str | None:
        """The body relative to which it moves a point along a direction; None where it moves none
        so.
        """
        return None

    @abstractmethod
    def state(
        self,
        number: int,
        find_chain: FindChain,
        points: Mapping[str, Vector],
        arithmetic: Arithmetic,
    ) -> Relation:
        """The relation that it imposes, as the driver of that number in its mechanism.

        `find_chain` gives the terms of a body's point. Raises MechanismError.
        """
