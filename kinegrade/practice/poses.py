"""The positions of a mechanism over its cycle, as few and as short numbers as show them truly: the
script of a practice sheet interpolates between them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from kinegrade.cycles.curves import Curve
from kinegrade.cycles.cycle import measure_extremes
from kinegrade.cycles.graph import convert_displacements
from kinegrade.cycles.tracing import CurveTracer
from kinegrade.motion.path import Array, MotionPath
from kinegrade.practice.sampling import PoseTable, choose_poses
from kinegrade.practice.skeleton import list_circles, list_marked
from kinegrade.practice.together import find_together
from kinegrade.problem.solution import Solution

WIDTH, HEIGHT, MARGIN = 110.0, 84.0, 13.0  # millimetres
FINE = 4000  # steps of a millimetre
CURVE_STEPS = 1000  # between the least and the greatest value of a curve
_MOVED_STEPS = 200_000  # of the whole way of the input
_DENSE = 721  # positions from which the extremes of curves are read
_ORDER = 4  # of the differences by which positions are written
_NOTHING = 1e-9  # of a curve's greatest value


@dataclass(frozen=True)
class PracticeMotion:
    """The positions of a draw: for each point x and y, then two points for each guide, rounded to
    the `FINE`th part of a millimetre, y downwards, each a text of its differences; a coordinate
    that stays is one number. Of a point that goes with two others, x is "=" and how (`Together`),
    y "=".

    `moved` is how far the input has gone, in parts of `low` to `high`, `speed` and `acceleration`
    those given; `radii` are in mm; `poles` is false where positions are
    too few to tell velocity poles. `curves` are for some asks the least and greatest value, the
    parts between, and after how many positions there is no value.
    """

    closed: bool
    poles: bool
    width: float
    height: float
    low: float
    high: float
    moved: str
    speed: float
    acceleration: float
    radii: tuple[float, ...]
    coordinates: tuple[str, ...]
    curves: tuple[tuple[float, float, str, tuple[float, ...]], ...]


@dataclass(frozen=True)
class _Window:
    """The part of the plane that is drawn, in m, and its scale."""

    left: float
    right: float
    bottom: float
    top: float

    @property
    def scale(self) -> float:
        """Millimetres of a metre."""
        across, upward = max(self.right - self.left, 1e-9), max(self.top - self.bottom, 1e-9)
        return min((WIDTH - 2 * MARGIN) / across, (HEIGHT - 2 * MARGIN) / upward)

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the drawing, mm."""
        across = (self.right - self.left) * self.scale + 2 * MARGIN
        return round(across, 2), round((self.top - self.bottom) * self.scale + 2 * MARGIN, 2)

    def project(self, places: Array) -> Array:
        """Rows of x and y in mm, y downwards."""
        across = (places[0::2] - self.left) * self.scale + MARGIN
        down = (self.top - places[1::2]) * self.scale + MARGIN
        return np.stack([across, down], axis=1).reshape(places.shape)


def write_motion(path: MotionPath, solution: Solution, asks: tuple[str, ...]) -> PracticeMotion:
    """The motion of a draw, with the curves of these asks."""
    table, window = frame_poses(path)
    # All of a turn, though its last position is the first again: the script goes on from there
    low, high = path.bounds if path.is_closed else (table.moved.min(), table.moved.max())
    shown = convert_displacements(path, np.array([low, high, *_find_given_rates(path)]))
    width, height = window.size
    rows = np.concatenate([table.places, table.marks])
    circles = list_circles(path.motion.frames.mechanism)
    return PracticeMotion(
        closed=path.is_closed,
        poles=table.tells_poles,
        width=width,
        height=height,
        low=float(shown[0]),
        high=float(shown[1]),
        moved=_write_differences((table.moved - low) / (high - low) * _MOVED_STEPS),
        speed=float(shown[2]),
        acceleration=float(shown[3]),
        radii=tuple(round(float(each.radius) * window.scale, 2) for each in circles),
        coordinates=tuple(_write_places(window.project(rows) * FINE, path)),
        curves=tuple(_write_curves(solution, table, asks)),
    )


def _write_places(steps: Array, path: MotionPath) -> Iterator[str]:
    """x and y of all places. Those by which poles are found are written themselves, as exactly as
    the script takes them to be.
    """
    kept = {place for pair in list_marked(path).values() for place in pair}
    together = find_together(steps, kept)
    for number in range(len(steps) // 2):
        if number in together:
            yield from (f"={together[number]}", "=")
        else:
            yield from map(_write_differences, steps[2 * number : 2 * number + 2])


def frame_poses(path: MotionPath) -> tuple[PoseTable, _Window]:
    """The positions that are baked, and the window that holds all of them."""
    table = choose_poses(path)
    mechanism = path.motion.frames.mechanism
    order = {name: 2 * place for place, name in enumerate(mechanism.points)}
    across, upward = [table.places[0::2].ravel()], [table.places[1::2].ravel()]
    for circle in list_circles(mechanism):
        row, radius = order[circle.centre], float(circle.radius)
        across += [table.places[row] - radius, table.places[row] + radius]
        upward += [table.places[row + 1] - radius, table.places[row + 1] + radius]
    x, y = np.concatenate(across), np.concatenate(upward)
    return table, _Window(float(x.min()), float(x.max()), float(y.min()), float(y.max()))


def _find_given_rates(path: MotionPath) -> tuple[float, float]:
    """The velocity and the acceleration that are given for the leading driver."""
    drivers = path.motion.frames.mechanism.drivers
    stated = path.motion.frames.relations[-len(drivers) :][drivers.index(path.input.leading)]
    return float(stated.velocity), float(stated.acceleration)


def _write_curves(
    solution: Solution, table: PoseTable, asks: tuple[str, ...]
) -> Iterator[tuple[float, float, str, tuple[float, ...]]]:
    """The curves at the positions, between extremes of positions that lie much closer; what grows
    beyond bounds is cut off.
    """
    path = table.placement.path
    tracer = CurveTracer(solution, path, asks)
    coarse = tracer.trace(table.placement)
    fine = tracer.trace(path.place(tracer.add_gaps(_spread_finely(table))))
    extremes = measure_extremes(solution, path, fine)
    for curve, dense in zip(coarse, fine, strict=True):
        low, high = dense.usual
        bounds = 2 * low - high, 2 * high - low
        known = np.clip(np.nan_to_num(dense.values, nan=high), *bounds)
        ends = [each.value for each in extremes.get(dense.ask.name, ())]
        least, most = min([float(known.min()), *ends]), max([float(known.max()), *ends])
        values = np.clip(np.nan_to_num(curve.values, nan=high), least, most)
        width, size = most - least, max(abs(least), abs(most))
        steps = (values - least) / width if width > _NOTHING * size else np.zeros(len(values))
        low, high = (0.0 if abs(end) <= _NOTHING * size else end for end in (least, most))
        written = _write_differences(steps * CURVE_STEPS)
        gaps = tuple(_place_gaps(curve, path))
        yield float(f"{low:.4g}"), float(f"{high:.4g}"), written, gaps


def _place_gaps(curve: Curve, path: MotionPath) -> Iterator[float]:
    """After how many positions each gap is; that of a position which has no value itself."""
    moved = np.append(curve.moved, path.bounds[1]) if path.is_closed else curve.moved
    for gap in curve.gaps:
        if moved[0] < gap.displacement < moved[-1]:
            place = float(np.interp(gap.displacement, moved, np.arange(len(moved))))
            nearest = min(round(place), len(curve.values) - 1)
            yield float(nearest) if np.isnan(curve.values[nearest]) else round(place, 3)


def _spread_finely(table: PoseTable) -> Array:
    """Displacements between those of the positions as well, and up to the end of a full cycle."""
    path = table.placement.path
    moved = np.append(table.moved, path.bounds[1]) if path.is_closed else table.moved
    places = np.arange(len(moved))
    dense = np.linspace(0, places[-1], max(_DENSE, 2 * len(moved)))
    return np.asarray(np.interp(dense, places, moved))


def _write_differences(values: Array) -> str:
    """The first value and the first differences of each order below the last, then all of that
    order, which are small where values change smoothly; a single number where they are all equal.
    """
    rest = np.rint(values).astype(int)
    if not np.ptp(rest):
        return str(rest[0])
    first: list[int] = []
    for _ in range(min(_ORDER, len(rest) - 1)):
        first.append(int(rest[0]))
        rest = np.diff(rest)
    return " ".join(map(str, (*first, *rest.tolist())))
