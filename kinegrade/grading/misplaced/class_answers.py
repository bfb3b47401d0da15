"""What a class answered, in numbers: a row for each student in the order of the roster.

`AnswersSeen` watches a marking for `grade`, block by block; what is told of a class as a whole is
found in the `ClassAnswers` that it puts together.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from kinegrade.files.tables import Complaint
from kinegrade.grading.fast.bounds import Flags, Numbers
from kinegrade.grading.judging.judge import Kind
from kinegrade.grading.marks import MarkedBlock
from kinegrade.language.message import Message

_SETTLED: tuple[Kind, ...] = ("accepted", "void")
_EXPLAINED: tuple[Kind, ...] = ("mistake", "follow-through")


@dataclass(frozen=True)
class ClassAnswers:
    """The `numbers` by row and ask, NaN where there is none; which of them are `right` on the
    student's paper, `settled` by a policy, or `explained` by what the student did; and the file and
    line of each row, 0 where it has none.
    """

    numbers: Numbers
    right: Flags
    settled: Flags
    explained: Flags
    files: Sequence[str]
    lines: Sequence[int]

    @property
    def given(self) -> Flags:
        """Which answers are numbers."""
        return ~np.isnan(self.numbers)

    @property
    def wrong(self) -> Flags:
        """Which numbers have no full credit."""
        return self.given & ~self.right & ~self.settled

    def complain(self, row: int, problem: Message, done: Message) -> Complaint:
        """A complaint of a whole row."""
        return Complaint(self.files[row], self.lines[row] or None, "", "", problem, done)


@dataclass
class AnswersSeen:
    """What has been seen so far of a marking."""

    width: int
    numbers: list[Numbers] = field(default_factory=list)
    right: list[Flags] = field(default_factory=list)
    settled: list[Flags] = field(default_factory=list)
    explained: list[Flags] = field(default_factory=list)
    files: list[str] = field(default_factory=list)
    lines: list[int] = field(default_factory=list)

    def watched(self, blocks: Iterable[MarkedBlock]) -> Iterator[MarkedBlock]:
        """The same blocks, noted on their way."""
        for block in blocks:
            judged, shape = block.judged, (-1, self.width)
            self.numbers.append(judged.cells.values.reshape(shape))
            self.right.append(judged.are("right").reshape(shape))
            self.settled.append(judged.are(*_SETTLED).reshape(shape))
            self.explained.append(judged.are(*_EXPLAINED).reshape(shape))
            self.files += judged.rows.entries.files
            self.lines += judged.rows.entries.lines.tolist()
            yield block
            del block, judged  # so that the next takes its place

    def put_together(self) -> ClassAnswers:
        """All rows, after all blocks have been watched."""
        numbers, right = np.concatenate(self.numbers), np.concatenate(self.right)
        settled, explained = np.concatenate(self.settled), np.concatenate(self.explained)
        return ClassAnswers(numbers, right, settled, explained, self.files, self.lines)
