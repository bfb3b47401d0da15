"""Papers that are marked together, which say together whose they are and what their keys are."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice
from typing import overload

from kinegrade.exam.folder.columns.part import KeyPart, PartKeys
from kinegrade.exam.folder.keys import Keys
from kinegrade.exam.folder.papers import Paper, PaperBlock
from kinegrade.exam.folder.records import Candidate
from kinegrade.numbers.tolerance import Tolerance


@dataclass(frozen=True)
class ListedPapers(PaperBlock):
    """Papers that are held one by one."""

    listed: Sequence[Paper]

    def __len__(self) -> int:
        return len(self.listed)

    @overload
    def __getitem__(self, row: int) -> Paper: ...

    @overload
    def __getitem__(self, row: slice) -> ListedPapers: ...

    def __getitem__(self, row: int | slice) -> Paper | ListedPapers:
        return ListedPapers(self.listed[row]) if isinstance(row, slice) else self.listed[row]

    @cached_property
    def students(self) -> Sequence[str]:
        """Whose they are."""
        return [paper.student for paper in self.listed]

    @property
    def names(self) -> Sequence[str]:
        """The names of these students."""
        return [paper.name for paper in self.listed]

    @cached_property
    def keys(self) -> Sequence[Keys]:
        """Their keys."""
        return [paper.keys for paper in self.listed]

    @cached_property
    def lacking(self) -> Mapping[int, frozenset[int]]:
        """Those that do not hold every question, with the numbers of the asks that they lack."""
        return {row: lacks for row, paper in enumerate(self.listed) if (lacks := paper.lacks)}

    @property
    def put_together(self) -> Sequence[Paper]:
        """Those with questions of others."""
        return [paper for paper in self.listed if paper.put]


@dataclass(frozen=True)
class PartRows(Sequence[Keys]):
    """The keys of papers in successive rows of a part."""

    part: KeyPart
    rows: range

    def __len__(self) -> int:
        return len(self.rows)

    @overload
    def __getitem__(self, row: int) -> Keys: ...

    @overload
    def __getitem__(self, row: slice) -> PartRows: ...

    def __getitem__(self, row: int | slice) -> Keys | PartRows:
        found = self.rows[row]
        return PartKeys(self.part, found) if isinstance(found, int) else PartRows(self.part, found)

    def list_rules(self) -> Sequence[tuple[Tolerance, ...]]:
        """The rules of each."""
        return [terms.rules for terms in self.part.terms[self.rows.start : self.rows.stop]]


@dataclass(frozen=True)
class PartPapers(PaperBlock):
    """The papers of these candidates, whose keys stand in a part of the arrays."""

    owners: Sequence[Candidate]
    rows: PartRows

    def __len__(self) -> int:
        return len(self.owners)

    @overload
    def __getitem__(self, row: int) -> Paper: ...

    @overload
    def __getitem__(self, row: slice) -> PartPapers: ...

    def __getitem__(self, row: int | slice) -> Paper | PartPapers:
        if isinstance(row, slice):
            return PartPapers(self.owners[row], self.rows[row])
        owner = self.owners[row]
        return Paper(owner.student, owner.name, self.rows[row])

    @cached_property
    def students(self) -> Sequence[str]:
        """Whose they are."""
        return [owner.student for owner in self.owners]

    @property
    def names(self) -> Sequence[str]:
        """The names of these students."""
        return [owner.name for owner in self.owners]

    @property
    def keys(self) -> PartRows:
        """Their keys."""
        return self.rows

    @property
    def lacking(self) -> Mapping[int, frozenset[int]]:
        """None: papers that lack something stand in no arrays."""
        return {}

    @property
    def put_together(self) -> Sequence[Paper]:
        """None: those are listed."""
        return ()


def list_blocks(papers: Iterator[Paper], size: int) -> Iterator[ListedPapers]:
    """Papers in blocks of that size."""
    while listed := list(islice(papers, size)):
        yield ListedPapers(listed)
        del listed  # so that the next takes its place


def divide_block(papers: PaperBlock, size: int) -> Iterator[PaperBlock]:
    """A block in blocks of at most that size."""
    for begin in range(0, len(papers), size):
        yield papers[begin : begin + size]
