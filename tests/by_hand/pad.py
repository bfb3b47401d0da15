"""What a student has: a paper with given values, a pad to work on, and answers to type.

Nothing here, and nothing in `students/`, knows the program: mechanics is written from the textbook.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import cos, radians, sin, sqrt
from typing import NamedTuple

EXACT = 17  # significant digits that hold every float
FACTORS = (1.3, 0.7, -1.0, 3.0)  # own wrong values, as multiples of the right ones
SIZES = (1.3, 0.7, 3.0)  # the same for what has no sign

Givens = Mapping[str, float]  # parameters by name, in the units that are printed
Answers = Mapping[str, float]  # by the name of the ask, in its unit


class Pad:
    """A pad on which every value is written down with so many significant figures.

    >>> pad = Pad(3)
    >>> pad(2 / 3), pad(-1234.5)
    (0.667, -1230.0)
    """

    def __init__(self, figures: int) -> None:
        self.figures = figures

    def __call__(self, value: float) -> float:
        """The value as it stands on the pad."""
        return float(f"{value:.{self.figures}g}")

    def sin(self, degrees: float) -> float:
        """The sine of an angle in degrees, written down."""
        return self(sin(radians(degrees)))

    def cos(self, degrees: float) -> float:
        """The cosine of an angle in degrees, written down."""
        return self(cos(radians(degrees)))

    def angle(self, degrees: float) -> float:
        """An angle of which the acute one with the same line is written down.

        >>> Pad(3).angle(153.43), Pad(3).angle(-12.345)
        (153.4, -12.3)
        """
        half_turns = 180 * round(degrees / 180)
        return half_turns + self(degrees - half_turns)

    def root(self, square: float) -> float:
        """The square root, written down."""
        return self(sqrt(square))

    @classmethod
    def exact(cls) -> Pad:
        """A pad for students who write all figures of their machine."""
        return cls(EXACT)


class Edge(NamedTuple):
    """A later ask that is worked out from an earlier one, and by which formula.

    `formula` takes the givens and the student's own value of the earlier ask, all else being
    right; `factors` are the multiples of the right value that a student may have found instead.
    """

    earlier: str
    later: str
    formula: Callable[[Givens, float], float]
    factors: tuple[float, ...] = FACTORS

    def __str__(self) -> str:
        return f"{self.earlier} -> {self.later} by {self.formula.__name__}"


Method = Callable[[Givens, Pad], Answers]
Mistake = Callable[[Givens], Answers]


def attempt(mistake: Mistake, givens: Givens) -> Answers | None:
    """What a mistake comes to; None where it leads to a figure that cannot be.

    >>> attempt(lambda givens: {"x": sqrt(givens["a"])}, {"a": -1.0})
    """
    try:
        return mistake(givens)
    except (ValueError, ZeroDivisionError):  # no such triangle
        return None
