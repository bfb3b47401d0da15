"""The positions of the points at the instant described."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy

from tests.description.reader.deferred import Deferred, Points
from tests.description.reader.description import Description
from tests.description.reader.geometry import NoCommonPoint

STARTS = 60
STEPS = 60
TOLERANCE = 1e-9
Function = Callable[[numpy.ndarray], numpy.ndarray]
MISSED = (NoCommonPoint, ZeroDivisionError, ValueError, OverflowError)


class NotPlaced(ValueError):
    """Positions that do not follow from the sentences, or contradict them."""


@dataclass
class Layout:
    """The order of construction, and the points that no sentence constructs."""

    order: list[tuple[str, Deferred[complex]]]
    checks: list[tuple[str, Deferred[complex]]]
    free: list[str]

    def drawn(self, values: numpy.ndarray) -> dict[str, complex]:
        """All points, the free ones at the given coordinates."""
        points = {
            name: complex(values[2 * place], values[2 * place + 1])
            for place, name in enumerate(self.free)
        }
        for name, place in self.order:
            points[name] = complex(place.at(points))
        return points


def layout_of(description: Description) -> Layout:
    """Which points are constructed in which order, and which remain to be found."""
    waiting: dict[str, Deferred[complex]] = {}
    checks: list[tuple[str, Deferred[complex]]] = []
    for construction in description.constructions:
        if construction.name in waiting:
            checks.append((construction.name, construction.place))
        else:
            waiting[construction.name] = construction.place
    free = sorted(description.points() - set(waiting))
    order: list[tuple[str, Deferred[complex]]] = []
    there = set(free)
    while waiting:
        ready = [name for name, place in waiting.items() if place.needs <= there]
        if ready:
            order.extend((name, waiting.pop(name)) for name in ready)
            there.update(ready)
        else:
            name, place = waiting.popitem()
            checks.append((name, place))
            free.append(name)
            there.add(name)
    return Layout(order, checks, free)


def positions_of(description: Description) -> dict[str, complex]:
    """The one set of positions that meets every sentence."""
    layout = layout_of(description)
    scale = scale_of(description)
    if not layout.free:
        points = layout.drawn(numpy.zeros(0))
        complain(description, layout, points, scale)
        return points
    found = solutions(description, layout, scale)
    if len(found) != 1:
        about = description.about(layout.free)
        raise NotPlaced(f"{len(found)} positions, where one should be, meet: {about}")
    return found[0]


def scale_of(description: Description) -> float:
    """A length of the size of the mechanism."""
    return max(description.words.lengths, default=1.0)


def gaps(description: Description, layout: Layout, points: Points) -> list[float]:
    """All lengths that vanish where every sentence is true."""
    found = [equation.gap.at(points) for equation in description.equations]
    for joint in description.joints:
        found += joint.gaps(points)
    for name, place in layout.checks:
        apart = place.at(points) - points[name]
        found += [apart.real, apart.imag]
    return found


def complain(description: Description, layout: Layout, points: Points, scale: float) -> None:
    """Raises an error where the positions contradict a sentence."""
    for gap in gaps(description, layout, points):
        if abs(gap) > 1e-8 * scale:
            raise NotPlaced(f"the positions leave a gap of {gap:.6g} m")
    for side in description.sides:
        if side.margin.at(points) <= 0:
            raise NotPlaced("a point is not on the side that is told")


def solutions(description: Description, layout: Layout, scale: float) -> list[dict[str, complex]]:
    """All positions found from many starts that meet every sentence."""
    random = numpy.random.default_rng(1)
    found: list[dict[str, complex]] = []
    for _ in range(STARTS):
        start = scale * random.normal(size=2 * len(layout.free)) * random.choice([0.3, 1.0, 2.0])
        points = descended(description, layout, start, scale)
        if points is None or not on_its_sides(description, points):
            continue
        if all(difference(points, other) > 1e-6 * scale for other in found):
            found.append(points)
    return found


def on_its_sides(description: Description, points: Points) -> bool:
    """Whether every point is on the sides that are told."""
    return all(side.margin.at(points) > 0 for side in description.sides)


def difference(first: Points, second: Points) -> float:
    """How far apart two sets of positions are."""
    return max(abs(first[name] - second[name]) for name in first)


def descended(
    description: Description, layout: Layout, start: numpy.ndarray, scale: float
) -> dict[str, complex] | None:
    """Positions near the start at which all gaps vanish, by Newton's method."""

    def residual(values: numpy.ndarray) -> numpy.ndarray:
        return numpy.array(gaps(description, layout, layout.drawn(values)))

    values = start
    try:
        for _ in range(STEPS):
            missing = residual(values)
            slopes = jacobian(residual, values, scale)
            step = numpy.linalg.lstsq(slopes, -missing, rcond=None)[0]
            length = float(numpy.linalg.norm(step))
            values = values + step * min(1.0, scale / max(length, 1e-300))
            if length < 1e-14 * scale:
                break
        if numpy.max(numpy.abs(residual(values))) > TOLERANCE * scale:
            return None
        if numpy.linalg.matrix_rank(jacobian(residual, values, scale), 1e-6) < values.size:
            return None
        return layout.drawn(values)
    except (*MISSED, numpy.linalg.LinAlgError):
        return None


def jacobian(function: Function, values: numpy.ndarray, scale: float) -> numpy.ndarray:
    """The slopes of the gaps, by central differences."""
    step = 1e-6 * scale
    columns = []
    for place in range(values.size):
        change = numpy.zeros(values.size)
        change[place] = step
        columns.append((function(values + change) - function(values - change)) / (2 * step))
    return numpy.array(columns).T
