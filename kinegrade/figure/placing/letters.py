"""The letter of a point: close to it, where nothing parts the two, else at a leader."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

import numpy as np

from kinegrade.figure.placing.aligned import runs_on
from kinegrade.figure.placing.crossing import Boxed
from kinegrade.figure.placing.obstacles import Obstacles, Segment
from kinegrade.figure.placing.place import Placed, Wish, place_label
from kinegrade.figure.placing.wedge import rate_cut_off
from kinegrade.figure.plane import parts, unit
from kinegrade.figure.scene import Label
from kinegrade.figure.symbols.pins import reach_half_pin
from kinegrade.mechanics.vector import Vector

# Millimetres from which on a letter has a leader, and of paper at its two ends
_STANDS_OFF, _BEFORE, _SHORT_OF = 3.3, 0.2, 1.3
# The same for a point amid teeth, where it has a dot, and where a shorter leader is like a tooth
_STANDS_OFF_AMID, _AT_DOT = 3.0, 0.8
_BEHIND_WALL = 2.6  # the same for a letter behind a wall
_BEHIND = 20.0  # demerit of a letter behind a wall, as of one that may be read as another's
_RUNS_ON = 9.0  # demerit of a letter whose leader would seem to run on from another line
# Millimetres of a leader past the rim that it crosses, and of the radius of a rim at least
_PAST_RIM, _LEAST_RIM = 0.9, 2.0
_FAR = 2.9  # millimetres from which on a letter is looked a place closer to its point


def place_letter(wish: Wish, obstacles: Obstacles) -> Placed:
    """The letter of a point, for which one that would stand off from it, or behind a wall, is
    found a place closer to it, or before the wall, if there is any.
    """
    placed = place_label(wish, obstacles)
    if wish.names is None or wish.closely is None:
        return placed
    if _measure_off(placed.label, wish.names) >= _FAR:
        nearer = place_label(wish.closely(_STANDS_OFF_AMID if wish.amid else _FAR), obstacles)
        placed = placed if nearer.faulty else nearer
    if not _lies_behind(placed.label, wish.names, wish.walls):
        return placed
    before = place_label(_keep_before(wish.walls, wish.closely(_STANDS_OFF), wish.names), obstacles)
    return placed if before.faulty else before


def _lies_behind(label: Label, point: Vector, walls: Sequence[Segment]) -> bool:
    """Whether a wall passes between a label and a point."""
    return any(parts(*wall, label.centre, point) for wall in walls)


def is_astray(label: Label, wish: Wish) -> bool:
    """Whether the letter of a point stands off from it, and a wall passes between them."""
    if wish.names is None or _measure_off(label, wish.names) < _STANDS_OFF:
        return False
    return _lies_behind(label, wish.names, wish.walls)


def _keep_before(walls: Sequence[Segment], close: Wish, point: Vector) -> Wish:
    """The wish for a letter close to a point, which has a fault behind a wall."""
    feet = np.tile(np.array(point), (len(close.spots), 1))
    behind = _BEHIND * rate_cut_off(close.spots, feet, walls)
    return close.worse_by(behind)


def keep_off_lines(wish: Wish, lines: Sequence[Segment], rings: Sequence[Boxed]) -> Wish:
    """The wish of a point's letter, rather not where its leader would be misread."""
    labels = [wish.label_at(spot) for spot in range(len(wish.spots))]
    leaders = [trace_wished_leader(wish, label) for label in labels]
    misread = [bool(leader and is_misread(leader, lines, rings)) for leader in leaders]
    return wish.worse_by(_RUNS_ON * np.array(misread))


def is_misread(leader: Segment, lines: Sequence[Segment], rings: Sequence[Boxed]) -> bool:
    """Whether a leader would seem to run on from one of the thin lines, or, where it ends at one of
    the rings, to be a radius that is drawn, whose end has the letter.
    """
    return runs_on(leader, lines) or any(_stops_at(leader, *ring[:4]) for *_, ring in rings)


def _stops_at(leader: Segment, x: float, y: float, _: float, radius: float) -> bool:
    """Whether a leader from within a circle ends at it."""
    outer, inner = (hypot(at.x - x, at.y - y) for at in leader)
    return inner < radius > _LEAST_RIM and abs(outer - radius) < _PAST_RIM


def trace_wished_leader(wish: Wish, label: Label) -> Segment | None:
    """The leader of a letter that names a point and stands off from it."""
    if wish.names is None:
        return None
    line = trace_leader(label, wish.names, wish.walls, amid=wish.amid > 0)
    if line is None or wish.pin_side is None:
        return line
    start, away = line[0], unit(line[0] - wish.names)
    return start, wish.names + away * reach_half_pin(away, wish.pin_side)


def trace_leader(
    label: Label, point: Vector, walls: Sequence[Segment] = (), *, amid: bool = False
) -> Segment | None:
    """The thin line from a label that stands off to just before its point; None where it is near
    enough to be read as that point's, which it is less far off `amid` other things and behind one
    of the walls.
    """
    least = _STANDS_OFF_AMID if amid else _STANDS_OFF
    if _measure_off(label, point) < least:
        behind = _measure_off(label, point) >= _BEHIND_WALL and _lies_behind(label, point, walls)
        if not behind:
            return None
    across, upward = point - label.centre
    wide, high = label.width / 2, label.height / 2
    share = min(wide / max(abs(across), 1e-9), high / max(abs(upward), 1e-9))
    toward = (point - label.centre) / hypot(across, upward)
    start = label.centre + (point - label.centre) * share + toward * _BEFORE
    return start, point - toward * (_AT_DOT if amid else _SHORT_OF)


def _measure_off(label: Label, point: Vector) -> float:
    """Millimetres of paper between a label and a point."""
    across, upward = label.centre - point
    wide, high = label.width / 2, label.height / 2
    return hypot(max(abs(across) - wide, 0.0), max(abs(upward) - high, 0.0))
