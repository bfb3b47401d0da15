"""The answers of many students, judged: what has become of each.

`block_judge` makes such blocks and `marks` works with them. They are lists rather than an object
for every answer, because a large class gives a million answers.
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
NO_SHARE, FULL_SHARE = 0, 1  # places in `JudgedBlock.credits`
USUAL_CREDITS = 2  # as many there are where every answer has all or nothing


@dataclass(frozen=True, slots=True)
class JudgedBlock:
    """All answers of some rows, row after row: the kinds and reasons of the verdicts, and the
    shares of the points.

    Each of `shares` is a place in `credits`, which holds the few that there are.
    """

    rows: Sequence[Row]
    cells: TypedCells
    kinds: list[Kind]
    reasons: list[str]
    shares: list[int]
    credits: list[Fraction] = field(default_factory=lambda: [Fraction(0), Fraction(1)])

    def put(self, place: int, decision: Decision) -> None:
        """Sets what became of an answer."""
        verdict, share = decision
        self.set(place, verdict.kind, verdict.reason, share)

    def set(self, place: int, kind: Kind, reason: str, share: Fraction) -> None:
        """The same without a verdict made for it."""
        self.kinds[place], self.reasons[place] = kind, reason
        if not share:
            self.shares[place] = NO_SHARE
            return
        if share not in self.credits:
            self.credits.append(share)
        self.shares[place] = self.credits.index(share)

    def decision(self, place: int) -> Decision:
        """What became of an answer."""
        return Verdict(self.kinds[place], self.reasons[place]), self.credits[self.shares[place]]
