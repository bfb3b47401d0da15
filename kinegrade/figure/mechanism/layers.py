"""The mechanism itself as primitives, from the lowest layer up: circles, blocks on the ground,
plates, stands, bars, pins.

Bars and plates lie above the blocks to whose pins they lead, slender bars also above slotted ones,
and those that slide in sleeves above all others and above the pins of these;
the stand of a sleeve's pin lies above the sleeve.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from msgspec import Struct

from kinegrade.figure.joints.symbol import Rim, Symbol
from kinegrade.figure.mechanism.anatomy import Anatomy
from kinegrade.figure.mechanism.belts import draw_belts, draw_ropes
from kinegrade.figure.mechanism.pins import (
    draw_motors,
    draw_points,
    draw_swivels,
    find_half_pins,
)
from kinegrade.figure.mechanism.plates import Plate
from kinegrade.figure.mechanism.rails import Rail, find_rails
from kinegrade.figure.mechanism.round.heads import draw_heads
from kinegrade.figure.mechanism.round.round_bodies import draw_round_bodies
from kinegrade.figure.mechanism.sliders import draw_blocks, draw_ground_sliders, draw_sleeves
from kinegrade.figure.mechanism.stands import draw_stands, draw_stands_of_sleeves
from kinegrade.figure.mechanism.straight.gussets import draw_gussets, find_welded_arms
from kinegrade.figure.mechanism.straight_bodies import draw_straight_part
from kinegrade.figure.mechanism.straight_parts import (
    Bar,
    GenevaWheel,
    Part,
    SlottedDisc,
    is_slender,
)
from kinegrade.figure.mechanism.tracks import draw_tracks
from kinegrade.figure.plane import NEAR, length
from kinegrade.figure.scene import THIN, Primitive, Strokes
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints


class Drawing(Struct, frozen=True):
    """The mechanism's primitives, those of its supports and guides alone, and what marks and
    labels need to know about its parts.
    """

    primitives: tuple[Primitive, ...]
    ground: tuple[Primitive, ...]
    rims: tuple[Rim, ...]
    parts: tuple[Part, ...]
    symbols: tuple[Symbol, ...]
    rails: tuple[Rail, ...]
    half_pins: tuple[tuple[Vector, Vector], ...] = ()


def draw(mechanism: Mechanism, hints: FigureHints) -> Drawing:
    """The mechanism (lengths in millimetres) drawn with the symbols of ISO 3952."""
    anatomy = Anatomy.of(mechanism, hints)
    rails = find_rails(anatomy)
    sliders, stands = tuple(draw_ground_sliders(rails)), tuple(draw_stands(anatomy))
    before = tuple(draw_stands_of_sleeves(anatomy))
    drawn = tuple(_draw_layers(anatomy, sliders, stands, before))
    ground, pins = (*sliders, *stands, *before), find_half_pins(anatomy)
    return Drawing(drawn, ground, anatomy.rims, anatomy.parts, anatomy.symbols, rails, pins)


def _draw_layers(
    anatomy: Anatomy,
    sliders: Sequence[Primitive],
    stands: Sequence[Primitive],
    stands_of_sleeves: Sequence[Primitive],
) -> Iterator[Primitive]:
    yield from draw_round_bodies(anatomy)
    yield from draw_belts(anatomy)
    yield from draw_ropes(anatomy)
    yield from draw_tracks(anatomy)
    yield from sliders
    for part in anatomy.parts:
        if isinstance(part, Plate | SlottedDisc | GenevaWheel):
            yield from draw_straight_part(part, anatomy.rims)
    behind, over = _sort_reference_lines(anatomy)
    yield from behind
    yield from stands
    for part in anatomy.parts:
        if isinstance(part, Bar) and not is_slender(part):
            yield from draw_straight_part(part, anatomy.rims)
    yield from over
    yield from draw_blocks(anatomy)
    arms = [arm for arm, _ in find_welded_arms(anatomy.parts, anatomy.symbols)]
    for arm in arms:
        yield from draw_straight_part(arm, anatomy.rims)
    yield from draw_sleeves(anatomy)
    yield from stands_of_sleeves
    yield from draw_motors(anatomy)
    bars = [part for part in anatomy.parts if is_slender(part) and part not in arms]
    sliding = [bar for bar in bars if isinstance(bar, Bar) and bar.use == "bar"]
    for bar in bars:
        if bar not in sliding:
            yield from draw_straight_part(bar, anatomy.rims)
    yield from draw_swivels(anatomy)
    for bar in sliding:
        yield from draw_straight_part(bar, anatomy.rims)
    yield from draw_gussets(anatomy.corners)
    yield from draw_heads(anatomy)
    yield from draw_points(anatomy)


def _sort_reference_lines(anatomy: Anatomy) -> Iterator[tuple[Strokes, ...]]:
    """The lines behind the bars, then those before broad ones, in whose slot they end."""
    at = anatomy.mechanism.points
    slotted = (part for part in anatomy.parts if isinstance(part, Bar) and part.use == "slot")
    inner = [action for bar in slotted for action in bar.actions]
    lines = [(at[start], at[end]) for start, end in anatomy.hints.lines]
    for before in (False, True):
        sorted_lines = tuple(line for line in lines if _ends_at(line, inner) == before)
        yield (Strokes(sorted_lines, THIN),) if sorted_lines else ()


def _ends_at(line: tuple[Vector, Vector], points: Iterable[Vector]) -> bool:
    return any(length(point - end) < NEAR for point in points for end in line)
