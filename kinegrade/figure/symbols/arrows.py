"""Arrows of motions, straight and along arcs, with their heads."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec.structs import replace

from kinegrade.figure.plane import polar, unit
from kinegrade.figure.scene import DASHED, FIRM, OPEN, Bow, Outline, Primitive, Strokes
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level

HEAD_LENGTH, _HEAD_SHARE = 2.0, 0.55  # the share that a head is wide
_GAP = 0.35  # millimetres of paper beside a head in the edge that it is drawn over
_HEAD_OF_ARC = 0.45  # largest share of an arc that its head takes
_HEAD_STEP = 1.6  # from one head of an arrow to the next
# Heads of the arrow of a velocity, and of an acceleration
HEADS: Mapping[Level, int] = {"velocity": 1, "acceleration": 2}


def draw_arrowhead(tip: Vector, toward: Vector, size: float = HEAD_LENGTH) -> Outline:
    """A slender filled arrowhead of a length."""
    back, across = tip - toward * size, toward.turned() * (_HEAD_SHARE * size / 2)
    return Outline((tip, back + across, back - across), None, "black")


def draw_gap(head: Outline) -> Outline:
    """The gap in the black edge under an arrowhead, drawn before that: paper on either side of it
    and behind it, so that it is seen where it ends.
    """
    tip, *back = head.corners
    away, across = unit((back[0] + back[1]) / 2 - tip), unit(back[0] - back[1])
    front = tip + away * _GAP
    corners = (
        front + across * _GAP,
        back[0] + (across + away / 2) * _GAP,
        back[1] + (away / 2 - across) * _GAP,
        front - across * _GAP,
    )
    return Outline(corners, None, "white")


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
