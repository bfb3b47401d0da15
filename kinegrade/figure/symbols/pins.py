"""Revolute joints: pins, their stands on the ground, knife edges, and marked points."""

from __future__ import annotations

from math import pi, sqrt

from kinegrade.figure.plane import angle_of, length, unit
from kinegrade.figure.scene import BOLD, FIRM, THIN, Bow, Disc, Outline, Primitive, Strokes
from kinegrade.figure.symbols.ground import draw_ground
from kinegrade.mechanics.vector import Vector

PIN = 0.85  # radius of a pin's circle
_HALF_PIN = 1.15
_HOLE = 0.35  # less than half a bar, which is seen to run on at both sides of it
DOT = 0.75  # radius of the dot of a marked point
# Heights of a fixed pin's stand, of one that fits into the smallest wheel, and of one about whose
# pin a sleeve turns, which hides its top
STAND, SMALL_STAND, STAND_OF_SLEEVE = 3.6, 2.2, 6.2
_HALF_BASES = {STAND: 2.6, SMALL_STAND: 1.3, STAND_OF_SLEEVE: 2.3}


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


def draw_centre_mark(at: Vector) -> tuple[Primitive, ...]:
    """A small upright cross."""
    arms = (Vector(1.1, 0.0), Vector(0.0, 1.1))
    return (Strokes(tuple((at - arm, at + arm) for arm in arms), THIN),)


def draw_dot(at: Vector, radius: float = DOT) -> tuple[Primitive, ...]:
    """A marked point that is not a joint; the usual one is wider than a bar, which it does not
    interrupt.
    """
    return (Disc(at, radius, None, "black"),)
