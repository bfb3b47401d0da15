"""The fast twin of `numbers.tolerance.Tolerance`: what is right by thousands of rules at once, in
double precision.

`comparison` uses it, and `reports.sharing` to find whose answers fit which papers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.columns.runs import find_begins, list_runs
from kinegrade.numbers.tolerance import Tolerance

Numbers = NDArray[np.float64]
Flags = NDArray[np.bool_]
Places = NDArray[np.intp]

ROUNDING = 1e-15  # relative error of a few operations in double precision, or of reading a number
GUARD = 1e-9  # of the numbers compared: a bound nearer than this decides nothing
HALF = 1e-6  # of the last digit written: anything this close to a half may be rounded either way


@dataclass(frozen=True, slots=True)
class Bounds:
    """The smallest and the largest right answers; `room` is what they may be off, significant
    figures aside. `to_figures` is where figures decide, too, and the bounds are certain where
    `settled` holds.
    """

    room: Numbers
    low: Numbers
    high: Numbers
    to_figures: Flags
    settled: Flags


@dataclass(frozen=True, slots=True)
class Rules:
    """A column for each rule: relative, absolute, significant figures (0 where none are asked
    for), and the widest share.
    """

    table: Numbers

    def at(self, places: Places) -> Rules:
        """The rules at these places."""
        return Rules(self.table[:, places])

    def bounds(self, centres: Numbers) -> Bounds:
        """What is right where these are the right answers."""
        relative, absolute, figures, _ = self.table
        with np.errstate(all="ignore"):
            room = np.maximum(relative * np.abs(centres), absolute)
            low, high = centres - room, centres + room
            to_figures = (figures > 0) & (centres != 0)
            if not to_figures.any():
                return Bounds(room, low, high, to_figures, ~to_figures)
            smallest, largest, settled = _find_agreeing(centres, figures)
        return Bounds(
            room,
            np.where(to_figures, np.minimum(low, smallest), low),
            np.where(to_figures, np.maximum(high, largest), high),
            to_figures,
            settled | ~to_figures,
        )

    def may_agree(self, values: Numbers, places: Places, centres: Numbers) -> Flags:
        """False only where the value at a place is certainly wrong by the centre beside it, at a
        fraction of the cost of `bounds`.
        """
        _, absolute, _, widest = self.table
        with np.errstate(all="ignore"):
            least = 1.01 * absolute + 1e-8 * np.abs(values)
            reach = least[places] + (1.01 * widest + 1e-8)[places] * np.abs(centres)
            beyond: Flags = np.abs(values[places] - centres) > reach
        return ~beyond


def tabulate_rules(papers: Sequence[tuple[Tolerance, ...]]) -> Rules:
    """The rules of these papers, one after another; most papers share one tuple of them."""
    known = {id(rules): rules for rules in papers}
    counts = np.array([*map(len, known.values())], dtype=np.intp)
    listed = [_list_numbers(rule) for rules in known.values() for rule in rules]
    table = np.array(listed, dtype=np.float64).reshape(-1, 4).T
    if len(known) == 1:
        return Rules(np.tile(table, len(papers)))
    numbers = {name: number for number, name in enumerate(known)}
    which = np.array([numbers[id(rules)] for rules in papers], dtype=np.intp)
    places = list_runs(find_begins(counts)[which], counts[which])
    return Rules(np.ascontiguousarray(table[:, places]))


def _list_numbers(rule: Tolerance) -> tuple[float, float, float, float]:
    return (
        float(rule.relative),
        float(rule.absolute),
        float(rule.figures or 0),
        rule.widest_share,
    )


def _find_agreeing(centres: Numbers, figures: Numbers) -> tuple[Numbers, Numbers, Flags]:
    """The bounds of what agrees to significant figures, and whether they are certain."""
    power = np.floor(np.log10(np.abs(centres)))
    unit = 10.0 ** (power - figures + 1)
    steps = centres / unit
    leading = np.abs(centres) / 10.0**power
    settled = (np.abs(steps - np.floor(steps) - 0.5) > HALF) & (np.abs(steps) * ROUNDING < HALF)
    settled &= (leading > 1 + GUARD) & (leading < 10 - GUARD)
    return (np.ceil(steps - 0.5) - 0.5) * unit, (np.floor(steps + 0.5) + 0.5) * unit, settled
