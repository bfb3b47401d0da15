"""The figure of a mechanism at many positions of its cycle: a drawing of each, all in one frame and
to one scale.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import starmap
from types import MappingProxyType

import numpy as np

from kinegrade.cycles.centrode_drawing import (
    TracedCentrodes,
    draw_centrodes,
    draw_curves,
    trace_drawn_centrodes,
)
from kinegrade.cycles.centrodes import find_poled_bodies
from kinegrade.cycles.cycle import Cycle
from kinegrade.cycles.frame import (
    HEIGHT,
    HIGHEST,
    WIDEST,
    WIDTH,
    choose_scale,
    enclose,
    find_extent,
    scale_box,
    widen,
)
from kinegrade.figure.marks.names import label_point, label_points, write_point_symbol
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
from kinegrade.problem.pole_names import name_poles
from kinegrade.problem.template.hints import FigureHints

_A_TURN = 72  # positions
_FEW = 36  # positions of each turn where there are several
_MOST = 216
_FAR = 2.2  # sizes of the mechanism that a part may go before the drawing is cut; a crank goes 2
_FINE = 601  # positions of the points' ways
_SEEN = 0.5  # millimetres: a way that is shorter is not drawn
_TRACE = Pen(0.18, "dashed")
NO_POLES: Mapping[str, str] = MappingProxyType({})


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
    template = cycle.solution.template
    poled = find_poled_bodies(cycle.path) if cycle.centrodes else ()
    return draw_moving_figure(cycle.path, template.figure, name_poles(poled, template))


def draw_moving_figure(
    path: MotionPath, hints: FigureHints, poles: Mapping[str, str] = NO_POLES
) -> MovingFigure:
    """The figure at positions along the path; where a part goes far away, of those nearby. With
    names for poles, by body, it shows these and the centrodes.
    """
    moved = _choose_displacements(path)
    places = path.place(moved).frames.mechanism
    mechanisms = [_take(places, number, moved.shape) for number in range(len(moved))]
    first = int(np.argmin(np.abs(moved)))
    traced = trace_drawn_centrodes(path, moved, tuple(poles))
    scale, frame = _choose_frame(find_extent(mechanisms), traced)
    seen = traced.find_poles(first, scale, frame)
    now = scale_to_paper(mechanisms[first], scale)
    traces = _trace_points(path, moved, scale)
    named = {poles[body]: place for body, place in seen.items()}
    ways = (*traces, *draw_curves(traced, first, scale, frame))
    letters = _place_letters(now, hints, named, ways)
    marks = {body: letters[name] for body, name in poles.items() if name in letters}
    centrodes = draw_centrodes(traced, scale, frame, marks)
    drawn = [
        (*_draw(scale_to_paper(each, scale), hints, letters), *beside)
        for each, beside in zip(mechanisms, centrodes.moving, strict=True)
    ]
    return _frame((*traces, *centrodes.still), drawn, moved, first, path.is_closed)


def _choose_frame(extent: Box, traced: TracedCentrodes) -> tuple[float, Box]:
    """Millimetres per metre, and within which millimetres centrodes are shown."""
    near = widen(extent)
    limits = (WIDEST, HIGHEST) if traced.bodies else (WIDTH, HEIGHT)
    scale = choose_scale(enclose(extent, near, traced.curves), *limits)
    return scale, scale_box(near, scale)


def _frame(
    traces: tuple[Primitive, ...],
    drawn: list[tuple[Primitive, ...]],
    moved: Array,
    first: int,
    closed: bool,
) -> MovingFigure:
    """The figure from what stays and what each position has, moved into a frame around all."""
    box = find_common_box([*traces, *(part for parts in drawn for part in parts)])
    still, drawings = _separate(drawn)
    corner = Vector(1.0 - box.left, 1.0 - box.bottom)
    return MovingFigure(
        box.width + 2,
        box.height + 2,
        tuple(move(part, corner) for part in (*traces, *still)),
        tuple(tuple(move(part, corner) for part in parts) for parts in drawings),
        tuple(moved.tolist()),
        first,
        closed,
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


def _place_letters(
    paper: Mechanism, hints: FigureHints, poles: Mapping[str, Vector], ways: Sequence[Primitive]
) -> dict[str, Primitive]:
    """The letters of points that move and of poles, by name, placed as in a figure and off the ways
    of points, each about its point as the origin.
    """
    drawing = draw(paper, hints)
    named = {name: paper.points[name] for name in find_carriers(paper)}
    others = {name: place for name, place in poles.items() if name not in paper.points}
    around = (*paper.points.values(), *others.values())
    wishes = (
        label_point(write_point_symbol(name), place, drawing, around)
        for name, place in others.items()
    )
    layout = Layout.of((*drawing.primitives, *ways))
    layout = layout.written((*label_points(paper, hints, drawing), *wishes))
    places = {
        hints.labels.get(name, write_point_symbol(name)): (name, place)
        for name, place in (named | others).items()
    }
    return {
        places[label.symbol][0]: move(label, -places[label.symbol][1])
        for label in layout.labels
        if label.symbol in places
    }


def _draw(
    paper: Mechanism, hints: FigureHints, letters: Mapping[str, Primitive]
) -> tuple[Primitive, ...]:
    """The mechanism and the letters of its points."""
    labels = (
        move(label, paper.points[name]) for name, label in letters.items() if name in paper.points
    )
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


def _separate(
    drawn: list[tuple[Primitive, ...]],
) -> tuple[tuple[Primitive, ...], list[tuple[Primitive, ...]]]:
    """What is the same in all drawings before anything that is not, and the rest of each."""
    count = 0
    while all(len(parts) > count and parts[count] == drawn[0][count] for parts in drawn):
        count += 1
    return drawn[0][:count], [parts[count:] for parts in drawn]
