"""Following a path: from the instant in one sense of the input, by tangents and Newton's method.

The way along the path is the parameter, so that dead points of the input are found as those where
it turns back. A step is taken again, half as long, where the corrected tangent differs much from
the predicted one: so the path stays on the branch of the instant.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from kinegrade.motion.system import Row, System

_LEAST = 1e-9
_SOLVED = 1e-14  # of what passes through zero
_MET = 1e-15
_NEARLY = 1e-12
_NARROW = 1e-8
_GOLDEN = 0.6180339887498949
_STRAIGHT = 0.985  # the cosine of ten degrees


class Knot(NamedTuple):
    """A position on a path, the direction of the path there, and how far it is from a crossing with
    another path: the least over the greatest singular value, which is zero at a crossing and has
    another sign beyond it.
    """

    unknowns: Row
    tangent: Row
    regularity: float


class Met(NamedTuple):
    """A position that meets the conditions, and their derivatives there."""

    unknowns: Row
    rows: Row


class Stretch(NamedTuple):
    """From one knot to the next one."""

    start: Knot
    end: Knot


def begin(system: System, sense: int) -> Knot:
    """The instant, with the direction in which the input goes forwards (1) or back (-1)."""
    unknowns = np.zeros(len(system.units))
    forwards = np.zeros(len(system.units))
    forwards[-1] = sense
    return _make_knot(system, Met(unknowns, system.evaluate(unknowns)[1]), forwards)


def advance(system: System, knot: Knot, length: float) -> tuple[Knot, float] | None:
    """The next knot, at most `length` further, and the length that was taken; None where no
    position further on meets the conditions.
    """
    while length > _LEAST:
        found = reach(system, knot, length)
        if found is not None and found.tangent @ knot.tangent > _STRAIGHT:
            return found, length
        length /= 2
    return None


def reach(system: System, knot: Knot, length: float) -> Knot | None:
    """The position at that length along the tangent of a knot, None where Newton's method finds
    none.
    """
    found = _correct(system, knot.unknowns + knot.tangent * length, knot.tangent)
    if found is None or np.linalg.norm(found.unknowns - knot.unknowns) > 1.5 * length:
        return None
    return _make_knot(system, found, knot.tangent)


def reach_input(system: System, knot: Knot, start: Row, goal: float) -> Knot | None:
    """The knot near `start`, after another one, at which the input's unknown is `goal`."""
    found = _meet(system, start, goal)
    return None if found is None else _make_knot(system, found, knot.tangent)


def meet_input(system: System, start: Row, goal: float) -> Row | None:
    """The position near `start` at which the input's unknown is `goal`; None where there is
    none.
    """
    found = _meet(system, start, goal)
    return None if found is None else found.unknowns


def _meet(system: System, start: Row, goal: float) -> Met | None:
    """The same position, with the derivatives there."""
    across = np.zeros_like(start)
    across[-1] = 1.0
    return _correct(system, np.append(start[:-1], goal), across)


def find_sign_change(system: System, stretch: Stretch, measure: Callable[[Knot], float]) -> Knot:
    """The knot between the two of a stretch at which a measure passes through zero, by chords and
    by halving.
    """
    along = float((stretch.end.unknowns - stretch.start.unknowns) @ stretch.start.tangent)
    low, high = 0.0, along
    at_low, at_high = measure(stretch.start), measure(stretch.end)
    best = stretch.end
    for _ in range(80):
        chord = low - at_low * (high - low) / (at_high - at_low)
        middle = chord if np.isfinite(chord) else (low + high) / 2
        knot = reach(system, stretch.start, middle) if low < middle < high else None
        if knot is None:
            return best
        best, value = knot, measure(knot)
        if abs(value) < _SOLVED or high - low < _SOLVED:
            return best
        if (value < 0) == (at_low < 0):
            low, at_low, at_high = middle, value, at_high / 2
        else:
            high, at_high, at_low = middle, value, at_low / 2
    return best


def find_least(system: System, stretch: Stretch, measure: Callable[[Knot], float]) -> Knot:
    """The knot between the two of a stretch at which a measure is least, by golden sections."""
    low = 0.0
    high = float((stretch.end.unknowns - stretch.start.unknowns) @ stretch.start.tangent)
    best = min(stretch, key=measure)
    while high - low > _NARROW:
        cut = (high - low) * _GOLDEN
        inner = [reach(system, stretch.start, at) for at in (high - cut, low + cut)]
        first, second = (np.inf if knot is None else measure(knot) for knot in inner)
        low, high = (low, low + cut) if first <= second else (high - cut, high)
        best = min((best, *(knot for knot in inner if knot is not None)), key=measure)
    return best


def _correct(system: System, guess: Row, across: Row) -> Met | None:
    """The position near a guess, at a right angle to `across`; None where there is none."""
    unknowns = guess
    for _ in range(12):
        missed, rows = system.evaluate(unknowns)
        if not np.isfinite(missed).all():
            return None
        if np.abs(missed).max() < _MET:
            return Met(unknowns, rows)  # near a crossing, a further step would only stray
        square = np.vstack([rows, across])
        step = np.linalg.lstsq(square, np.append(-missed, 0.0), rcond=1e-13)[0]
        unknowns = unknowns + step
        if np.abs(step).max() < _NEARLY:
            missed, rows = system.evaluate(unknowns)
            return Met(unknowns, rows) if np.abs(missed).max() < _NEARLY / 10 else None
    return None


def _make_knot(system: System, met: Met, before: Row) -> Knot:
    """The knot at a position; its tangent goes on from the one `before`."""
    unknowns, rows = met
    _, sizes, ways = np.linalg.svd(rows)
    tangent = ways[-1] if ways[-1] @ before >= 0 else -ways[-1]
    square = np.vstack([rows[system.independent], tangent])
    size = float(sizes[len(system.rates) - 1] / sizes[0])
    return Knot(unknowns, tangent, math.copysign(size, np.linalg.slogdet(square)[0]))
