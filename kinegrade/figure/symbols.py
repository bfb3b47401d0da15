"""The symbols of kinematic diagrams (ISO 3952, GB/T 4460) in millimetres, at a point, in a
direction.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import ceil, pi, sqrt

from msgspec.structs import replace

from kinegrade.figure.plane import angle_of, length, polar, shorter_way, unit
from kinegrade.figure.scene import (
    BOLD,
    DASHED,
    FIRM,
    OPEN,
    PITCH,
    THIN,
    TOOTHED,
    Bow,
    Disc,
    Fill,
    Outline,
    Pen,
    Primitive,
    Strokes,
)
from kinegrade.figure.teeth import find_teeth_of_rack, trace_rack
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level

PIN = 0.85  # radius of a pin's circle
_HALF_PIN = 1.15
_HOLE = 0.35  # less than half a bar, which is seen to run on at both sides of it
DOT = 0.75  # radius of the dot of a marked point
HATCHING = 1.5  # depth of ground hatching
_OPEN = (4.2, 3.0)  # millimetres before and after an angle without hatching, whose strokes lean
BLOCK_LENGTH, BLOCK_WIDTH = 5.0, 3.0
SLOT_WIDTH, BAR_WIDTH, SLEEVE_WIDTH = 1.9, 3.5, 3.2
SLEEVE_LENGTH, WIDTH_ABOUT_PIN = 6.4, 4.4  # of a sleeve; its width about a pin beside its bar
_GUIDE_GAP = BOLD.width / 2 + 0.55  # from the axis of a rod to its guide
# Millimetres: half the width of a cylinder, its length, and from its floor to the piston in it
_BORE, _STROKE, _UNDER_PISTON = 2.0, 9.5, 3.8
RACK_DEPTH = 2.6  # from the pitch line of a rack to its back
# Millimetres: a tooth of a jaw, and the gap at the mouth; the slope between the two jaws
_TOOTH, _MOUTH, _MOUTH_SLOPE = 0.9, 2.2, 0.3
# Heights of a fixed pin's stand, of one that fits into the smallest wheel, and of one about whose
# pin a sleeve turns, which hides its top
STAND, SMALL_STAND, STAND_OF_SLEEVE = 3.6, 2.2, 6.2
_HALF_BASES = {STAND: 2.6, SMALL_STAND: 1.3, STAND_OF_SLEEVE: 2.3}
_STEPS = 60  # corners of a round band, whose edges are drawn over them
_STEP = 2 * pi / _STEPS
SOLID_AT_PIN = 3.0  # millimetres that a slot keeps from a pin of its own body, at least
HEAD_LENGTH, _HEAD_SHARE = 2.0, 0.55  # the share that a head is wide
_HEAD_OF_ARC = 0.45  # largest share of an arc that its head takes
_HEAD_STEP = 1.6  # from one head of an arrow to the next
# Heads of the arrow of a velocity, and of an acceleration
HEADS: Mapping[Level, int] = {"velocity": 1, "acceleration": 2}


def draw_pin(at: Vector) -> tuple[Primitive, ...]:
    """A revolute joint: a small open circle."""
    return (Disc(at, PIN, FIRM, "white"),)


def draw_half_pin(at: Vector, side: Vector) -> tuple[Primitive, ...]:
    """A revolute joint at the side of a bar that runs on through it: a half circle."""
    flat = at + side * (BOLD.width / 2)
    arc = Bow(flat, _HALF_PIN, angle_of(side) - pi / 2, pi, FIRM)
    return (Outline(arc.path(), FIRM, "white"),)


def reach_half_pin(away: Vector, side: Vector) -> float:
    """Millimetres from the point of such a joint to its edge in a direction (a unit vector): to the
    half circle, on the other side to the bar.
    """
    half, ahead = BOLD.width / 2, away.dot(side)
    if ahead <= 0:
        return half
    return half * float(ahead) + sqrt(_HALF_PIN**2 - half**2 * (1 - ahead**2))


def measure_in_sleeve(away: Vector, side: Vector) -> float:
    """Millimetres from the point of such a joint to the edge of its sleeve in a direction."""
    along, across = abs(float(away.cross(side))), abs(float(away.dot(side)))
    return min(SLEEVE_LENGTH / 2 / max(along, 1e-9), WIDTH_ABOUT_PIN / 2 / max(across, 1e-9))


def draw_boss(at: Vector) -> tuple[Primitive, ...]:
    """A revolute joint of bars that all run on through it: a small hole in a black boss, which
    interrupts none of them.
    """
    return (Disc(at, PIN + FIRM.width / 2, None, "black"), Disc(at, _HOLE, None, "white"))


def draw_pivot(at: Vector, upright: Vector) -> tuple[Primitive, ...]:
    """The stand of a pin fixed to the ground: a triangle on hatching, whose middle is at `upright`
    from the pin.
    """
    base, across = at + upright, unit(upright).turned()
    share = min(1.0, length(upright) / STAND)
    half = find_half_base(length(upright))
    corners = (at, base + across * 1.8 * share, base - across * 1.8 * share)
    ground = draw_ground(base - across * half, base + across * half, unit(upright), share)
    return (Outline(corners, FIRM, "white"), *ground)


def find_half_base(height: float) -> float:
    """Half the width of the hatched base of a stand of that height."""
    return _HALF_BASES[min(_HALF_BASES, key=lambda stand: abs(stand - height))]


def draw_knife_edge(at: Vector, toward: Vector) -> tuple[Primitive, ...]:
    """A fixed point that touches a side of a body: the tip of a black wedge, which stands in the
    direction `toward`.
    """
    base, across = at + toward * 3.2, toward.turned()
    wedge = Outline((at, base + across, base - across), None, "black")
    return (wedge, *draw_ground(base - across * 2.6, base + across * 2.6, toward))


def draw_rack(
    start: Vector, end: Vector, back: Vector, gap: Vector, eyes: tuple[Vector, ...] = ()
) -> tuple[Primitive, ...]:
    """A toothed bar with its pitch line, on which there is a gap at that point, its material in the
    direction `back`, and an eye about the pin at each of those ends, whose outline runs on in that
    of the bar.
    """
    teeth, radius = find_teeth_of_rack(start, end, gap, eyes), BAR_WIDTH / 2
    contour = trace_rack((start, end), back, teeth, RACK_DEPTH, eyes)
    edges = tuple(Disc(at, radius, TOOTHED, "grey") for at in eyes)
    insides = tuple(Disc(at, radius - TOOTHED.width / 2, None, "grey") for at in eyes)
    line = Strokes(((teeth[0], teeth[-1]),), PITCH)
    return (*edges, Outline(contour, TOOTHED, "grey"), *insides, line)


def draw_jaw(pivot: Vector, mouth: Vector, back: Vector) -> tuple[Primitive, ...]:
    """A plate from its pivot to its mouth, with the axis from pin to pin and teeth on the side away
    from `back`, and the fixed jaw that it faces, which is nearest at the mouth.
    """
    along, size = unit(mouth - pivot), length(mouth - pivot)
    half, count = BAR_WIDTH / 2, max(4, round(size / 2.2))
    teeth = [
        mouth - along * (size * (index + 0.5) / count) - back * (half + _TOOTH * (index % 2))
        for index in range(count)
    ]
    round_mouth = pi if back.cross(along) > 0 else -pi
    caps = [
        Bow(at, half, angle_of(side), round_mouth, FIRM).path()
        for at, side in ((mouth, back), (pivot, -back))
    ]
    plate = Outline((*caps[0], *teeth, *caps[1]), FIRM, "grey")
    upward = unit(-along - back * _MOUTH_SLOPE)
    facing = mouth - back * (half + _TOOTH + _MOUTH)
    outward = upward.turned() if back.dot(upward.turned()) < 0 else -upward.turned()
    faced = draw_ground(facing - upward * 2.0, facing + upward * size * 0.9, outward)
    return (*faced, plate, Strokes(((pivot, mouth),), PITCH))


def draw_ground(
    start: Vector, end: Vector, side: Vector, share: float = 1.0
) -> tuple[Primitive, ...]:
    """A fixed straight surface with hatching on the given side, of that share of the usual size."""
    along, size = unit(end - start), length(end - start)
    count = max(3, ceil(size / (1.25 * share)))
    steps = [start + along * (size * (index + 0.5) / count) for index in range(count)]
    stroke = (side - along) * (HATCHING * 0.75 * share)
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
    """The strokes of the hatching of a fixed circular surface, each from its edge."""
    first, sweep = arc or (0.0, 2 * pi)
    count = max(12, ceil(sweep * radius / 1.5))
    depth = HATCHING if outward else -min(HATCHING, radius / 3)
    for index in range(count):
        angle = first + sweep * index / count
        if open_at is not None and -_OPEN[0] < shorter_way(angle - open_at) * radius < _OPEN[1]:
            continue
        upward = polar(angle)
        foot = centre + upward * radius
        yield foot, foot + (upward + upward.turned() * 0.7) * depth


def draw_block(
    at: Vector, along: Vector, size: float = BLOCK_LENGTH, width: float = BLOCK_WIDTH
) -> Outline:
    """A slider: a rectangle with its long side along the guide."""
    half, across = along * (size / 2), along.turned() * (width / 2)
    return Outline(
        (at - half - across, at + half - across, at + half + across, at - half + across),
        FIRM,
        "white",
    )


def draw_guide(at: Vector, along: Vector, reach: float = 2.8) -> tuple[Primitive, ...]:
    """A straight ground guide on both sides of a rod."""
    across = along.turned()
    sides = (across, -across)
    return tuple(
        part
        for side in sides
        for part in draw_ground(
            at + side * _GUIDE_GAP - along * reach, at + side * _GUIDE_GAP + along * reach, side
        )
    )


def draw_cylinder(start: Vector, end: Vector) -> tuple[Primitive, ...]:
    """A rod whose piston is in a closed cylinder, on ground of which the hatching ends at `end`."""
    along = unit(end - start)
    across, floor = along.turned(), end - along * HATCHING
    side, mouth, piston = across * _BORE, floor - along * _STROKE, floor - along * _UNDER_PISTON
    box = (mouth - side, mouth + side, floor + side, floor - side)
    reach, head = across * (_BORE + 1.3), across * (_BORE - FIRM.width)
    return (
        *draw_ground(floor - reach, floor + reach, along),
        Outline(box, FIRM, "white"),
        Strokes(((piston - head, piston + head),), BOLD),
        Strokes(((start, piston),), BOLD),
    )


def trace_round(corners: tuple[Vector, ...], radius: float) -> tuple[Vector, ...]:
    """The outline about a convex polygon (counter-clockwise; or two points) at a distance from it,
    with round corners.
    """
    outline: list[Vector] = []
    for index, corner in enumerate(corners):
        onward = corners[(index + 1) % len(corners)] - corner
        start, end = angle_of(corner - corners[index - 1]), angle_of(onward)
        outline += Bow(corner, radius, start - pi / 2, (end - start) % (2 * pi), FIRM).path()
    return tuple(outline)


def draw_round_slot(
    centre: Vector, radius: float, pivot: Vector | None = None
) -> tuple[Primitive, ...]:
    """A ring with a slot along it and the centre line of the slot, which leaves the ring solid at a
    pivot on it; what is drawn before shows through its middle.
    """
    ring, middle = _draw_band(centre, radius, BAR_WIDTH, FIRM, "grey"), Disc(centre, radius, PITCH)
    if pivot is None:
        return (*ring, *_draw_band(centre, radius, SLOT_WIDTH, THIN, "white"), middle)
    return (*ring, Outline(_trace_round_slot(centre, radius, pivot), THIN, "white"), middle)


def _trace_round_slot(centre: Vector, radius: float, pivot: Vector) -> tuple[Vector, ...]:
    solid, half = SOLID_AT_PIN / radius, SLOT_WIDTH / 2
    first, sweep = angle_of(pivot - centre) + solid, 2 * (pi - solid)
    ends = [centre + polar(turn, radius) for turn in (first + sweep, first)]
    onward = Bow(centre, radius + half, first, sweep, THIN).path(_STEP)
    back = Bow(centre, radius - half, first + sweep, -sweep, THIN).path(_STEP)
    caps = [
        Bow(ends[0], half, first + sweep, pi, THIN).path(),
        Bow(ends[1], half, first + pi, pi, THIN).path(),
    ]
    return (*onward, *caps[0][1:-1], *back, *caps[1][1:-1])


def _draw_band(
    centre: Vector, radius: float, width: float, pen: Pen, fill: Fill
) -> tuple[Primitive, ...]:
    outer, inner = radius + width / 2, radius - width / 2
    turns = [_STEP * step for step in range(_STEPS + 1)]
    there = [centre + polar(turn, outer) for turn in turns]
    back = [centre + polar(turn, inner) for turn in reversed(turns)]
    band = Outline((*there, *back), None, fill)
    return (band, Disc(centre, outer, pen), Disc(centre, inner, pen))


def draw_slotted_bar(
    start: Vector, end: Vector, slot: tuple[Vector, Vector], fill: Fill
) -> tuple[Primitive, ...]:
    """A rounded bar with a straight slot in it, through which is seen what lies behind."""
    edge, hole = trace_round((start, end), BAR_WIDTH / 2), trace_round(slot, SLOT_WIDTH / 2)
    ground = Outline((*edge, edge[0], hole[0], *reversed(hole)), None, fill)
    return (ground, Outline(edge, FIRM), Outline(hole, THIN))


def draw_broad_bar(start: Vector, end: Vector) -> tuple[Primitive, ...]:
    """A rounded bar on which something is drawn."""
    return (Outline(trace_round((start, end), BAR_WIDTH / 2), FIRM, "grey"),)


def draw_centre_mark(at: Vector) -> tuple[Primitive, ...]:
    """A small upright cross."""
    arms = (Vector(1.1, 0.0), Vector(0.0, 1.1))
    return (Strokes(tuple((at - arm, at + arm) for arm in arms), THIN),)


def draw_dot(at: Vector, radius: float = DOT) -> tuple[Primitive, ...]:
    """A marked point that is not a joint; the usual one is wider than a bar, which it does not
    interrupt.
    """
    return (Disc(at, radius, None, "black"),)


def draw_arrowhead(tip: Vector, toward: Vector, size: float = HEAD_LENGTH) -> Outline:
    """A slender filled arrowhead of a length."""
    back, across = tip - toward * size, toward.turned() * (_HEAD_SHARE * size / 2)
    return Outline((tip, back + across, back - across), None, "black")


def draw_arrow(start: Vector, end: Vector, heads: int = 1) -> tuple[Primitive, ...]:
    """A straight arrow for a given motion, with so many heads one behind the other."""
    toward = unit(end - start)
    shaft = Strokes(((start, end - toward * HEAD_LENGTH * 0.8),), FIRM)
    tips = [end - toward * (index * _HEAD_STEP) for index in range(heads)]
    return (shaft, *(draw_arrowhead(tip, toward) for tip in tips))


def draw_curved_arrow(bow: Bow, heads: int = 1, *, sought: bool = False) -> tuple[Primitive, ...]:
    """An arrow along a circular arc for a rotation, with so many heads; dashed, with open heads,
    where that is `sought`.
    """
    turn = (1 if bow.sweep > 0 else -1) / bow.radius
    end = bow.start + bow.sweep
    shaft = replace(bow, sweep=bow.sweep - turn * HEAD_LENGTH * 0.7, pen=DASHED if sought else FIRM)
    tips = [end - turn * index * _HEAD_STEP for index in range(heads)]
    filled = [_draw_curved_head(bow, tip, turn * HEAD_LENGTH) for tip in tips]
    if sought:
        return (shaft, *(replace(head, pen=OPEN, fill="white") for head in filled))
    return (shaft, *filled)


def draw_arc_head(bow: Bow) -> Outline:
    """The head at the end of an arc, smaller on a short one."""
    size = min(HEAD_LENGTH, _HEAD_OF_ARC * abs(bow.sweep) * bow.radius)
    turn = (size if bow.sweep > 0 else -size) / bow.radius
    return _draw_curved_head(bow, bow.start + bow.sweep, turn)


def _draw_curved_head(bow: Bow, at: float, turn: float) -> Outline:
    """The head of a curved arrow whose tip is at an angle: along the chord beneath it, which spans
    the angle `turn`.
    """
    tip, base = (bow.centre + polar(angle, bow.radius) for angle in (at, at - turn))
    return draw_arrowhead(tip, unit(tip - base), abs(turn) * bow.radius)
