"""The files of an exam's key: its lines, those of a pool and of spare papers, and the line of each
paper, looked up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path

from kinegrade.errors import ExamError
from kinegrade.exam.folder.contents import KEY, POOL, SPARES
from kinegrade.exam.folder.faults import decoding, explain_unreadable, name_line, name_paper
from kinegrade.exam.folder.key.exact_keys import read_key_line
from kinegrade.exam.folder.key.index import KeyIndex, make_index
from kinegrade.exam.folder.key.lines import KeyLine, StatedNumber
from kinegrade.language.message import Fault, Message, Quoted

_KEPT_LINES = 4  # marking comes back to the same paper for each ask


@dataclass(frozen=True)
class KeyFiles:
    """The files of the key in an exam folder."""

    path: Path

    @cached_property
    def file(self) -> Path:
        """The file of the key, to be named in messages."""
        return self.path / KEY

    @property
    def spare_file(self) -> Path:
        """The file of the spare papers' key, to be named in messages."""
        return self.path / SPARES

    @property
    def pool_file(self) -> Path:
        """The file of the pool's lines, to be named in messages."""
        return self.path / POOL

    @property
    def has_pool(self) -> bool:
        """Whether a pool was made of the exam."""
        return self.pool_file.exists()

    def line_of(self, student: str) -> KeyLine:
        """The key of a student's paper, or that of a pool's variant for a student who left the
        roster.

        Raises ExamError where there is none.
        """
        line = self.find_line(student)
        if line is None:
            raise self.name_missing(student)
        return line

    def find_line(self, student: str) -> KeyLine | None:
        """The same, or None where there is none. Raises ExamError where it is damaged."""
        return self._recent_line(student)

    def parameters(self, student: str, question: str) -> Mapping[str, StatedNumber]:
        """The numbers drawn for a question of a student's paper, by parameter. Raises
        ExamError.
        """
        asked = (each for each in self.line_of(student).questions if each.question == question)
        return next((each.parameters for each in asked), {})

    def lines(self) -> Iterator[KeyLine]:
        """The keys of all papers, in the order of the file. Raises ExamError."""
        return (self.read_line(*line) for line in self.texts())

    def spare_lines(self) -> Iterator[KeyLine]:
        """The keys of the spare papers, none where there are none. Raises ExamError."""
        texts = _read_texts(self.spare_file) if self.spare_file.exists() else iter(())
        return (_read_record(self.spare_file, *line) for line in texts)

    def read_line(self, number: int, text: bytes) -> KeyLine:
        """The key on a line of `texts`. Raises ExamError."""
        return _read_record(self.file, number, text)

    def texts(self) -> Iterator[tuple[int, bytes]]:
        """The lines of the key as they stand, with their numbers. Raises ExamError."""
        return _read_texts(self.file)

    def pool_lines(self) -> Iterator[KeyLine]:
        """The keys of a pool's variants, none where no pool was made. Raises ExamError."""
        return (_read_record(self.pool_file, *line) for line in self.pool_texts())

    def pool_texts(self) -> Iterator[tuple[int, bytes]]:
        """The lines of a pool as they stand, with their numbers. Raises ExamError."""
        return _read_texts(self.pool_file) if self.has_pool else iter(())

    @cached_property
    def _indices(self) -> tuple[KeyIndex, ...]:
        """The indices in which lines are looked up: the key's, then the pool's, then that of spare
        papers.
        """
        others = (each for each in (self.pool_file, self.spare_file) if each.exists())
        return tuple(map(make_index, (self.file, *others)))

    @cached_property
    def _recent_line(self) -> Callable[[str], KeyLine | None]:
        return lru_cache(maxsize=_KEPT_LINES)(self._line)

    def _line(self, student: str) -> KeyLine | None:
        index = self.find_index(student)
        if index is None:
            return None
        with decoding(index.path, name_paper(student)):
            return read_key_line(index.text(student))

    def find_index(self, student: str) -> KeyIndex | None:
        """The index that holds the line of a student."""
        return next((index for index in self._indices if student in index.beginnings), None)

    def name_missing(self, student: str) -> ExamError:
        """That there is no paper of a student."""
        what = Message("exam.no-paper", student=Quoted(student))
        expected, do = Message("exam.one-for-every-student"), Message("exam.name-exam-of-marks")
        return ExamError(Fault(str(self.file), what, expected, do))


def _read_texts(path: Path) -> Iterator[tuple[int, bytes]]:
    try:
        with path.open("rb") as lines:
            yield from ((number, line) for number, line in enumerate(lines, 1) if line.strip())
    except OSError as fault:
        raise explain_unreadable(path, fault) from fault


def _read_record(path: Path, number: int, text: bytes) -> KeyLine:
    with decoding(path, name_line(number)):
        return read_key_line(text)
