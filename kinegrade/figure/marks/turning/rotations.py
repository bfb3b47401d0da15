"""Rotations as curved arrows about a pivot, each with several alternatives."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from math import pi

from msgspec.structs import replace

from kinegrade.figure.marks.imposed import find_imposed_sense
from kinegrade.figure.marks.lengths.claims import widen_written
from kinegrade.figure.marks.lengths.dimensions import find_extension_angles
from kinegrade.figure.marks.tied_arrows import list_tied_arrows, turns_among_bodies
from kinegrade.figure.marks.turning.pivots import find_turning_centre
from kinegrade.figure.marks.turning_arrow import Company, TurningArrow
from kinegrade.figure.marks.turning_radii import (
    BEYOND,
    RADII,
    ROOMY,
    find_body_direction,
    list_base_circles,
    order_radii,
)
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.mechanism.straight_parts import Bar, Rod
from kinegrade.figure.placing.aligned import list_thin_lines
from kinegrade.figure.placing.beside import rate_close
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.ownership import Claims, list_places
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.plane import NEAR, angle_of, length, shorter_way
from kinegrade.figure.scene import PITCH, THIN, Bow, Disc, Label, Primitive
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.template.hints import TURN, Length, Sense, Turning

# Millimetres, length of the arrow of a rotation; an acceleration has one head more
_ARCS: Mapping[Level, float] = {"velocity": 6.5, "acceleration": 7.6}
# Millimetres, of the arrow of a rotation relative to another body
_RELATIVE_RADII = (7.0, 8.5, 10.0, 11.5, 13.0, 14.5, 16.0, 17.5, 19.0, 20.5, 5.5)
_RELATIVE_ARCS = (9.0, 7.0, 5.5)
_TWELFTHS = tuple(index * pi / 6 for index in range(12))
# Demerit of each radian between the arrow and the body, or where the rim of a disc is nearest
_ASTRAY, _AT_RIM = 1.2, 5.0
# Demerit of an arrow off the bar that turns, where another could show that: about the centre of a
# body that turns as well, and about that of a fixed one, where nothing else can turn
_LOOSE, _ALONE = 40.0, 8.0
# Millimetres about a pivot within which the arrow of a rotation keeps clear of letters
_LETTERED = 12.0
# Millimetres between the symbols of two arrows, of which either arrow could own both, and demerit
# of less
_APART, _AT_SYMBOL = 2.0, 3.0
_ABOUT = 20.0  # millimetres about a pivot in which pins and lines may seem to own a symbol


def add_rotations(
    layout: Layout,
    mechanism: Mechanism,
    hints: Sequence[Turning],
    drawing: Drawing,
    named: Sequence[Wish],
    *,
    lengths: Iterable[Length] = (),
) -> Layout:
    """The layout with an arrow about the pivot of each body whose rotation is given, the preferred
    one close to it, where the body leaves it, and then their symbols, each nearest to its own.

    An arrow keeps clear of the letters `named` that are still to be written at its pivot, and of
    the lines that the dimensions `lengths` may need there.
    """
    arrows: list[TurningArrow] = []
    spared: list[Sequence[Primitive]] = []
    likely: list[Label] = []  # the symbols of earlier arrows, as long as no later one is known
    for number, hint in enumerate(hints):
        for arrow, letters in zip(arrows[-1:], spared[-1:], strict=True):
            wish = arrow.wish_apart(arrows[:-1])
            likely += layout.captioned(wish, (*letters, *likely)).labels[-1:]
        centre = find_turning_centre(mechanism, hint, drawing)
        lines = find_extension_angles(mechanism.points, lengths, centre, layout.obstacles)
        pins = [at for at in mechanism.points.values() if length(at - centre) < _ABOUT]
        company = _find_company(layout, hint, drawing, centre, lines)
        company = replace(company, pins=tuple(pins), letters=widen_written(layout, lengths))
        around = _find_claims(layout, pins, drawing, hint.body, centre)
        followed = any(later.body == hint.body for later in hints[number + 1 :])
        ways = _list_arrows(mechanism, hint, centre, drawing, followed=followed)
        # The letter of a pivot leaves a bound arrow its place: that can go nowhere else
        bound = next((way for way in ways if way.tied), None)
        before = layout.drawn(bound.primitives()) if bound else layout
        spared.append(before.written(_list_close(named, centre)).labels)
        rate = partial(TurningArrow.among, company=company, around=around)
        layout, _ = layout.chosen(ways, (*spared[-1], *likely), rate)
        arrows += [mark for mark in layout.marks[-1:] if isinstance(mark, TurningArrow)]
        if bound and not arrows[-1].tied:
            layout = replace(layout, strain=layout.strain + arrows[-1].demerit)
    return _write_symbols(layout, arrows, spared)


def _write_symbols(
    layout: Layout, arrows: Sequence[TurningArrow], spared: Sequence[Sequence[Primitive]]
) -> Layout:
    """The layout with the symbols of all arrows, each apart from the others and from the letters
    that were spared for it.
    """
    written = len(layout.labels)
    for arrow, letters in zip(arrows, spared, strict=True):
        others = [other for other in arrows if other != arrow]
        wish = arrow.wish_apart(others)
        wish = wish.worse_by(_AT_SYMBOL * rate_close(wish, layout.labels[written:], _APART))
        layout = layout.captioned(wish, letters)
    return layout


def _list_close(named: Sequence[Wish], centre: Vector) -> list[Wish]:
    """The letters that stand about a pivot."""
    return [wish for wish in named if length(Vector(*wish.spots[0]) - centre) < _LETTERED]


def _find_claims(
    layout: Layout, pins: Sequence[Vector], drawing: Drawing, body: str, centre: Vector
) -> Claims:
    """What else might own the symbol of an arrow about a pivot, or cut it off."""
    base = list_base_circles(drawing, body, centre)
    discs = [part for part in drawing.primitives if isinstance(part, Disc) and part.pen != PITCH]
    bars = (part for part in drawing.parts if isinstance(part, Bar | Rod))
    return Claims(
        (*(disc for disc in discs if disc.radius > RADII[0]), *base),
        tuple((part.start, part.end) for part in bars),
        tuple(pins),
        tuple(list_places(list_thin_lines(layout.lines), centre, _ABOUT)),
    )


def _list_arrows(
    mechanism: Mechanism, hint: Turning, centre: Vector, drawing: Drawing, *, followed: bool
) -> list[TurningArrow]:
    """The arrows that may show a rotation."""
    if hint.of == GROUND:
        return _list_absolute_arrows(mechanism, hint, centre, drawing, followed=followed)
    return _list_relative_arrows(mechanism, hint, centre, drawing)


def _find_company(
    layout: Layout, hint: Turning, drawing: Drawing, centre: Vector, lines: tuple[float, ...]
) -> Company:
    """What there is about a pivot, with the directions of lines that may come."""
    arcs = [line for line in layout.lines if isinstance(line, Bow) and line.pen == THIN]
    earlier = [mark.bow for mark in layout.marks if isinstance(mark, TurningArrow)]
    foreign = [rim for rim in drawing.rims if rim.body != hint.body]
    circles = (rim for rim in drawing.rims if rim.kind != "cam")
    return Company(
        tuple(arc for arc in arcs if length(arc.centre - centre) < NEAR),
        tuple(twin for twin in earlier if length(twin.centre - centre) < NEAR),
        tuple(rim.radius for rim in foreign if length(rim.at - centre) < NEAR),
        lines,
        tuple(rim for rim in foreign if not rim.ring and length(rim.at - centre) > rim.radius),
        tuple(_list_bars(drawing, hint.body)),
        own=tuple(rim for rim in circles if rim.body == hint.body),
    )


def _list_bars(drawing: Drawing, body: str) -> Iterator[Segment]:
    """The axes of bars of other bodies, and the line from a cam's centre of curvature to its
    contact.
    """
    for rim in drawing.rims:
        if rim.kind == "cam" and rim.body == body:
            yield rim.at, rim.touch
    for part in drawing.parts:
        if isinstance(part, Bar | Rod) and part.body != body:
            yield part.start, part.end


def _list_absolute_arrows(
    mechanism: Mechanism, hint: Turning, centre: Vector, drawing: Drawing, *, followed: bool
) -> list[TurningArrow]:
    """Arrows about the pivot of a body, where the body leaves it first; those of an eccentric disc,
    where there is no room inside, beyond its rim, where that is nearest.
    """
    sense = hint.sense or find_imposed_sense(mechanism, hint)
    for rim in drawing.rims:
        aside = length(centre - rim.at)
        room = rim.radius - aside
        if rim.body == hint.body and rim.kind == "wheel" and aside > NEAR and 0 < room < ROOMY:
            away, beyond = angle_of(centre - rim.at), room + BEYOND
            radii = (beyond, beyond + 1.5, beyond + 3.0, *RADII)
            return list_turning_arrows(hint, sense, centre, radii, away, astray=_AT_RIM)
    crank = find_body_direction(mechanism, hint.body, centre, drawing)
    sizes = order_radii(mechanism, hint.body, centre, drawing)
    arrows = list_turning_arrows(hint, sense, centre, sizes, crank, astray=_ASTRAY)
    shaft = _ARCS[hint.level] * TURN[sense]
    tied = list_tied_arrows(hint, centre, shaft, drawing, followed=followed)
    if not tied:
        return arrows
    loose = _LOOSE if turns_among_bodies(hint, centre, drawing) else _ALONE
    return [*tied, *(replace(arrow, demerit=arrow.demerit + loose) for arrow in arrows)]


def _list_relative_arrows(
    mechanism: Mechanism, hint: Turning, centre: Vector, drawing: Drawing
) -> list[TurningArrow]:
    """Arrows about the pin of two bodies that start on the one that counts as fixed, shorter ones
    where the other is near.
    """
    sense = hint.sense or find_imposed_sense(mechanism, hint)
    start = find_body_direction(mechanism, hint.of, centre, drawing)
    return [
        TurningArrow(
            Bow(centre, radius, start, size / radius * TURN[sense], THIN), hint, rank + less
        )
        for rank, radius in enumerate(_RELATIVE_RADII)
        for less, size in enumerate(_RELATIVE_ARCS)
    ]


def list_turning_arrows(
    hint: Turning,
    sense: Sense,
    centre: Vector,
    radii: Sequence[float],
    toward: float,
    *,
    astray: float,
) -> list[TurningArrow]:
    """Curved arrows about a centre, of each radius (millimetres, the preferred one first) and in
    twelve directions; `astray` is the demerit of each radian away from the direction `toward`.
    """
    found: list[TurningArrow] = []
    for radius in radii:
        span = _ARCS[hint.level] / radius * TURN[sense]
        for angle in _TWELFTHS:
            bow = Bow(centre, radius, angle - span / 2, span, THIN)
            demerit = 1.5 * abs(radius - radii[0]) + astray * abs(shorter_way(angle - toward))
            found.append(TurningArrow(bow, hint, demerit))
    return found
