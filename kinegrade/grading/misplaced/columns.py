"""Columns of answers that stand under another title than their own, were typed in another unit or
lack their signs.

A column of which hardly any answer is right is told with what its answers fit; so is one that fits
nothing, as its key may be wrong. No mark is changed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import pi
from typing import NamedTuple

import numpy as np

from kinegrade.files.tables import Complaint
from kinegrade.grading.fast.bounds import Flags, Numbers, Places
from kinegrade.grading.fast.intervals import Intervals
from kinegrade.grading.misplaced.class_answers import ClassAnswers
from kinegrade.language.message import Message

_LEAST_ANSWERS = 10  # of a column: fewer may all be wrong
_HARDLY_ANY = 0.05  # of the answers of a column
_MOST_OF_THEM = 0.6
_LEAST_UNSIGNED = 4  # answers that lack their minus sign in a column that has none
_OTHER_UNIT = (10, 100, 1000, 3.6, 60 / (2 * pi), 180 / pi)
_FACTORS = (-1.0, *_OTHER_UNIT, *(1 / factor for factor in _OTHER_UNIT))


class _Guess(NamedTuple):
    """What the answers of a column may be, and how many of them fit that."""

    fits: int
    what: Message


@dataclass(frozen=True)
class MisplacedColumns:
    """The answers of a class beside its papers, which are in the order of the rows, with the
    `titles` of its columns.
    """

    intervals: Sequence[Intervals]
    titles: Sequence[str]
    answers: ClassAnswers

    def list_complaints(self) -> Iterator[Complaint]:
        """A complaint for each column that was missed, then for each that lacks its signs."""
        for ask in self._missed:
            yield self._complain_of_column(ask)
        for ask in self.others:
            yield from self._complain_of_signs(ask)

    @cached_property
    def others(self) -> Sequence[int]:
        """The asks whose columns were not missed."""
        return [ask for ask in range(len(self.titles)) if ask not in self._missed]

    @cached_property
    def _missed(self) -> Sequence[int]:
        return [ask for ask in range(len(self.titles)) if self._is_missed(ask)]

    @cached_property
    def _given(self) -> Flags:
        return self.answers.given

    @cached_property
    def _right(self) -> Flags:
        """Which numbers have full credit."""
        return self._given & ~self.answers.wrong

    def _is_missed(self, ask: int) -> bool:
        """Whether hardly any of enough answers is right."""
        given = int(self._given[:, ask].sum())
        right = int(self._right[:, ask].sum())
        return given >= _LEAST_ANSWERS and right <= _HARDLY_ANY * given

    def _complain_of_column(self, ask: int) -> Complaint:
        rows = np.flatnonzero(self._given[:, ask])
        answers = self.answers.numbers[rows, ask]
        best = max(self._guess(ask, rows, answers), key=lambda guess: guess.fits)
        right = int(self._right[rows, ask].sum())
        problem = Message("marking.column-missed", count=len(rows), right=right)
        if best.fits >= _MOST_OF_THEM * len(rows):
            kinds = {"count": len(rows), "right": right, "fits": best.fits}
            problem = Message("marking.column-misplaced", **kinds, what=best.what)
        first, done = int(rows[0]), Message("marking.check-column-or-key")
        return Complaint(self.answers.files[first], None, self.titles[ask], "", problem, done)

    def _complain_of_signs(self, ask: int) -> Iterator[Complaint]:
        """That no number of a column has a minus sign, and those which need one lack it."""
        given = self._given[:, ask]
        if (self.answers.numbers[given, ask] < 0).any():
            return
        own = self.intervals[ask].high[: len(given)]  # those of a pool stand behind
        rows = np.flatnonzero(given & (own < 0))
        fits = self._count_fits(ask, rows, -self.answers.numbers[rows, ask])
        if fits >= max(_LEAST_UNSIGNED, _MOST_OF_THEM * len(rows)):
            problem = Message("marking.signs-lost", count=len(rows), fits=fits)
            file, done = self.answers.files[int(rows[0])], Message("marking.check-column")
            yield Complaint(file, None, self.titles[ask], "", problem, done)

    def _guess(self, ask: int, rows: Places, answers: Numbers) -> Iterator[_Guess]:
        """What the answers of a column may be: those to another ask, or in another unit."""
        for other, title in enumerate(self.titles):
            if other != ask:
                fits = self._count_fits(other, rows, answers)
                yield _Guess(fits, Message("marking.as-answer-to", column=title))
        for factor in _FACTORS:
            fits = self._count_fits(ask, rows, answers * factor)
            if factor == -1:
                yield _Guess(fits, Message("marking.with-other-sign"))
            else:
                yield _Guess(fits, Message("marking.times-factor", factor=f"{factor:.4g}"))

    def _count_fits(self, ask: int, rows: Places, answers: Numbers) -> int:
        """How many of these answers are right there; about zero any small number is, which tells
        nothing.
        """
        intervals = self.intervals[ask]
        telling = intervals.low[rows] * intervals.high[rows] > 0
        return int((telling & intervals.fit_beside(answers, rows)).sum())
