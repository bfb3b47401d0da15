"""The pieces of a mechanism on a tactile sheet: its parts, each with the dots of its points."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from kinegrade.figure.joints.drivers import find_motor
from kinegrade.figure.joints.symbol import find_fixed_pins, find_pins
from kinegrade.figure.marks.names import find_free_ends, find_named_points
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.plane import NEAR, length
from kinegrade.figure.scene import Bow, Disc, Primitive, Strokes
from kinegrade.figure.tactile.clearance import list_rows, measure_gap
from kinegrade.figure.tactile.piece import Piece, Way
from kinegrade.figure.tactile.round import draw_rim, draw_strands, draw_track
from kinegrade.figure.tactile.sizes import DOT, MARK, MOTOR, OUTLINE, PIN
from kinegrade.figure.tactile.straight import (
    draw_block,
    draw_knife_edge,
    draw_part,
    list_rail_ways,
    list_stand_ways,
)
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.vector import Vector


@dataclass(frozen=True)
class Skeleton:
    """What is drawn of a mechanism in millimetres: its anatomy, and the drawing in print."""

    anatomy: Anatomy
    drawing: Drawing

    def draw_dot(self, at: Vector) -> Disc:
        """The dot of a point: a large one where it is a pin."""
        pins = find_pins(self.anatomy.mechanism, self.anatomy.symbols)
        pinned = any(length(at - pin) < NEAR for pin in pins)
        return Disc(at, PIN if pinned else DOT, None, "black")

    def list_named(self) -> list[tuple[str, Vector]]:
        """The points that are marked, by name, and the free ends that have a letter."""
        mechanism = self.anatomy.mechanism
        names = find_named_points(mechanism, self.anatomy.hints, self.drawing)
        points = [(name, mechanism.points[name]) for name in names]
        return [*points, *find_free_ends(mechanism, self.drawing)]

    def list_dotted(self) -> list[Vector]:
        """The points that have a dot: those that are marked, and those that a given refers to."""
        hints, points = self.anatomy.hints, self.anatomy.mechanism.points
        ends = [name for given in hints.lengths for name in (given.start, given.end)]
        ends += [name for given in hints.angles for name in (given.at, given.start, given.end)]
        named = [at for _, at in self.list_named()]
        return list(dict.fromkeys([*named, *(points[name] for name in ends if name in points)]))


def list_parts(skeleton: Skeleton) -> Iterator[Piece]:
    """The parts of a mechanism, what carries the others first, then its points; a part that has no
    room for the dots of all its points has that of one, or none.
    """
    for ways in _list_ways(skeleton.anatomy, skeleton.drawing):
        on_it = _find_points_on(skeleton, ways[0].primitives)
        dots = tuple(skeleton.draw_dot(at) for at in on_it)
        dotted = [Way((*way.primitives, *dots)) for way in ways]
        single = [Way((*way.primitives, dot)) for way in ways for dot in dots]
        yield Piece((*dotted, *single, *ways), at=on_it)
    for at in skeleton.list_dotted():
        yield Piece((Way((skeleton.draw_dot(at),)),), at=(at,))


def _list_ways(anatomy: Anatomy, drawing: Drawing) -> Iterator[list[Way]]:
    yield from _list_stands(anatomy)
    for part in anatomy.parts:
        yield [Way(draw_part(part))]
    for rail in drawing.rails:
        yield list(list_rail_ways(rail))
    for rim in anatomy.rims:
        yield [Way(draw_rim(anatomy, rim))]
    for foot in (symbol.foot for symbol in anatomy.symbols if symbol.foot):
        yield [Way((draw_track(foot),))]
    blocks = [symbol.block for symbol in anatomy.symbols if symbol.block]
    for slider in (*blocks, *anatomy.sleeves):
        yield [Way((draw_block(slider.point, slider.direction),))]
    at = anatomy.mechanism.points
    lines = [Strokes(((at[start], at[end]),), MARK) for start, end in anatomy.hints.lines]
    for single in (*draw_strands(anatomy), *lines, *_list_motors(anatomy)):
        yield [Way((single,))]


def _list_stands(anatomy: Anatomy) -> Iterator[list[Way]]:
    """The supports of fixed pins, but for those in fixed wheels, which are ground themselves."""
    at = anatomy.mechanism.points
    hubs = {rim.centre for rim in anatomy.rims if rim.body == GROUND and not rim.ring}
    for name in find_fixed_pins(anatomy.symbols):
        if name in anatomy.knife_edges:
            yield [Way(draw_knife_edge(at[name], anatomy.knife_edges[name]))]
        elif name not in hubs:
            yield list(list_stand_ways(name, anatomy))


def _list_motors(anatomy: Anatomy) -> Iterator[Disc]:
    for driver in anatomy.mechanism.drivers:
        bodies = find_motor(driver)
        for symbol in anatomy.symbols:
            if bodies and symbol.point and set(bodies) <= set(symbol.turning):
                yield Disc(anatomy.mechanism.points[symbol.point], MOTOR, OUTLINE)


def _find_points_on(skeleton: Skeleton, primitives: tuple[Primitive, ...]) -> tuple[Vector, ...]:
    """The marked points on the lines of a part, or within its filled shapes."""
    rows = [list_rows(each) for each in primitives]
    found = []
    for at in skeleton.list_dotted():
        dot = list_rows(Disc(at, NEAR, None, "black"))
        circles = [each for each in primitives if isinstance(each, Disc | Bow)]
        if any(length(each.centre - at) < NEAR for each in circles) or any(
            measure_gap(dot, each) < 0 for each in rows
        ):
            found.append(at)
    return tuple(dict.fromkeys(found))
