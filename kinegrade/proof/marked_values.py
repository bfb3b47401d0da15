"""Dimensions, radii and angles of a figure that carry the letter of a given and show another
value: the distance of other points, another wheel, the angle beside it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from math import acos, cos, degrees, pi, radians

from kinegrade.figure.marks.lengths.measured_direction import find_measured_direction
from kinegrade.figure.marks.sweep import find_sweep
from kinegrade.figure.placing.mark import direction
from kinegrade.figure.plane import angle_of, length
from kinegrade.language.math.reading import read_math
from kinegrade.language.message import Fault, Message
from kinegrade.numbers.floats import Floats
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.given_marks import mark_givens
from kinegrade.problem.template.hints import Angle, Length, Radius
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.problem.template.texts import find_unsigned_givens

_DIFFERENT = 1e-6  # of a length, or of a cosine: less is what doubles leave
_SEEN = 0.01  # radians by which an arc may be off: a cosine shows no less about half a turn


@dataclass(frozen=True)
class _Instance:
    """An instance in doubles: SI units and radians."""

    solution: Solution

    def value(self, given: Parameter) -> float:
        """The value of a given."""
        stated = self.solution.parameters[given.name].value
        measure = given.unit
        return radians(stated) if measure.degrees else stated * Floats().scale(measure.scale)

    def distance(self, _: float, mark: Length) -> float:
        """What a dimension measures."""
        at = self.solution.doubles.points
        start, end = at[mark.start], at[mark.end]
        along = find_measured_direction(mark.along, start, end)
        return float(abs((end - start).dot(along)))

    def nearest_radius(self, stated: float, mark: Radius) -> float:
        """The radius nearest to a stated one; that itself where there is no circle to measure."""
        radii = self._list_radii(mark)
        return min(radii, key=lambda radius: abs(radius - stated), default=stated)

    def _list_radii(self, mark: Radius) -> list[float]:
        """The radii of the circles about a centre, those of its joints and of the figure."""
        mechanism, at = self.solution.assembly.mechanism.map(float), self.solution.doubles.points
        circles = [each for joint in mechanism.joints for each in joint.list_circles()]
        rims = (
            each for each in self.solution.template.figure.circles if each.centre == mark.centre
        )
        drawn = (length(at[each.through] - at[each.centre]) for each in rims)
        return [*(each.radius for each in circles if each.centre == mark.centre), *drawn]

    def rotation(self, mark: Angle) -> float:
        """The rotation that an arc shows."""
        at = self.solution.doubles.points
        first, last = (direction(at, at[mark.at], name) for name in (mark.start, mark.end))
        return find_sweep(mark, angle_of(last) - angle_of(first))

    def printed_rotation(self, given: Parameter) -> float:
        """The size of a given angle as statements print it."""
        if given.name in find_unsigned_givens(self.solution.template):
            return radians(self.solution.parameters[given.name].size.value)
        return abs(self.value(given))


def find_wrong_marks(template: Template, examples: Iterable[Solution]) -> Iterator[Fault]:
    """A fault for each length, radius and angle of the figure that carries the symbol of a given
    and has another value in any of these instances.
    """
    instances = tuple(map(_Instance, examples))
    for distance in template.figure.lengths:
        given = _find_given(template, distance.symbol)
        if given is not None and given.unit.is_length:
            place = f"{distance.start}{distance.end}"
            measure = partial(_Instance.distance, mark=distance)
            yield from _find_wrong_size(place, given, instances, measure)
    for radius in template.figure.radii:
        given = _find_given(template, radius.symbol)
        if given is not None and given.unit.is_length:
            nearest = partial(_Instance.nearest_radius, mark=radius)
            yield from _find_wrong_size(radius.centre, given, instances, nearest)
    for angle in mark_givens(template).angles:
        given = _find_given(template, angle.symbol)
        if given is not None and given.unit.angle and not given.unit.time:
            yield from _find_wrong_angle(angle, given, instances)


def _find_given(template: Template, symbol: str) -> Parameter | None:
    """The given that has a symbol, if one alone has it."""
    wanted = read_math(symbol, "figure")
    givens = template.parameters.values()
    found = [each for each in givens if read_math(each.symbol, "figure") == wanted]
    return found[0] if len(found) == 1 else None


def _find_wrong_size(
    place: str,
    given: Parameter,
    instances: Iterable[_Instance],
    measure: Callable[[_Instance, float], float],
) -> Iterator[Fault]:
    """A fault at the first instance in which what stands at a place is not as large as its letter
    says; `measure` gives its size where the stated one is known.
    """
    scale = Floats().scale(given.unit.scale)
    for each in instances:
        stated = abs(each.value(given))
        shown = measure(each, stated)
        if abs(shown - stated) > _DIFFERENT * stated:
            yield _explain(given, place, shown / scale, stated / scale)
            return


def _find_wrong_angle(
    mark: Angle, given: Parameter, instances: Iterable[_Instance]
) -> Iterator[Fault]:
    """A fault at the first instance in which the angle of an arc is not that of its letter, with
    any sign and number of turns; where the sides are right but not the way from one to the other,
    the angle of the arc itself.
    """
    measured = f"{mark.start}, {mark.at}, {mark.end}"
    for each in instances:
        stated, shown = each.value(given), each.rotation(mark)
        if abs(cos(shown) - cos(stated)) > _DIFFERENT:
            between = (degrees(acos(cos(angle))) for angle in (shown, stated))
            yield _explain(given, measured, *between)
            return
        printed = each.printed_rotation(given)
        if abs(shown) and printed <= 2 * pi and abs(abs(shown) - printed) > _SEEN:
            yield _explain(given, measured, degrees(abs(shown)), degrees(printed))
            return


def _explain(given: Parameter, measured: str, shown: float, stated: float) -> Fault:
    shown_in = "°" if given.unit.angle else f" {given.unit.printed}"
    what = Message(
        "template.marks-another",
        name=given.name,
        measured=measured,
        shown=f"{shown:.4g}{shown_in}",
        stated=f"{stated:.4g}{shown_in}",
    )
    return Fault("figure", what, do=Message("template.mark-its-own"))
