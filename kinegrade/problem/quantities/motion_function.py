"""One function of the motion that a quantity may call, with all that is known of it: how it is
written, what it gives, how it is read off, what it refers to, how a worked solution shows it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any, Literal

from msgspec import Struct

from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.kinds.kinds import Arrow, Kind, Scalar
from kinegrade.problem.kinds.signatures import Signature, Slot
from kinegrade.problem.quantities.reader import MotionReader

# How a worked solution derives it; "value" states what it refers to and then the value
Derivation = Literal[
    "point", "relative", "coriolis", "normal", "tangential", "rotation", "pole", "centrode", "value"
]


_LEVELS: Mapping[Fraction, Level] = {  # by the power of time
    Fraction(-1): "velocity",
    Fraction(-2): "acceleration",
}


class References(Struct, frozen=True):
    """What of a motion a call refers to: the motions of points, each after its body, and the
    rotations of bodies.
    """

    points: tuple[tuple[str, str], ...] = ()
    turning: tuple[str, ...] = ()


class MotionFunction(Struct, frozen=True):
    """A function of the motion.

    `example` is a call that is shown. Its arguments fill the `slots`, the last `optional` of
    which may stay empty; its value is of the kind that it `gives`. `read` takes a reader and
    the arguments; it is None for what takes further configurations, which `problem.centrode`
    works out. `refer` takes the names among the arguments and a reader. `by_changes` says
    whether it is read off the changes of rates, and not only off rates.
    """

    example: str
    slots: tuple[Slot, ...]
    gives: Kind
    by_changes: bool
    read: Callable[..., Any] | None
    refer: Callable[[Sequence[str], MotionReader], References]
    derivation: Derivation
    optional: int = 0

    @property
    def signature(self) -> Signature:
        """What it takes and gives."""
        needed = len(self.slots) - self.optional
        return Signature(self.slots, needed, lambda name, kinds: self.gives, self.example)

    @property
    def level(self) -> Level | None:
        """Whether its value is a velocity or an acceleration, by its dimension; None for a
        place.
        """
        dimension = self.gives.dimension if isinstance(self.gives, Scalar | Arrow) else None
        return None if dimension is None else _LEVELS.get(dimension.time)
