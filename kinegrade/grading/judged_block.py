"""The answers of many students, judged: the verdict and the share of the points for each.

`block_judge` makes such blocks and `marks` works with them. They hold lists rather than an object
for each answer, because a large class gives a million answers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction

from kinegrade.exam.folder.keys import Paper
from kinegrade.grading.decision import Decision
from kinegrade.grading.judge import Kind, Verdict
from kinegrade.grading.sheet import Entry
from kinegrade.grading.typed_cells import TypedCells

Row = tuple[Paper, Entry]
NO_SHARE, FULL_SHARE = 0, 1  # indices into `JudgedBlock.credits`
USUAL_CREDITS = 2  # the length of `credits` if every answer has all or nothing


@dataclass(frozen=True, slots=True)
class JudgedBlock:
    """All answers of some rows, row after row: the kinds and reasons of the verdicts, and the
    shares of the points.

    Each of `shares` is an index into `credits`, which holds the few distinct values.
    """

    rows: Sequence[Row]
    cells: TypedCells
    kinds: list[Kind]
    reasons: list[str]
    shares: list[int]
    credits: list[Fraction] = field(default_factory=lambda: [Fraction(0), Fraction(1)])

    def put(self, place: int, decision: Decision) -> None:
        """Sets the decision on an answer."""
        verdict, share = decision
        self.set(place, verdict.kind, verdict.reason, share)

    def set(self, place: int, kind: Kind, reason: str, share: Fraction) -> None:
        """The same without creating a verdict."""
        self.kinds[place], self.reasons[place] = kind, reason
        if not share:
            self.shares[place] = NO_SHARE
            return
        if share not in self.credits:
            self.credits.append(share)
        self.shares[place] = self.credits.index(share)

    def decision(self, place: int) -> Decision:
        """The decision on an answer."""
        return Verdict(self.kinds[place], self.reasons[place]), self.credits[self.shares[place]]
