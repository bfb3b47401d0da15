"""The reachable range of an input: a path followed from the instant to its ends."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from kinegrade.errors import MechanismError
from kinegrade.language.message import Message
from kinegrade.motion.alignment import describe_alignment
from kinegrade.motion.ends import Blocked, ChangePoint, Closed, End, Limit, Open, Receding
from kinegrade.motion.following import (
    Knot,
    Stretch,
    advance,
    begin,
    find_least,
    find_sign_change,
    reach_input,
)
from kinegrade.motion.system import System

_STEP = 0.08  # rad, or sizes of the mechanism
_MOST_KNOTS = 3000
_MOST_TURNS = 12
_FAR = 8.0  # sizes of the mechanism
_SAME = 1e-9
_NEAR = 0.03  # the regularity of knots on both sides of a crossing
_CROSSING = 1e-5  # nearer to a crossing, Newton's method strays along the other path
_LEAST = 1e-3  # of the way: what tolerances alone make of an instant


class Trace(NamedTuple):
    """The knots of a path in the order of the input, where it begins (None where that is
    the instant, as nothing stops it) and ends, and its change points.
    """

    knots: tuple[Knot, ...]
    start: End | None
    end: End
    changes: tuple[ChangePoint, ...]


def trace_path(system: System) -> Trace:
    """The whole path through the instant. Raises MechanismError where it is the only position."""
    ahead, end = _follow(system, 1)
    if isinstance(end, Closed) or (ahead.turns and isinstance(end, Open)):
        return Trace(tuple(ahead.knots), None, end, tuple(ahead.changes))
    back, start = _follow(system, -1)
    knots = (*(_reverse(knot) for knot in reversed(back.knots[1:])), *ahead.knots)
    return Trace(knots, start, end, (*reversed(back.changes), *ahead.changes))


def _reverse(knot: Knot) -> Knot:
    """A knot of a path that is walked the other way."""
    return Knot(knot.unknowns, -knot.tangent, knot.regularity)


def _follow(system: System, sense: int) -> tuple[_Half, End]:
    """The path in one sense of the input, and where it ends."""
    half = _Half(system, sense)
    length, end = _STEP, None
    while end is None:
        found = advance(system, half.knots[-1], length)
        if found is None:
            return half, half.block()
        end = half.add(found[0])
        length = min(1.5 * found[1], _STEP)
    return half, end


def _measure_regularity(knot: Knot) -> float:
    """How far a knot is from a crossing, on either side of it."""
    return abs(knot.regularity)


class _Half:
    """A path in one sense as far as it has been followed."""

    def __init__(self, system: System, sense: int) -> None:
        self.system, self.sense = system, sense
        self.knots = [begin(system, sense)]
        self.changes: list[ChangePoint] = []
        self.turns = 0

    def add(self, knot: Knot) -> End | None:
        """Take the next knot, or the one before it at which the path ends; gives that end."""
        stretch = Stretch(self.knots[-1], knot)
        if stretch.start.tangent[-1] * knot.tangent[-1] < 0:
            return self._turn_back(stretch)
        if stretch.start.regularity * knot.regularity < 0:
            self._note_change(stretch)
        passed = self._find_turn(knot)
        if passed is not None:
            return self._complete_turn(stretch, passed)
        self.knots.append(knot)
        self._note_touch()
        return self._find_cut(knot)

    def block(self) -> Blocked:
        """The end at the last knot. Raises MechanismError where that is the instant."""
        if np.abs(self.knots[-1].unknowns).max() < _LEAST:
            raise MechanismError(Message("motion.instant-alone"))
        return Blocked(self._measure(self.knots[-1]))

    def _measure(self, knot: Knot) -> float:
        """How far the input has gone, rad or m."""
        return float(knot.unknowns[-1] * self.system.units[-1])

    def _turn_back(self, stretch: Stretch) -> Limit:
        """The dead point within a stretch."""
        found = find_sign_change(self.system, stretch, lambda knot: float(knot.tangent[-1]))
        self.knots.append(found)
        return Limit(self._measure(found), describe_alignment(self.system, found))

    def _note_touch(self) -> None:
        """The change point about the last knot but one at which several ways begin at once, so that
        the regularity touches zero, and has the same sign beyond.
        """
        if len(self.knots) < 3:
            return
        start, middle, end = self.knots[-3:]
        stays = start.regularity * middle.regularity > 0 < middle.regularity * end.regularity
        nearest = min(start, middle, end, key=_measure_regularity)
        if stays and nearest is middle and _measure_regularity(middle) < _NEAR:
            self._take_change(find_least(self.system, Stretch(start, end), _measure_regularity))

    def _note_change(self, stretch: Stretch) -> None:
        """The change point within a stretch."""
        found = find_sign_change(self.system, stretch, lambda knot: knot.regularity)
        self._take_change(found)

    def _take_change(self, found: Knot) -> None:
        """A change point, unless of redundant conditions some alone are dependent there."""
        if abs(found.regularity) < _CROSSING:
            line = describe_alignment(self.system, found)
            self.changes.append(ChangePoint(self._measure(found), line))

    def _find_turn(self, knot: Knot) -> float | None:
        """The unknown of the input after the next full turn, once that is reached."""
        period = self.system.input.period
        if period is None:
            return None
        goal = (self.turns + 1) * period / float(self.system.units[-1])
        return self.sense * goal if abs(knot.unknowns[-1]) >= goal - _SAME else None

    def _complete_turn(self, stretch: Stretch, goal: float) -> End | None:
        """A full turn: the path is closed, or goes on, or is cut off after very many."""
        start, end = stretch.start.unknowns, stretch.end.unknowns
        share = (goal - start[-1]) / (end[-1] - start[-1])
        found = reach_input(self.system, stretch.start, start + (end - start) * share, goal)
        if found is None:
            return self.block()
        self.knots.append(found)
        self.turns += 1
        if self._is_as_before(found):
            return Closed(self._measure(found), self.turns)
        return Open(self._measure(found)) if self.turns == _MOST_TURNS else None

    def _is_as_before(self, knot: Knot) -> bool:
        """Whether every body is where it was at the instant, whole turns apart."""
        values = knot.unknowns[:-1]
        turns = np.array([rate.kind in ("turning", "circling") for rate in self.system.rates])
        rest = np.where(turns, values - math.tau * np.round(values / math.tau), values)
        return bool(np.abs(rest).max() < _SAME)

    def _find_cut(self, knot: Knot) -> End | None:
        """The end where a part is very far away, or nothing stops a part that goes round."""
        turning = np.array([rate.kind == "turning" for rate in self.system.rates])
        circling = np.array([rate.kind == "circling" for rate in self.system.rates])
        values, gone = np.abs(knot.unknowns[:-1]), self._measure(knot)
        if values[~(turning | circling)].max(initial=0.0) > _FAR:
            return Receding(gone)
        if len(self.knots) > _MOST_KNOTS:
            return Open(gone) if self.turns else Receding(gone)
        if self.system.input.period is not None:
            return None
        round_once = values[turning].max(initial=0.0) >= math.tau
        return Open(gone) if round_once or abs(knot.unknowns[-1]) > _FAR / 2 else None
