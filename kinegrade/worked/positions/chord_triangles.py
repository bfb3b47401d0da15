"""The triangle in which a line through a point meets a circle: two sides are known and the angle
opposite the larger one, so the law of sines gives the angle at the common point.
"""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.expressions.tree import Call, Expression, Name
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.worked.findings import Seen
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.functions import Function
from kinegrade.worked.formulas.symbols import join_letters, name_quantity
from kinegrade.worked.positions.algebra import (
    Pair,
    cross,
    dot,
    make_positive,
    minus,
    over,
    plus,
    square,
)
from kinegrade.worked.positions.instance import DEGREE, PURE, Instance
from kinegrade.worked.positions.right_angles import make_unit

_LETTERS = ("delta", "epsilon", "eta")


@dataclass(frozen=True)
class ChordTriangle:
    """The triangle of a line's start, a circle's centre and the point in which both meet, with the
    angle at this one as a quantity of the instance.
    """

    corners: tuple[str, str, str]  # the start, the centre, the common point
    name: str
    sine: Expression
    instance: Instance

    @property
    def side(self) -> Symbol:
        """The side along the line, in its letters."""
        start, _, end = self.corners
        return join_letters((self.instance.symbols[start], self.instance.symbols[end]))

    def explain(self) -> Message:
        """What gives the angle, and then the side along the line."""
        names = zip(
            ("start", "centre", "point"), map(self.instance.letter, self.corners), strict=True
        )
        angle = self.instance.case.text(self.instance.symbols[self.name])
        return Message("solution.chord-triangle", **dict(names), angle=angle)

    def solve(self) -> tuple[Row, ...]:
        """The angle by its sine."""
        angle = self.instance.symbols[self.name]
        return (
            *self.instance.equation(Function("sin", angle), self.sine, PURE),
            *self.instance.equation(angle, Name(self.name), DEGREE),
        )


def find_triangle(
    point: str, line: Call, circle: Call, away: Pair, instance: Instance
) -> ChordTriangle | None:
    """The triangle, where the line is given by an angle and by its point, which lies within the
    circle and not at its centre; `away` leads from this point to the centre.
    """
    (start, direction), (centre, radius) = line.arguments, circle.arguments
    if not (isinstance(start, Name) and isinstance(centre, Name)):
        return None
    if isinstance(direction, Call) or instance.axes.is_vector(direction):
        return None
    apart = cross(away, make_unit(direction))
    side = instance.sign(apart)
    if not side or instance.sign(minus(square(radius), dot(away, away))) <= 0:
        return None
    sine = over(make_positive(apart, side), radius)
    value, name = instance.value(Call("asin", (sine,))), _choose_letter(instance)
    opened = instance.named(name, name_quantity(name), value)
    turned = (plus if side > 0 else minus)(direction, Name(name))
    seen = Seen(turned, name, opened.symbols[name], value)
    instance.case.findings.seen[centre, Name(point)] = seen
    return ChordTriangle((start.name, centre.name, point), name, sine, opened)


def _choose_letter(instance: Instance) -> str:
    """A Greek letter that the template uses for nothing else."""
    taken = {symbol.row for symbol in instance.symbols.values()}
    letters = (one for one in _LETTERS if name_quantity(one).row not in taken)
    return instance.free(next(letters, _LETTERS[0]))
