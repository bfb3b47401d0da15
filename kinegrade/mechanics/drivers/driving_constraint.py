"""What every driver says: which point it moves, and the relation that it imposes."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping

from kinegrade.mechanics.element import Element
from kinegrade.mechanics.relations import Chain, Relation
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Arithmetic

FindChain = Callable[[str, str], Chain]


class DrivingConstraint(Element):
    """A driver."""

    @abstractmethod
    def find_driven_point(self) -> tuple[str, str] | None:
        """The point that it moves and the body of which it is a point; None for a rotation."""

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
