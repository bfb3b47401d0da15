"""The decisions on all answers of some rows, side by side: what `block_judge` fills in.

`marks` adds up the points, `answer_lines` writes them. They hold arrays rather than an object for
each answer, because a large class gives a million answers.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import get_args

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.keys import Paper
from kinegrade.grading.fast.bounds import Flags, Places
from kinegrade.grading.fast.comparison import Comparison
from kinegrade.grading.fast.reasons import read_cells, read_reasons
from kinegrade.grading.fast.typed_cells import TypedCells
from kinegrade.grading.judging.decision import Decision
from kinegrade.grading.judging.judge import Kind, Verdict
from kinegrade.grading.sheets.sheet import Entry
from kinegrade.language import Language
from kinegrade.language.message import Text

Row = tuple[Paper, Entry]
NO_SHARE, FULL_SHARE = 0, 1  # indices into `JudgedBlock.credits`
USUAL_CREDITS = 2  # the length of `credits` if every answer has all or nothing
KINDS: tuple[Kind, ...] = get_args(Kind)
_NUMBERS = {kind: number for number, kind in enumerate(KINDS)}


@dataclass(frozen=True, slots=True)
class JudgedBlock:
    """All answers of some rows, row after row: the kinds of the verdicts, as indices into `KINDS`,
    and the shares of the points, as indices into `credits`, which holds the few distinct ones.

    Where an answer is `compared`, its reason is its place in the `comparison`, in the words of
    `language`; of the others `reasons` are those that are not empty. `mistakes` are those that lead
    to the answers at some places, `by_policy` is where the rule was not the paper's. `worded` are
    comparisons that have been put in words already.
    """

    rows: Sequence[Row]
    cells: TypedCells
    comparison: Comparison
    language: Language
    kinds: NDArray[np.uint8]
    shares: NDArray[np.intp]
    compared: Flags
    by_policy: Flags
    reasons: dict[int, Text] = field(default_factory=dict)
    credits: list[Fraction] = field(default_factory=lambda: [Fraction(0), Fraction(1)])
    mistakes: dict[int, tuple[str, ...]] = field(default_factory=dict)
    worded: dict[int, str] = field(default_factory=dict)

    @classmethod
    def begin(
        cls, rows: Sequence[Row], cells: TypedCells, comparison: Comparison, language: Language
    ) -> JudgedBlock:
        """A block in which every answer is blank."""
        count = len(cells.typed)
        blank = np.full(count, _NUMBERS["blank"], dtype=np.uint8)
        shares = np.full(count, NO_SHARE, dtype=np.intp)
        compared, by_policy = (np.zeros(count, dtype=np.bool_) for _ in range(2))
        return cls(rows, cells, comparison, language, blank, shares, compared, by_policy)

    def kind(self, place: int) -> Kind:
        """The kind of the verdict on an answer."""
        return KINDS[int(self.kinds[place])]

    def are(self, *kinds: Kind) -> Flags:
        """Where the verdict is of one of these kinds."""
        found: Flags = np.isin(self.kinds, [_NUMBERS[kind] for kind in kinds])
        return found

    def put(self, place: int, decision: Decision) -> None:
        """Sets the decision on an answer."""
        verdict, share = decision
        self.kinds[place] = _NUMBERS[verdict.kind]
        self.compared[place] = False
        self.by_policy[place] = verdict.by_policy
        self.reasons[place] = verdict.reason
        self.mistakes[place] = verdict.mistakes
        self.put_share(place, share)

    def put_mistakes(
        self, places: Sequence[int], mistakes: Sequence[tuple[str, ...]], reasons: Sequence[str]
    ) -> None:
        """Sets answers to which mistakes lead, without points."""
        chosen = np.array(places, dtype=np.intp)
        self.kinds[chosen] = _NUMBERS["mistake"]
        self.shares[chosen] = NO_SHARE
        self.compared[chosen] = self.by_policy[chosen] = False
        self.mistakes.update(zip(places, mistakes, strict=True))
        self.reasons.update(zip(places, reasons, strict=True))

    def put_compared(self, places: Places, by_policy: Flags) -> None:
        """Sets answers that are certainly right or wrong by the key, or by the policy's rule."""
        right = self.comparison.right[places]
        self.kinds[places] = np.where(right, _NUMBERS["right"], _NUMBERS["wrong"])
        self.shares[places] = np.where(right, FULL_SHARE, NO_SHARE)
        self.compared[places] = True
        self.by_policy[places] = by_policy

    def put_share(self, place: int, share: Fraction) -> None:
        """Sets the share of the points of an answer."""
        if not share:
            self.shares[place] = NO_SHARE
            return
        if share not in self.credits:
            self.credits.append(share)
        self.shares[place] = self.credits.index(share)

    def write_compared(self) -> list[str]:
        """The reasons of all answers that are compared, in their order, as cells of a CSV file."""
        words = np.empty(len(self.compared), dtype=object)
        for by_policy, places in self._part_by_policy(np.flatnonzero(self.compared)):
            forms = read_cells(self.language, by_policy=by_policy)
            words[places] = self.comparison.reasons(places, forms)
        listed: list[str] = words[self.compared].tolist()
        return listed

    def word(self, places: Places) -> None:
        """Puts the comparisons at these places in words, all at once: one by one takes longer."""
        for by_policy, chosen in self._part_by_policy(places[self.compared[places]]):
            forms = read_reasons(self.language, by_policy=by_policy)
            reasons = self.comparison.reasons(chosen, forms)
            self.worded.update(zip(chosen.tolist(), reasons, strict=True))

    def _part_by_policy(self, places: Places) -> Iterator[tuple[bool, Places]]:
        """Those judged by the paper's rule, and those by the policy's; neither is empty."""
        for by_policy in (False, True):
            chosen = places[self.by_policy[places] == by_policy]
            if len(chosen):
                yield by_policy, chosen

    def reason(self, place: int) -> Text:
        """Why an answer is what it is."""
        if not self.compared[place]:
            return self.reasons.get(place, "")
        if place in self.worded:
            return self.worded[place]
        forms = read_reasons(self.language, by_policy=bool(self.by_policy[place]))
        (reason,) = self.comparison.reasons(np.array([place]), forms)
        return reason

    def decision(self, place: int) -> Decision:
        """The decision on an answer."""
        verdict = Verdict(
            self.kind(place),
            self.reason(place),
            mistakes=self.mistakes.get(place, ()),
            by_policy=bool(self.by_policy[place]),
        )
        return verdict, self.credits[self.shares[place]]
