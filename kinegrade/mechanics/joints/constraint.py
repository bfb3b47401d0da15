"""What every joint says: which conditions it states, and whether the positions meet it."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import ClassVar, Literal, Self

from kinegrade.language.message import Message
from kinegrade.mechanics.element import Element, require_attributes
from kinegrade.mechanics.laws import Condition, Law, SharedPoint
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.sentence import JointParts
from kinegrade.mechanics.shapes import Circle, Line, Profile, Shape
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic

Slip = Literal["meshing", "crossing", "carried", "arm", "ratio", "centre", "pole"]


class Constraint(Element):
    """A joint; `PATTERN` is the regular expression of its sentence, with its parts by name,
    `FORM` the same as authors read it, with what it takes in capitals, and `EXAMPLES` are shown.

    `SLIPS` are the parts of what it states that students are known to take wrongly.
    """

    PATTERN: ClassVar[str]
    FORM: ClassVar[str]
    EXAMPLES: ClassVar[tuple[str, ...]]
    SLIPS: ClassVar[tuple[Slip, ...]]

    def __init_subclass__(cls) -> None:
        """Refuses a joint that lacks one of them. Raises TypeError."""
        super().__init_subclass__()
        require_attributes(cls, Constraint.__annotations__)

    @classmethod
    @abstractmethod
    def make(cls, parts: JointParts) -> Self:
        """The joint that a sentence states."""

    @abstractmethod
    def list_shapes(self) -> tuple[Shape, ...]:
        """The lines and circles that it refers to."""

    @abstractmethod
    def list_conditions(self) -> tuple[Condition, ...]:
        """The points that it holds or guides, and the bodies that it keeps parallel."""

    def find_profile(self) -> Profile | None:
        """The profile that may slip on another body: none."""
        return None

    def list_needed_pins(self) -> tuple[SharedPoint, ...]:
        """The points that its bodies have to share already, by other joints: none."""
        return ()

    @cached_property
    def conditions(self) -> tuple[Condition, ...]:
        """The same, listed once."""
        return self.list_conditions()

    @abstractmethod
    def relate_rates(
        self, number: int, points: Mapping[str, Vector], guided: Rate | None
    ) -> Law | None:
        """How else it relates turning rates, as the joint of that number in its mechanism; None
        where it does not.

        `guided` is the rate of the point that it guides.
        """

    @abstractmethod
    def find_misfits(
        self, points: Mapping[str, Vector], arithmetic: Arithmetic
    ) -> Iterator[Message]:
        """What is wrong with the positions of the points, m."""

    def list_lines(self) -> tuple[Line, ...]:
        """The lines that it refers to."""
        return tuple(shape for shape in self.list_shapes() if isinstance(shape, Line))

    def list_circles(self) -> tuple[Circle, ...]:
        """The circles that it refers to."""
        return tuple(shape for shape in self.list_shapes() if isinstance(shape, Circle))


class Unrelated(Constraint):
    """A joint that relates no turning rates beyond its conditions, and says so."""

    def relate_rates(
        self, number: int, points: Mapping[str, Vector], guided: Rate | None
    ) -> Law | None:
        """Not at all."""
        return None
