"""The papers of a key, one after the other in the order of the roster, so that a class of any size
takes the memory of a few papers.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO, NamedTuple

from kinegrade.errors import FieldError, Problem
from kinegrade.exam.folder.faults import explain_broken, explain_unreadable, name_line
from kinegrade.exam.folder.key.decoding import PaperDecoder
from kinegrade.exam.folder.key.stated_keys import Place
from kinegrade.exam.folder.ownership import find_ownership_faults
from kinegrade.exam.folder.papers import Paper
from kinegrade.exam.folder.records import ExamHead
from kinegrade.language.message import Fault

# Bytes: a few of the long lines, but no more than fits in a processor's cache
_BUFFER = 2**17


def stream_papers(path: Path, head: ExamHead) -> Iterator[Paper]:
    """The papers of all candidates of an exam with that head, read as they are asked for.

    Raises ExamError with all faults of the file, after its last line is read.
    """
    try:
        with path.open("rb", _BUFFER) as stream:
            yield from _Papers(path, head, stream).in_roster_order()
    except (OSError, UnicodeDecodeError) as fault:
        raise explain_unreadable(path, fault) from fault


class _Line(NamedTuple):
    """A line of the key: its number, and where it begins in the file."""

    number: int
    begin: int
    text: bytes


class _Papers:
    """Puts the lines of a key into the order of the roster; of a line that comes early, the
    position is kept, not the text.
    """

    def __init__(self, path: Path, head: ExamHead, stream: BinaryIO) -> None:
        self.path, self.candidates, self.stream = path, head.candidates, stream
        self.decoder = PaperDecoder(head)
        self.early: dict[str, _Line] = {}
        self.seen: list[str] = []
        self.faults: list[Problem] = []

    def in_roster_order(self) -> Iterator[Paper]:
        """All papers. Raises ExamError, after the last."""
        waiting = iter(self.candidates)
        due = next(waiting, None)
        for line, paper in self._in_file_order():
            self.seen.append(paper.student)
            if paper.student != due:
                self.early.setdefault(paper.student, line._replace(text=b""))
                continue
            yield paper
            due = next(waiting, None)
            while due is not None and due in self.early:
                yield self._early(self.early[due])
                due = next(waiting, None)
        faults = self.faults or [*find_ownership_faults(self.seen, self.candidates)]
        if faults:
            raise explain_broken(self.path, faults)

    def _in_file_order(self) -> Iterator[tuple[_Line, Paper]]:
        """Each line with its paper; none after the first fault."""
        for lines in self._lines():
            papers = self.decoder.usual(
                [line.text for line in lines], [self._place(line) for line in lines]
            )
            if papers is not None and not self.faults:
                yield from zip(lines, papers, strict=True)
                continue
            for line in lines:
                try:
                    paper = self.decoder.paper(line.text, self._place(line))
                    if not self.faults:
                        yield line, paper
                except FieldError as fault:
                    self.faults.append(Fault(name_line(line.number), fault.faults[0]))

    def _lines(self) -> Iterator[list[_Line]]:
        """The lines that are not empty, in batches."""
        begin = number = 0
        while texts := self.stream.readlines(_BUFFER):
            lines = []
            for text in texts:
                if not text.isspace():
                    number += 1
                    lines.append(_Line(number, begin, text))
                begin += len(text)
            yield lines

    def _early(self, line: _Line) -> Paper:
        now = self.stream.tell()
        self.stream.seek(line.begin)
        text = self.stream.readline()
        self.stream.seek(now)
        return self.decoder.paper(text, self._place(line))

    def _place(self, line: _Line) -> Place:
        return Place(self.path, line.number)
