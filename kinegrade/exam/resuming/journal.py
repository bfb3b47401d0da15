"""The papers of an unfinished exam folder: each is noted when its files are written, with their
digests, and taken over by a later run where they are what was noted.

The journal has a line for each paper, which begins with a digest of the rest: a line that was cut
off is as if it were not there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

import msgspec

from kinegrade.exam.folder.contents import PAPERS, SOLUTIONS, SOURCES, UNFINISHED
from kinegrade.exam.folder.exam_secret import ExamSecret
from kinegrade.exam.printing.printed_files import collect_files, read_printouts
from kinegrade.exam.printing.printing import Printed
from kinegrade.exam.resuming.begun import Order, write_begun
from kinegrade.exam.roster.students import Student
from kinegrade.files.placing.leftovers import remove
from kinegrade.press.sheet import KeyPaper

_JOURNAL = "papers.jsonl"
_KEPT = (PAPERS, SOLUTIONS, SOURCES, UNFINISHED)  # what else stands in the folder is made anew


class _Note(msgspec.Struct, frozen=True):
    """What a line says of a paper; its files by their path below the folder, with digests."""

    file_name: str
    files: dict[str, str]
    pages: int
    record: bytes
    key: KeyPaper


@dataclass(frozen=True)
class Journal:
    """The papers that stand in the folder, by file name: where their lines begin in the journal."""

    folder: Path
    lines: Mapping[str, int]

    def list_missing(self, students: Sequence[Student]) -> tuple[Student, ...]:
        """The students whose papers are still to be printed."""
        return tuple(each for each in students if each.file_name not in self.lines)

    def merge(self, students: Sequence[Student], printed: Iterator[Printed]) -> Iterator[Printed]:
        """The paper of each student: read from the folder, or the next one that was printed. This
        is noted when the one after it is asked for: its files are written by then.
        """
        with (self.folder / UNFINISHED / _JOURNAL).open("ab") as journal:
            for student in students:
                if student.file_name in self.lines:
                    yield self._read(self.lines[student.file_name])
                    continue
                paper = next(printed)
                yield paper
                journal.write(_write_line(student.file_name, paper))
                journal.flush()

    def _read(self, beginning: int) -> Printed:
        """The paper that the line at this place notes."""
        with (self.folder / UNFINISHED / _JOURNAL).open("rb") as journal:
            journal.seek(beginning)
            note = _read_line(journal.readline())
        files = {name: (self.folder / name).read_bytes() for name in note.files}
        paper, solution, also = read_printouts(note.file_name, files)
        return Printed(paper, note.pages, solution, also, note.record, note.key)


def open_journal(folder: Path, secret: ExamSecret, order: Order) -> Journal:
    """The papers that are whole of an exam that was begun in the folder, none where it begins now;
    what is made anew is removed.
    """
    write_begun(folder, secret, order)
    for entry in folder.iterdir():
        if entry.name not in _KEPT:
            remove(entry)
    journal = folder / UNFINISHED / _JOURNAL
    with journal.open("ab") as lines:
        lines.write(b"\n")  # the last line may have been cut off
    return Journal(folder, dict(_find_whole(folder, journal)))


def _find_whole(folder: Path, journal: Path) -> Iterator[tuple[str, int]]:
    """The papers whose files are what their lines say, and where these lines begin."""
    beginning = 0
    with journal.open("rb") as lines:
        for line in lines:
            note = _read_line(line) if _is_whole(line) else None
            if note is not None and _has_files(folder, note):
                yield note.file_name, beginning
            beginning += len(line)


def _write_line(file_name: str, printed: Printed) -> bytes:
    files = collect_files(file_name, printed)
    digests = {name: sha256(content).hexdigest() for name, content in files.items()}
    note = _Note(file_name, digests, printed.pages, printed.record, printed.key)
    text = msgspec.json.encode(note)
    return b"%s %s\n" % (sha256(text).hexdigest().encode(), text)


def _is_whole(line: bytes) -> bool:
    digest, _, text = line.rstrip(b"\n").partition(b" ")
    return digest == sha256(text).hexdigest().encode()


def _read_line(line: bytes) -> _Note:
    return msgspec.json.decode(line.partition(b" ")[2], type=_Note)


def _has_files(folder: Path, note: _Note) -> bool:
    """Whether the files of a paper are as they were when it was noted."""
    try:
        return all(
            sha256((folder / name).read_bytes()).hexdigest() == digest
            for name, digest in note.files.items()
        )
    except OSError:
        return False
