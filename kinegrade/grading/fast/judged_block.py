"""The fast twin of a list of `judging.decision.Decision`: the verdict and the share of the points
for each answer of many students.

`block_judge` makes such blocks and `marks` works with them. They hold lists rather than an object
for each answer, because a large class gives a million answers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TypeVar

import numpy as np

from kinegrade.exam.folder.keys import Paper
from kinegrade.grading.fast.bounds import Flags, Places
from kinegrade.grading.fast.typed_cells import TypedCells
from kinegrade.grading.judging.decision import Decision
from kinegrade.grading.judging.judge import Kind, Verdict
from kinegrade.grading.sheets.sheet import Entry
from kinegrade.language.message import Text

Row = tuple[Paper, Entry]
NO_SHARE, FULL_SHARE = 0, 1  # indices into `JudgedBlock.credits`
_KINDS = np.array(["wrong", "right"], dtype=object)
_Cell = TypeVar("_Cell")
USUAL_CREDITS = 2  # the length of `credits` if every answer has all or nothing


@dataclass(frozen=True, slots=True)
class JudgedBlock:
    """All answers of some rows, row after row: the kinds and reasons of the verdicts, and the
    shares of the points.

    Each of `shares` is an index into `credits`, which holds the few distinct values. `mistakes` are
    those that lead to the answers at some places, `by_policy` the places where the rule was not the
    paper's.
    """

    rows: Sequence[Row]
    cells: TypedCells
    kinds: list[Kind]
    reasons: list[Text]
    shares: list[int]
    credits: list[Fraction] = field(default_factory=lambda: [Fraction(0), Fraction(1)])
    mistakes: dict[int, tuple[str, ...]] = field(default_factory=dict)
    by_policy: set[int] = field(default_factory=set)

    def put(self, place: int, decision: Decision) -> None:
        """Sets the decision on an answer."""
        verdict, share = decision
        self.kinds[place], self.reasons[place] = verdict.kind, verdict.reason
        self.mistakes[place] = verdict.mistakes
        (self.by_policy.add if verdict.by_policy else self.by_policy.discard)(place)
        self._set_share(place, share)

    def put_mistakes(
        self, place: int, mistakes: tuple[str, ...], reason: str, share: Fraction | None
    ) -> None:
        """Sets an answer to which mistakes lead, with a share of the points if there is one."""
        self.kinds[place], self.reasons[place] = "mistake", reason
        self.mistakes[place] = mistakes
        self.by_policy.discard(place)
        if share is None:
            self.shares[place] = NO_SHARE
        else:
            self._set_share(place, share)

    def put_compared(self, places: Places, right: Flags, reasons: Sequence[str]) -> None:
        """Sets answers that are right or wrong by the key, each for its reason."""
        _set_at(self.kinds, places, _KINDS[right.astype(np.intp)].tolist())
        _set_at(self.shares, places, np.where(right, FULL_SHARE, NO_SHARE).tolist())
        _set_at(self.reasons, places, reasons)

    def _set_share(self, place: int, share: Fraction) -> None:
        if not share:
            self.shares[place] = NO_SHARE
            return
        if share not in self.credits:
            self.credits.append(share)
        self.shares[place] = self.credits.index(share)

    def decision(self, place: int) -> Decision:
        """The decision on an answer."""
        verdict = Verdict(
            self.kinds[place],
            self.reasons[place],
            mistakes=self.mistakes.get(place, ()),
            by_policy=place in self.by_policy,
        )
        return verdict, self.credits[self.shares[place]]


def _set_at(column: list[_Cell], places: Places, cells: Sequence[_Cell]) -> None:
    """Sets the cells of a column at these places, all in one step."""
    if len(places) == len(column):
        column[:] = cells
        return
    held = np.array(column, dtype=object)
    held[places] = cells
    column[:] = held.tolist()
