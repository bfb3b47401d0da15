"""The figure of a mechanism at many positions of its cycle: a drawing of each, all in one frame and
to one scale.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import starmap

import numpy as np

from kinegrade.cycles.centrode_drawing import draw_centrodes
from kinegrade.cycles.cycle import Cycle
from kinegrade.figure.marks.names import label_points, write_point_symbol
from kinegrade.figure.mechanism.layers import draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.scene import (
    Box,
    Outline,
    Pen,
    Primitive,
    find_common_box,
    move,
)
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.motion.path import Array, MotionPath
from kinegrade.motion.placing import find_carriers
from kinegrade.numbers.number import Number
from kinegrade.problem.template.hints import FigureHints

WIDTH, HEIGHT = 120.0, 90.0  # millimetres
WIDEST, HIGHEST = 158.0, 138.0  # millimetres, with centrodes
_ROOM = 30.0  # millimetres for these on each side
_SURROUND = 16.0  # millimetres that symbols take beside the mechanism
_A_TURN = 72  # positions
_FEW = 36  # positions of each turn where there are several
_MOST = 216
_FAR = 1.6  # sizes of the mechanism that a part may go before the drawing is cut off
_FINE = 601  # positions of the points' ways
_SEEN = 0.5  # millimetres: a way that is shorter is not drawn
_TRACE = Pen(0.18, "dashed")


@dataclass(frozen=True)
class MovingFigure:
    """Drawings of a mechanism, each a list of primitives in millimetres from the lower left corner
    of one frame; `still` is what none of them changes.

    `moved` is how far the input has gone in each, rad or m, `first` the number of the instant;
    where it is `closed`, the first follows upon the last.
    """

    width: float
    height: float
    still: tuple[Primitive, ...]
    drawings: tuple[tuple[Primitive, ...], ...]
    moved: tuple[float, ...]
    first: int
    closed: bool

    @property
    def at_instant(self) -> tuple[Primitive, ...]:
        """All of the drawing of the instant."""
        return (*self.still, *self.drawings[self.first])


def draw_cycle(cycle: Cycle) -> MovingFigure:
    """The figure of a cycle."""
    hints = cycle.solution.template.figure
    return draw_moving_figure(cycle.path, hints, centrodes=cycle.centrodes)


def draw_moving_figure(
    path: MotionPath, hints: FigureHints, *, centrodes: bool = False
) -> MovingFigure:
    """The figure at positions along the path, with centrodes or without; where a part goes far
    away, of those nearby.
    """
    moved = _choose_displacements(path)
    places = path.place(moved).frames.mechanism
    mechanisms = [_take(places, number, moved.shape) for number in range(len(moved))]
    scale = _choose_scale(mechanisms)
    first = int(np.argmin(np.abs(moved)))
    letters = _place_letters(scale_to_paper(mechanisms[first], scale), hints)
    drawn = [_draw(scale_to_paper(each, scale), hints, letters) for each in mechanisms]
    traces = _trace_points(path, moved, scale)
    box = find_common_box([*traces, *(part for parts in drawn for part in parts)])
    if centrodes:
        box = _widen(box)
        added = draw_centrodes(path, moved, scale, box)
        traces += added.still
        drawn = [(*parts, *each) for parts, each in zip(drawn, added.moving, strict=True)]
    still, drawings = _separate(drawn)
    corner = Vector(1.0 - box.left, 1.0 - box.bottom)
    return MovingFigure(
        box.width + 2,
        box.height + 2,
        tuple(move(part, corner) for part in (*traces, *still)),
        tuple(tuple(move(part, corner) for part in parts) for parts in drawings),
        tuple(moved.tolist()),
        first,
        path.is_closed,
    )


def _choose_displacements(path: MotionPath) -> Array:
    """The displacements that are drawn, the instant among them."""
    low, high = path.bounds
    turns = round((high - low) / path.input.period) if path.input.period else 1
    count = _A_TURN if turns <= 1 else min(_MOST, _FEW * turns)
    moved = np.unique(np.append(path.spread(count + 1), 0.0))
    return moved[:-1] if path.is_closed else _select_near(path, moved)


def _select_near(path: MotionPath, moved: Array) -> Array:
    """The displacements about the instant at which no part has gone far away."""
    points = path.place(moved).frames.mechanism.points.values()
    start = path.motion.points.values()
    ways = [
        np.hypot(*np.broadcast_arrays(now.x - then.x, now.y - then.y, moved)[:2])
        for now, then in zip(points, start, strict=True)
    ]
    far = moved[np.array(ways).max(axis=0) > _FAR * path.size]
    before, after = far[far < 0].max(initial=-np.inf), far[far > 0].min(initial=np.inf)
    return np.asarray(moved[(moved > before) & (moved < after)])


def _take(mechanism: Mechanism, number: int, shape: tuple[int, ...]) -> Mechanism:
    """The mechanism at one position."""

    def take(value: Number) -> Number:
        return float(np.broadcast_to(np.asarray(value, dtype=float), shape)[number])

    return mechanism.map(take)


def _choose_scale(mechanisms: list[Mechanism]) -> float:
    """Millimetres on paper per metre."""
    places = [place for each in mechanisms for place in each.points.values()]
    radii = [circle.radius for joint in mechanisms[0].joints for circle in joint.list_circles()]
    reach = 2 * max(radii, default=0.0)
    wide = max(place.x for place in places) - min(place.x for place in places) + reach
    high = max(place.y for place in places) - min(place.y for place in places) + reach
    across, upward = (WIDTH - _SURROUND) / max(wide, 1e-9), (HEIGHT - _SURROUND) / max(high, 1e-9)
    return float(min(across, upward))


def _place_letters(paper: Mechanism, hints: FigureHints) -> dict[str, Primitive]:
    """The labels of points, placed as in a figure, each about its point as the origin."""
    drawing = draw(paper, hints)
    layout = Layout.of(drawing.primitives).written(label_points(paper, hints, drawing))
    symbols = {
        hints.labels.get(name, write_point_symbol(name)): name for name in find_carriers(paper)
    }
    return {
        name: move(label, -paper.points[name])
        for label in layout.labels
        if (name := symbols.get(label.symbol)) is not None
    }


def _draw(
    paper: Mechanism, hints: FigureHints, letters: dict[str, Primitive]
) -> tuple[Primitive, ...]:
    """The mechanism and the letters of its points."""
    labels = [move(label, paper.points[name]) for name, label in letters.items()]
    return (*draw(paper, hints).primitives, *labels)


def _trace_points(path: MotionPath, moved: Array, scale: float) -> list[Primitive]:
    """The ways of the points that move with bodies, over what is drawn."""
    fine = path.spread(_FINE) if path.is_closed else np.linspace(moved[0], moved[-1], _FINE)
    points = path.place(fine).frames.mechanism.points
    traces: list[Primitive] = []
    for name in find_carriers(path.motion.frames.mechanism):
        across, upward = np.broadcast_arrays(points[name].x, points[name].y, fine)[:2]
        if max(np.ptp(across), np.ptp(upward)) * scale > _SEEN:
            corners = zip((across * scale).tolist(), (upward * scale).tolist(), strict=True)
            traces.append(Outline(tuple(starmap(Vector, corners)), _TRACE, closed=False))
    return traces


def _widen(box: Box) -> Box:
    """A frame with room for centrodes beside the mechanism."""
    across, upward = min(_ROOM, (WIDEST - box.width) / 2), min(_ROOM, (HIGHEST - box.height) / 2)
    return Box(box.left - across, box.bottom - upward, box.right + across, box.top + upward)


def _separate(
    drawn: list[tuple[Primitive, ...]],
) -> tuple[tuple[Primitive, ...], list[tuple[Primitive, ...]]]:
    """What is the same in all drawings before anything that is not, and the rest of each."""
    count = 0
    while all(len(parts) > count and parts[count] == drawn[0][count] for parts in drawn):
        count += 1
    return drawn[0][:count], [parts[count:] for parts in drawn]
