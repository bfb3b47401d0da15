"""An exam folder as `generate` writes it: its head, its key, the lines of a pool, its templates and
its bank.

A command opens it once, by `open_exam`, and passes it on; nothing else knows the files. Only the
head is read immediately.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from kinegrade.errors import ExamError
from kinegrade.exam.folder.contents import BANK, HEAD, KEY, POOL, SOLUTIONS, SPARES, TEMPLATES
from kinegrade.exam.folder.faults import decoding, explain_unreadable, name_line, name_paper
from kinegrade.exam.folder.head import read_head, require_finished
from kinegrade.exam.folder.key.exact_keys import read_key_line
from kinegrade.exam.folder.key.index import KeyIndex, make_index
from kinegrade.exam.folder.key.lines import KeyLine, StatedNumber
from kinegrade.exam.folder.keys import Ask, Paper, PaperBlock, RightAnswers, list_questions
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.roster.students import read_place
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message, Quoted

if TYPE_CHECKING:
    from kinegrade.exam.folder.columns.papers import KeptPapers
    from kinegrade.exam.folder.kept_templates import KeptTemplates

_KEPT_LINES = 4  # marking comes back to the same paper for each ask


@dataclass(frozen=True)
class ExamFolder:
    """An exam folder whose head has been read."""

    path: Path
    head: ExamHead = field(repr=False)

    def __reduce__(self) -> tuple[type[ExamFolder], tuple[Path, ExamHead]]:
        """To other processes goes nothing that was read on the way."""
        return ExamFolder, (self.path, self.head)

    @property
    def language(self) -> Language:
        """The language of the papers."""
        return self.head.language

    @property
    def asks(self) -> tuple[Ask, ...]:
        """The asks in the order of the bank."""
        return self.head.asks

    @property
    def questions(self) -> tuple[str, ...]:
        """The questions in the order of the bank."""
        return list_questions(self.asks)

    @cached_property
    def students(self) -> tuple[str, ...]:
        """The ids of the candidates, in the order of the roster."""
        return tuple(self.head.candidates)

    @cached_property
    def names(self) -> Mapping[str, str]:
        """The names of the candidates, by id."""
        return {each.student: each.name for each in self.head.students}

    @property
    def codes(self) -> Mapping[str, str]:
        """The candidates by the codes of their papers."""
        return self.head.owners

    @property
    def former_ids(self) -> Mapping[str, str]:
        """The candidates by the ids that they had before."""
        return self.head.former_ids

    @property
    def spare_codes(self) -> Collection[str]:
        """The codes of spare papers, which are nobody's."""
        return [each.paper for each in self.head.spares]

    @property
    def codes_before(self) -> Collection[tuple[str, str]]:
        """Students with the codes of papers that were theirs before an exchange."""
        return [(each.student, each.paper) for each in self.head.papers_before]

    @property
    def head_file(self) -> Path:
        """The file of the head, to be named in messages."""
        return self.path / HEAD

    @cached_property
    def key(self) -> Path:
        """The file of the key, to be named in messages."""
        return self.path / KEY

    @property
    def spares(self) -> Path:
        """The file of the spare papers' key, to be named in messages."""
        return self.path / SPARES

    @property
    def pool(self) -> Path:
        """The file of the pool's lines, to be named in messages."""
        return self.path / POOL

    @property
    def has_pool(self) -> bool:
        """Whether a pool was made of the exam."""
        return self.pool.exists()

    def papers(self) -> Iterator[Paper]:
        """The papers in the order of the roster, read as they are asked for.

        Raises ExamError with all faults of the key, after the last line is read.
        """
        return self._kept.papers()

    def blocks(self, size: int) -> Iterator[PaperBlock]:
        """The same in blocks of that size, or less."""
        return self._kept.blocks(size)

    def right_answers(self) -> Iterator[RightAnswers]:
        """What is right on the first of them, as far as the key's arrays can be read."""
        return self._kept.right_answers()

    def papers_of(self, students: Collection[str]) -> Mapping[str, Paper]:
        """The papers of these students, by student. Raises ExamError where one is missing."""
        return {student: self._paper(student) for student in students}

    def variants(self) -> tuple[Paper, ...]:
        """The papers of the pool that was made of the exam, none if there is no pool. Raises
        ExamError.
        """
        return tuple(self._kept.variant(self.pool, *line) for line in self.pool_texts())

    def printed_orders(self) -> Mapping[str, tuple[str, ...]]:
        """The order of the questions on each paper, by student, where it is not the bank's.

        Raises ExamError.
        """
        # Few commands ask in which order questions are printed
        from kinegrade.exam.folder.printed_orders import read_printed_orders  # noqa: PLC0415

        return read_printed_orders(self.key, self.questions, self.head.choices)

    def line_of(self, student: str) -> KeyLine:
        """The key of a student's paper, or that of a pool's variant for a student who left the
        roster.

        Raises ExamError where there is none.
        """
        line = self.find_line(student)
        if line is None:
            raise self._no_paper(student)
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
        texts = _read_texts(self.spares) if self.spares.exists() else iter(())
        return (_read_record(self.spares, *line) for line in texts)

    def require_sound_key(self) -> None:
        """Raises ExamError with all faults of the key."""
        for _ in self.papers():
            pass

    def read_line(self, number: int, text: bytes) -> KeyLine:
        """The key on a line of `texts`. Raises ExamError."""
        return _read_record(self.key, number, text)

    def texts(self) -> Iterator[tuple[int, bytes]]:
        """The lines of the key as they stand, with their numbers. Raises ExamError."""
        return _read_texts(self.key)

    def pool_lines(self) -> Iterator[KeyLine]:
        """The keys of a pool's variants, none where no pool was made. Raises ExamError."""
        return (_read_record(self.pool, *line) for line in self.pool_texts())

    def pool_texts(self) -> Iterator[tuple[int, bytes]]:
        """The lines of a pool as they stand, with their numbers. Raises ExamError."""
        return _read_texts(self.pool) if self.has_pool else iter(())

    @cached_property
    def templates(self) -> KeptTemplates:
        """The folder's copies of its templates."""
        # Takes a second to load, and most exports need no template
        from kinegrade.exam.folder.kept_templates import read_kept_templates  # noqa: PLC0415

        return read_kept_templates(self.path / TEMPLATES, self.head.questions)

    @cached_property
    def bank(self) -> str:
        """The text of the folder's copy of its bank. Raises ExamError."""
        path = self.path / BANK
        try:
            return path.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as fault:
            raise explain_unreadable(path, fault) from fault

    def solution_file(self, student: str) -> Path:
        """Where the worked solutions of a student stand, if they are printed."""
        place = read_place(self.head.candidates[student].file) or self.head.file_stems[student]
        return self.path / SOLUTIONS / f"{place}.pdf"

    def solution(self, student: str) -> bytes:
        """The worked solutions of a student as PDF. Raises ExamError."""
        path = self.solution_file(student)
        try:
            return path.read_bytes()
        except OSError as fault:
            what = Message("exam.no-solutions", reason=str(fault.strerror))
            raise ExamError(Fault(str(path), what)) from fault

    @cached_property
    def _indices(self) -> tuple[KeyIndex, ...]:
        """The indices in which lines are looked up: the key's, then the pool's, then that of spare
        papers.
        """
        others = (each for each in (self.pool, self.spares) if each.exists())
        return tuple(map(make_index, (self.key, *others)))

    @property
    def has_changed_key(self) -> bool:
        """Whether other hands changed key.jsonl, as far as its arrays tell it."""
        return self._kept.has_changed_key

    @cached_property
    def _kept(self) -> KeptPapers:
        """The papers by which marks are given."""
        # Arrays and mistakes are for marks: who prints a paper does without
        from kinegrade.exam.folder.columns.papers import KeptPapers  # noqa: PLC0415

        return KeptPapers(self.path, self.head)

    @cached_property
    def _recent_line(self) -> Callable[[str], KeyLine | None]:
        return lru_cache(maxsize=_KEPT_LINES)(self._line)

    def _line(self, student: str) -> KeyLine | None:
        index = self._index(student)
        if index is None:
            return None
        with decoding(index.path, name_paper(student)):
            return read_key_line(index.text(student))

    def _paper(self, student: str) -> Paper:
        index = self._index(student)
        if index is None:
            raise self._no_paper(student)
        return self._kept.paper(index, student)

    def _index(self, student: str) -> KeyIndex | None:
        """The index that holds the line of a student."""
        return next((index for index in self._indices if student in index.beginnings), None)

    def _no_paper(self, student: str) -> ExamError:
        what = Message("exam.no-paper", student=Quoted(student))
        expected, do = Message("exam.one-for-every-student"), Message("exam.name-exam-of-marks")
        return ExamError(Fault(str(self.key), what, expected, do))


def open_exam(path: Path) -> ExamFolder:
    """The exam folder there. Raises ExamError with all faults of its head, or where it is not
    finished.
    """
    require_finished(path)
    return ExamFolder(path, read_head(path))


def _read_texts(path: Path) -> Iterator[tuple[int, bytes]]:
    try:
        with path.open("rb") as lines:
            yield from ((number, line) for number, line in enumerate(lines, 1) if line.strip())
    except OSError as fault:
        raise explain_unreadable(path, fault) from fault


def _read_record(path: Path, number: int, text: bytes) -> KeyLine:
    with decoding(path, name_line(number)):
        return read_key_line(text)
