"""From a mechanism to its figure: `sketch` is the entry point, back ends give the output."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, lru_cache, partial
from itertools import groupby
from operator import attrgetter
from typing import Literal, assert_never

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.figure.marks.angles import (
    choose_bow,
    draw_least_legs,
    find_neighbours,
    list_led_arcs,
    mark_angles,
)
from kinegrade.figure.marks.body_names import add_body_names
from kinegrade.figure.marks.frames import add_axes_aside, add_frames
from kinegrade.figure.marks.imposed import drop_still
from kinegrade.figure.marks.lengths.claims import find_claimed, measure_strain
from kinegrade.figure.marks.lengths.dimensions import add_length, list_likely_extensions
from kinegrade.figure.marks.lengths.extension_gaps import Around
from kinegrade.figure.marks.names import find_named_points, keep_from_marks, label_points
from kinegrade.figure.marks.radii import add_radii
from kinegrade.figure.marks.right_angles import add_right_angle
from kinegrade.figure.marks.sides import find_sides, hide_sides
from kinegrade.figure.marks.straight.arrow_places import Site
from kinegrade.figure.marks.straight.motions import (
    add_motions,
    draw_likely_motions,
    list_likely_motions,
    list_likely_symbols,
)
from kinegrade.figure.marks.turning.rotations import add_rotations
from kinegrade.figure.mechanism.fitting import HEIGHT, WIDTH, fit_scene, measure_span
from kinegrade.figure.mechanism.layers import Drawing, draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.view import crop_to_view
from kinegrade.figure.placing.aligned import list_thin_lines
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.scene import THIN, Bow, Scene, find_common_box
from kinegrade.figure.similar_mechanisms import Subject, normalise_subject
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import FigureHints, Moving, Turning

_SURROUND = 14.0  # millimetres that symbols take beside the mechanism, as a first estimate
# Millimetres, across and upward, that marks and labels usually take beside the symbols
_WRITING = (4.0, 5.6)
_ARROWS = 6.6, 2.2  # millimetres that straight arrows usually take beside the symbols
_AXES = 0.0, 4.4  # millimetres that a frame of axes usually takes at the side
_RING = 20.0, 2.0  # millimetres beside a toothed ring, which has nearly all marks inside
# Marks that fit within WRITING, and the millimetres that each further one takes
_USUAL, _FURTHER = (4, 1.2)
_Stage = Literal["rotations", "motions", "lengths", "letters"]
# The marks with the fewest possible places first; letters stand near their points
_USUAL_ORDER: tuple[_Stage, ...] = ("rotations", "motions", "lengths", "letters")
_LETTERS_EARLY: tuple[_Stage, ...] = ("rotations", "letters", "motions", "lengths")
# What is tried while a dimension line crosses a bar, then orders to be tried in turn while a symbol
# has no good place
_LENGTHS_FIRST: tuple[_Stage, ...] = ("lengths", "rotations", "motions", "letters")
_OTHER_ORDERS: tuple[tuple[_Stage, ...], ...] = (
    ("rotations", "lengths", "motions", "letters"),
    _LETTERS_EARLY,
)
# Shares of the first scale, with an order, tried in turn while a symbol has no good place
_SMALLER = ((0.95, _USUAL_ORDER), (0.88, _USUAL_ORDER), (0.88, _LETTERS_EARLY))
Sketcher = Callable[[Mechanism, FigureHints], Scene]
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
    """The figure of a mechanism of unit size. Raises TemplateError as `sketch` does.

    No order helps an angle or a frame without a good place, which all orders place first.
    """
    mechanism, hints = shown.mechanism, drop_still(shown.mechanism, shown.hints)
    span = measure_span(mechanism, hints)
    scale = _choose_first_scale(mechanism, hints, span)
    begin = cache(partial(_begin, mechanism, hints))
    best = fit_scene(partial(_compose, begin, _USUAL_ORDER), scale, span)
    first = best.scale
    if best.strain:
        other = fit_scene(partial(_compose, begin, _LENGTHS_FIRST), first, span)
        best = min(best, other, key=_rate_scene)
    if best.astray:
        other = fit_scene(partial(_compose, begin, _LETTERS_EARLY), first, span)
        best = min(best, other, key=_rate_scene)
    for order in _OTHER_ORDERS:
        if best.crowded and not begin(first).layout.crowded:
            other = fit_scene(partial(_compose, begin, order), first, span)
            best = min(best, other, key=_rate_scene)
    for share, order in _SMALLER:
        if best.crowded and not begin(first * share).layout.crowded:
            other = fit_scene(partial(_compose, begin, order), first * share, span)
            best = min(best, other, key=_rate_scene)
    if best.claimed:
        other = fit_scene(partial(_compose, begin, _LENGTHS_FIRST), best.scale, span)
        best = min(best, other, key=_rate_scene)
    return best


def _rate_scene(scene: Scene) -> tuple[int, int, float, int]:
    """How bad a figure is: first by symbols without a good place, then by letters behind walls, by
    what marks cross, at last by letters of lengths that something else could own.
    """
    return len(scene.crowded), len(scene.astray), round(scene.strain, 6), len(scene.claimed)


class _Begun(Struct, frozen=True):
    """A figure at one scale as far as it is the same in whatever order the other marks follow: the
    mechanism, how it is drawn, the wishes of its letters; the layout of what is drawn alone, and
    the one with frames and angles.
    """

    paper: Mechanism
    hints: FigureHints
    drawing: Drawing
    named: tuple[Wish, ...]
    start: Layout
    layout: Layout


def _begin(mechanism: Mechanism, hints: FigureHints, scale: float) -> _Begun:
    paper = scale_to_paper(mechanism, scale)
    drawing = draw(paper, hints)
    named = tuple(label_points(paper, hints, drawing))
    start = Layout.of(drawing.primitives)
    layout = _place_frames_and_angles(start, paper, hints, drawing)
    return _Begun(paper, hints, drawing, named, start, layout)


def _compose(begin: Callable[[float], _Begun], order: tuple[_Stage, ...], scale: float) -> Layout:
    """The mechanism, then frames and angles, then the other marks and the letters of points in an
    order; last the radii, which may go anywhere, and the names of bodies.
    """
    begun = begin(scale)
    paper, hints, drawing = begun.paper, begun.hints, begun.drawing
    layout, unwritten = begun.layout, begun.named
    for stage in order:
        match stage:
            case "rotations":
                turning = [given for given in hints.arrows if isinstance(given, Turning)]
                lengths = hints.lengths
                layout = add_rotations(
                    layout, paper, turning, drawing, begun.named, lengths=lengths
                )
            case "motions":
                moving = [given for given in hints.arrows if isinstance(given, Moving)]
                site = Site(paper, drawing.rails, drawing.parts)
                for _, together in groupby(moving, attrgetter("point")):
                    layout = add_motions(layout, site, list(together), unwritten)
            case "lengths":
                around = Around.of(begun.start.obstacles, drawing)
                layout = _place_lengths(layout, paper, hints, around)
            case "letters":
                letters = [keep_from_marks(wish, layout.marks) for wish in unwritten]
                layout, unwritten = layout.written(letters), ()
            case _:
                assert_never(stage)
    layout = add_radii(layout, paper.points, drawing.rims, hints.radii)
    layout = add_axes_aside(layout, hints)
    layout = add_body_names(layout, paper, hints, drawing)
    return replace(layout, claimed=find_claimed(layout))


def _place_lengths(layout: Layout, paper: Mechanism, hints: FigureHints, around: Around) -> Layout:
    for length in hints.lengths:
        layout = add_length(layout, paper.points, length, around, hints.lengths)
    return replace(layout, strain=layout.strain + measure_strain(layout, len(hints.lengths)))


def _place_frames_and_angles(
    layout: Layout, paper: Mechanism, hints: FigureHints, drawing: Drawing
) -> Layout:
    """Marks that are bound to one point, right angles first; an angle keeps clear of the sides of
    those to come, of points that are seen, and of where straight arrows are likely to stand.
    """
    at = paper.points
    vertices = {angle.at for angle in hints.angles}
    seen = {name: at[name] for name in {*find_named_points(paper, hints, drawing), *vertices}}
    for points in hints.right_angles:
        layout = add_right_angle(layout, at, points, drawing)
    moving = [given for given in hints.arrows if isinstance(given, Moving)]
    site = Site(paper, drawing.rails)
    likely = list_likely_motions(site, moving)
    sides = [find_sides(at, angle, drawing) for angle in hints.angles]
    legs = [draw_least_legs(at, *each) for each in zip(hints.angles, sides, strict=True)]
    usual = [choose_bow(seen, *each) for each in zip(hints.angles, sides, strict=True)]
    sparing = [line for lines in legs for line in lines]
    layout = add_frames(layout, at, hints, drawing, sparing, likely=likely)
    extensions = list_likely_extensions(at, hints.lengths, layout.obstacles)
    around = replace(find_neighbours(drawing), to_come=extensions)
    arrows = (*draw_likely_motions(likely), *list_likely_symbols(site, moving))
    for number, angle in enumerate(hints.angles, start=1):
        to_come = [*arrows, *(line for lines in legs[number:] for line in lines)]
        drawn = tuple(part for part in layout.lines if isinstance(part, Bow) and part.pen == THIN)
        near = replace(around, arcs=(*drawn, *usual[number:]), lines=list_thin_lines(layout.lines))
        near = replace(near, pins=tuple(pin for pin in seen.values() if pin != at[angle.at]))
        shown = hide_sides(sides[number - 1], at[angle.at], likely, layout.lines)
        for arcs in mark_angles(seen, angle, shown, near):
            layout = layout.marked(arcs, to_come, partial(list_led_arcs, arcs, layout.obstacles))
    return layout


def _choose_first_scale(
    mechanism: Mechanism, hints: FigureHints, span: tuple[float, float]
) -> float:
    """The scale that leaves room for the symbols, which do not scale, and for the labels around
    them.
    """
    guess = min((WIDTH - _SURROUND) / max(span[0], 1e-9), (HEIGHT - _SURROUND) / max(span[1], 1e-9))
    drawing = draw(scale_to_paper(mechanism, guess), hints)
    box = find_common_box(drawing.primitives)
    straight = any(isinstance(given, Moving) for given in hints.arrows)
    turning = sum(isinstance(given, Turning) for given in hints.arrows)
    marks = len(hints.lengths) + len(hints.angles) + len(hints.radii) + turning
    further = _FURTHER * max(0, marks - _USUAL)
    factors = []
    for axis, (limit, drawn) in enumerate(((WIDTH, box.width), (HEIGHT, box.height))):
        beside = drawn - span[axis] * guess + _WRITING[axis] + further
        beside += straight * _ARROWS[axis] + (hints.axes == "aside") * _AXES[axis]
        if any(rim.ring and rim.kind == "gear" for rim in drawing.rims):
            beside = min(beside, drawn - span[axis] * guess + _RING[axis])
        factors.append(max(limit - beside, limit / 4) / max(span[axis], 1e-9))
    return min(factors)
