"""From a mechanism to its figure: `sketch` is the entry point, `typst` (and its siblings) the
output.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import lru_cache, partial
from itertools import groupby
from operator import attrgetter

from kinegrade.figure.marks.angles import draw_least_legs, mark_angles
from kinegrade.figure.marks.dimensions import mark_lengths
from kinegrade.figure.marks.frames import add_axes_aside, add_frames
from kinegrade.figure.marks.imposed import drop_still
from kinegrade.figure.marks.motions import add_motions
from kinegrade.figure.marks.names import label_bodies, label_points
from kinegrade.figure.marks.radii import mark_radii
from kinegrade.figure.marks.right_angles import add_right_angle
from kinegrade.figure.marks.rotations import add_rotation
from kinegrade.figure.mechanism.fitting import HEIGHT, WIDTH, fit_scene, measure_span
from kinegrade.figure.mechanism.layers import Drawing, draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.view import crop_to_view
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.scene import Scene, find_common_box
from kinegrade.figure.similar_mechanisms import Subject, normalise_subject
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import FigureHints, Moving, Turning

_SURROUND = 14.0  # millimetres that symbols take beside the mechanism, as a first estimate
# Millimetres, across and upward, that marks and labels usually take beside the symbols
_WRITING = (4.0, 5.6)
_ARROWS = 6.6, 2.2  # millimetres that straight arrows usually take beside the symbols
_AXES = 0.0, 4.4  # millimetres that a frame of axes usually takes at the side
# Marks that fit within WRITING, and the millimetres that each further one takes
_USUAL, _FURTHER = (4, 1.2)
# Shares of the first scale that are tried in turn while a symbol has no good place, and whether
# the letters of points then come before dimension lines and straight arrows
_FURTHER_TRIES = ((1.0, True), (0.95, False), (0.88, False), (0.88, True))
Sketcher = Callable[[Mechanism, FigureHints], Scene]
_Step = Callable[[Layout], Layout]
PLAIN = FigureHints()


def sketch(mechanism: Mechanism, hints: FigureHints = PLAIN) -> Scene:
    """The figure of a mechanism whose numbers are floats in metres: to scale, within WIDTH x
    HEIGHT.

    Raises TemplateError for a hint about something that the mechanism does not have.
    """
    return size_figure(draw_unit_figure, mechanism, hints)


def size_figure(
    draw_subject: Callable[[Subject], Scene], mechanism: Mechanism, hints: FigureHints
) -> Scene:
    """The figure of a mechanism from the figure that `draw_subject` gives of it in unit size."""
    shown, size = normalise_subject(crop_to_view(mechanism, hints), hints)
    scene = draw_subject(shown)
    return replace(scene, scale=scene.scale / size)


@lru_cache(maxsize=1024)
def draw_unit_figure(shown: Subject) -> Scene:
    """The figure of a mechanism of unit size. Raises TemplateError as `sketch` does."""
    mechanism, hints = shown.mechanism, drop_still(shown.mechanism, shown.hints)
    span = measure_span(mechanism, hints)
    scale = _choose_first_scale(mechanism, hints, span)
    best = fit_scene(partial(_compose, mechanism, hints, False), scale, span)
    first = best.scale
    for share, letters_first in _FURTHER_TRIES:
        if not best.crowded:
            break
        compose = partial(_compose, mechanism, hints, letters_first)
        other = fit_scene(compose, first * share, span)
        best = min(best, other, key=lambda scene: len(scene.crowded))
    return best


def _compose(mechanism: Mechanism, hints: FigureHints, letters_first: bool, scale: float) -> Layout:
    """The mechanism, then the marks with the fewest possible places first, each placed around what
    is already there.

    Letters must stand near their points, after the marks that are bound to points (or before those
    that are bound to two) but before the radii, which may go anywhere; the name of a body may stand
    anywhere in it.
    """
    paper = scale_to_paper(mechanism, scale)
    drawing = draw(paper, hints)
    named = tuple(label_points(paper, hints, drawing))
    start = Layout.of(drawing.primitives)
    bound = _place_marks_at_points(start, paper, hints, drawing, named)
    early, late = (named, ()) if letters_first else ((), named)
    layout = _place_straight_marks(bound.written(early), paper, hints, drawing, late)
    for radius in hints.radii:
        layout = layout.marked(mark_radii(paper.points, drawing.rims, radius, layout.obstacles))
    layout = add_axes_aside(layout, hints)
    return layout.written(label_bodies(paper, hints, drawing))


def _place_marks_at_points(
    layout: Layout, paper: Mechanism, hints: FigureHints, drawing: Drawing, named: tuple[Wish, ...]
) -> Layout:
    """Marks bound to one point: frames, angles, rotations (which keep clear of the letters at their
    pivots).
    """
    for points in hints.right_angles:
        layout = add_right_angle(layout, paper.points, points, drawing)
    layout = add_frames(layout, paper.points, hints)
    legs = [draw_least_legs(paper.points, angle, drawing) for angle in hints.angles]
    for number, angle in enumerate(hints.angles, start=1):
        to_come = [line for lines in legs[number:] for line in lines]
        for arcs in mark_angles(paper.points, angle, drawing):
            layout = layout.marked(arcs, to_come)
    for given in hints.arrows:
        if isinstance(given, Turning):
            layout = add_rotation(layout, paper, given, drawing, named)
    return layout


def _place_straight_marks(
    layout: Layout, paper: Mechanism, hints: FigureHints, drawing: Drawing, named: tuple[Wish, ...]
) -> Layout:
    """Motions, distances, then the letters; distances before motions where a symbol is crowded
    otherwise.
    """
    at, mechanism_alone = paper.points, Obstacles.of(drawing.primitives)
    motions = [given for given in hints.arrows if isinstance(given, Moving)]
    arrows: list[_Step] = [
        partial(add_motions, mechanism=paper, hints=list(together), rails=drawing.rails)
        for _, together in groupby(motions, attrgetter("point"))
    ]
    lengths: list[_Step] = [
        partial(Layout.marked, alternatives=mark_lengths(at, given, mechanism_alone))
        for given in hints.lengths
    ]
    first = _follow((*arrows, *lengths), layout).written(named)
    if len(first.crowded) == len(layout.crowded) or not (arrows and lengths):
        return first
    other = _follow((*lengths, *arrows), layout).written(named)
    return min(first, other, key=lambda placed: len(placed.crowded))


def _follow(steps: Iterable[_Step], layout: Layout) -> Layout:
    for step in steps:
        layout = step(layout)
    return layout


def _choose_first_scale(
    mechanism: Mechanism, hints: FigureHints, span: tuple[float, float]
) -> float:
    """The scale that leaves room for the symbols, which do not scale, and for the labels around
    them.
    """
    guess = min((WIDTH - _SURROUND) / max(span[0], 1e-9), (HEIGHT - _SURROUND) / max(span[1], 1e-9))
    box = find_common_box(draw(scale_to_paper(mechanism, guess), hints).primitives)
    straight = any(isinstance(given, Moving) for given in hints.arrows)
    turning = sum(isinstance(given, Turning) for given in hints.arrows)
    marks = len(hints.lengths) + len(hints.angles) + len(hints.radii) + turning
    further = _FURTHER * max(0, marks - _USUAL)
    factors = []
    for axis, (limit, drawn) in enumerate(((WIDTH, box.width), (HEIGHT, box.height))):
        beside = drawn - span[axis] * guess + _WRITING[axis] + further
        beside += straight * _ARROWS[axis] + (hints.axes == "aside") * _AXES[axis]
        factors.append(max(limit - beside, limit / 4) / max(span[axis], 1e-9))
    return min(factors)
