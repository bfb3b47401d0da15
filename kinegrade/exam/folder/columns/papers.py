"""The papers of an exam by which marks are given: from the key's arrays as far as they are sound,
else from the key itself.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from itertools import chain, islice
from pathlib import Path

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.columns.blocks import PartPapers, divide_block, list_blocks
from kinegrade.exam.folder.columns.reading import (
    DAMAGED,
    KeyColumns,
    find_columns,
    find_earlier_columns,
    is_key_changed,
)
from kinegrade.exam.folder.contents import KEY, KEY_COLUMNS
from kinegrade.exam.folder.faults import decoding, name_line, name_paper
from kinegrade.exam.folder.key.decoding import PaperDecoder
from kinegrade.exam.folder.key.index import KeyIndex
from kinegrade.exam.folder.key.stated_keys import Place
from kinegrade.exam.folder.key.stream import stream_papers
from kinegrade.exam.folder.papers import Paper, PaperBlock, RightAnswers
from kinegrade.exam.folder.records import ExamHead


@dataclass(frozen=True)
class KeptPapers:
    """The papers in a folder with this head."""

    folder: Path
    head: ExamHead

    def papers(self) -> Iterator[Paper]:
        """The papers in the order of the roster, read as they are asked for.

        Raises ExamError with all faults of the key, after the last line is read.
        """
        done = 0
        for part in self._column_parts(1):
            yield from part
            done += len(part)
            del part  # so that the next takes its place
        yield from self._papers_from(done)

    def blocks(self, size: int) -> Iterator[PaperBlock]:
        """The same in blocks of that size, or less."""
        done = 0
        for part in self._column_parts(size):
            yield from divide_block(part, size)
            done += len(part)
            del part  # so that the next takes its place
        yield from list_blocks(self._papers_from(done), size)

    def _column_parts(self, size: int) -> Iterator[PartPapers]:
        """The papers whose keys can be read from arrays, about so many together."""
        if self._columns is not None:
            with suppress(*DAMAGED):
                yield from self._columns.parts(size)

    def _papers_from(self, begin: int) -> Iterator[Paper]:
        """The papers from that one on, read from the key itself."""
        if begin < len(self.head.students):
            yield from islice(stream_papers(self._key, self.head), begin, None)

    def right_answers(self) -> Iterator[RightAnswers]:
        """What is right on the first of them, as far as the key's arrays can be read."""
        if self._columns is not None:
            with suppress(*DAMAGED):
                yield from self._columns.right_answers()

    def paper(self, index: KeyIndex, student: str) -> Paper:
        """The paper of a student whom an index has. Raises ExamError."""
        with decoding(index.path, name_paper(student)):
            return self._decoder.paper(index.text(student), Place(index.path))

    def variant(self, pool: Path, number: int, text: bytes) -> Paper:
        """The paper on a line of a pool. Raises ExamError."""
        with decoding(pool, name_line(number)):
            return self._decoder.paper(text, Place(pool, number))

    @property
    def has_changed_key(self) -> bool:
        """Whether other hands changed key.jsonl, as far as its arrays tell it."""
        return is_key_changed(self.folder / KEY_COLUMNS, self._key, self.head)

    def list_changed_keys(self) -> Iterator[tuple[str, Ask]]:
        """Students with the asks whose keys are not those of the arrays, where these were written
        for the same students. Raises ExamError.
        """
        columns = find_earlier_columns(self.folder / KEY_COLUMNS, self.head)
        if columns is None:
            return
        with suppress(*DAMAGED):
            before = chain.from_iterable(columns.parts(1))
            for old, new in zip(before, self._papers_from(0), strict=False):
                for number, ask in enumerate(self.head.asks):
                    if old.key(number) != new.key(number):
                        yield new.student, ask

    @property
    def _key(self) -> Path:
        return self.folder / KEY

    @cached_property
    def _columns(self) -> KeyColumns | None:
        """The key as arrays, where they were written by the key as it now stands."""
        return find_columns(self.folder / KEY_COLUMNS, self._key, self.head)

    @cached_property
    def _decoder(self) -> PaperDecoder:
        return PaperDecoder(self.head)
