"""Fixed surfaces, straight and round, with their hatching."""

from __future__ import annotations

from collections.abc import Iterator
from math import ceil, pi

from kinegrade.figure.plane import length, polar, shorter_way, unit
from kinegrade.figure.scene import FIRM, THIN, Bow, Disc, Primitive, Strokes
from kinegrade.mechanics.vector import Vector

HATCHING = 1.5  # depth of ground hatching
HATCHING_DEPTH = 0.75 * HATCHING  # that of straight ground, to the ends of its strokes
_OPEN = (4.2, 3.0)  # millimetres before and after an angle without hatching, whose strokes lean


def draw_ground(
    start: Vector,
    end: Vector,
    side: Vector,
    share: float = 1.0,
    between: float | None = None,
) -> tuple[Primitive, ...]:
    """A fixed straight surface with hatching on the given side, of that share of the usual size;
    `between` are the millimetres from its start to a place midway between two strokes, which lean
    backward.
    """
    along, size = unit(end - start), length(end - start)
    count = max(3, ceil(size / (1.25 * share)))
    phase = 0.5 if between is None else (between * count / size + 0.5) % 1
    steps = [start + along * (size * (index + phase) / count) for index in range(count)]
    stroke = (side - along) * (HATCHING_DEPTH * share)
    hatching = tuple((step, step + stroke) for step in steps)
    return (Strokes(hatching, THIN), Strokes(((start, end),), FIRM))


def draw_round_ground(
    centre: Vector,
    radius: float,
    outward: bool,
    arc: tuple[float, float] | None = None,
    open_at: float | None = None,
) -> tuple[Primitive, ...]:
    """A fixed circular surface, or an arc of it from an angle onward, with hatching inside or
    outside, which is open at an angle for the letter of a point there.
    """
    first, sweep = arc or (0.0, 2 * pi)
    edge = Bow(centre, radius, first, sweep, FIRM) if arc else Disc(centre, radius, FIRM)
    return (Strokes(tuple(list_round_hatching(centre, radius, outward, arc, open_at)), THIN), edge)


def list_round_hatching(
    centre: Vector,
    radius: float,
    outward: bool,
    arc: tuple[float, float] | None = None,
    open_at: float | None = None,
) -> Iterator[tuple[Vector, Vector]]:
    """The strokes of the hatching of a fixed circular surface, each from its edge; at an arc up to
    either end and not beyond one.
    """
    first, sweep = arc or (0.0, 2 * pi)
    count = max(12, ceil(sweep * radius / 1.5))
    depth = HATCHING if outward else -min(HATCHING, radius / 3)
    lean_back = int(arc is not None and not outward)
    for index in range(lean_back, count + lean_back):
        angle = first + sweep * index / count
        if open_at is not None and -_OPEN[0] < shorter_way(angle - open_at) * radius < _OPEN[1]:
            continue
        upward = polar(angle)
        foot = centre + upward * radius
        yield foot, foot + (upward + upward.turned() * 0.7) * depth
