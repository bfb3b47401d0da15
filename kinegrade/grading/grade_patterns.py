"""The grades that are given in a class: few patterns, each added up once."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache, partial

import msgspec
import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.asks import Ask, add_counted
from kinegrade.grading.fast.judged_block import USUAL_CREDITS, JudgedBlock
from kinegrade.grading.sheets.rows import Rows
from kinegrade.marks_folder.rows import Grade
from kinegrade.numbers.amounts import add_amounts


@dataclass(frozen=True, slots=True)
class GradePatterns:
    """The grades that were given so far, of no student, for `asks` that have their points under
    the policy, `questions` as ranges of these, and the maximum.

    `known` are the numbers of those of rows in which every answer gets all or nothing, by their
    indices into `JudgedBlock.credits`.
    """

    asks: tuple[Ask, ...]
    questions: Sequence[range]
    out_of: Fraction
    grades: list[Grade] = field(default_factory=list)
    known: dict[Hashable, int] = field(default_factory=dict)

    def find(self, rows: Rows, judged: JudgedBlock) -> list[int]:
        """The number of the pattern of each row; there are few, and each is added up once."""
        known = self.known if len(judged.credits) == USUAL_CREDITS else {}
        add_up = lru_cache(maxsize=None)(partial(self._question_points, judged))
        shares, lacking = judged.shares.reshape(-1, len(self.asks)), rows.papers.lacking
        keys: list[Hashable] = [*_list_keys(shares)]
        for row, lacks in lacking.items():
            keys[row] = keys[row], lacks
        different = dict(zip(keys, range(len(keys)), strict=True))
        for key, row in different.items():
            if key in known:
                continue
            known[key] = len(self.grades)
            self.grades.append(self._add_up(shares[row], lacking.get(row, frozenset()), add_up))
        return [known[key] for key in keys]

    def _add_up(
        self,
        shares: NDArray[np.intp],
        lacks: frozenset[int],
        add_up: Callable[[range, tuple[int, ...]], Fraction],
    ) -> Grade:
        """The points of the questions that a paper holds, None for others, and the maximum."""
        way = tuple(shares.tolist())
        points = [add_up(each, way[each.start : each.stop]) for each in self.questions]
        if not lacks:
            return Grade("", "", tuple(points), self.out_of)
        asked = [ask for number, ask in enumerate(self.asks) if number not in lacks]
        held = {ask.question for ask in asked}
        own = tuple(
            each if self.asks[question.start].question in held else None
            for question, each in zip(self.questions, points, strict=True)
        )
        return Grade("", "", own, add_counted(asked))

    def _question_points(
        self, judged: JudgedBlock, question: range, way: tuple[int, ...]
    ) -> Fraction:
        """The points of a question whose asks have these shares."""
        return add_amounts(
            judged.credits[share] * self.asks[number].points
            for number, share in zip(question, way, strict=True)
            if share
        )

    def change(self, number: int, **changes: object) -> int:
        """The number of a pattern that differs from another one so."""
        self.grades.append(msgspec.structs.replace(self.grades[number], **changes))
        return len(self.grades) - 1


def _list_keys(shares: NDArray[np.intp]) -> list[bytes]:
    """A key for each row of shares, the same where all of them are."""
    rows = shares.astype(np.uint16)
    keys: list[bytes] = rows.view(f"V{rows.itemsize * rows.shape[1]}").ravel().tolist()
    return keys
