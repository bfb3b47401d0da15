"""An exam folder as `generate` writes it: its head, its key, the lines of a pool, its templates and
its bank.

A command opens it once, by `open_exam`, and passes it on; nothing else knows the files. Only the
head is read immediately.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from kinegrade.errors import ExamError
from kinegrade.exam.folder.asks import Ask, list_questions
from kinegrade.exam.folder.contents import BANK, HEAD, SOLUTIONS, TEMPLATES
from kinegrade.exam.folder.faults import explain_unreadable
from kinegrade.exam.folder.head import read_head, require_finished
from kinegrade.exam.folder.key.files import KeyFiles
from kinegrade.exam.folder.papers import Paper, PaperBlock, RightAnswers
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.roster.students import read_place
from kinegrade.files.placing.readings import note_reading
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message

if TYPE_CHECKING:
    from kinegrade.exam.folder.columns.papers import KeptPapers
    from kinegrade.exam.folder.kept_templates import KeptTemplates


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
    def keys(self) -> KeyFiles:
        """The files of the key, and the keys of single papers."""
        return KeyFiles(self.path)

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
        return tuple(
            self._kept.variant(self.keys.pool_file, *line) for line in self.keys.pool_texts()
        )

    def printed_orders(self) -> Mapping[str, tuple[str, ...]]:
        """The order of the questions on each paper, by student, where it is not the bank's.

        Raises ExamError.
        """
        # Few commands ask in which order questions are printed
        from kinegrade.exam.folder.printed_orders import read_printed_orders  # noqa: PLC0415

        return read_printed_orders(self.keys.file, self.questions, self.head.choices)

    def require_sound_key(self) -> None:
        """Raises ExamError with all faults of the key."""
        for _ in self.papers():
            pass

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
        """Where the worked solutions of a student, or of a spare paper by its name, stand, if they
        are printed.
        """
        place = read_place(self.head.holders[student].file) or self.head.file_stems[student]
        return self.path / SOLUTIONS / f"{place}.pdf"

    def solution(self, student: str) -> bytes:
        """The worked solutions of a student as PDF. Raises ExamError."""
        path = self.solution_file(student)
        try:
            return path.read_bytes()
        except OSError as fault:
            what = Message("exam.no-solutions", reason=str(fault.strerror))
            raise ExamError(Fault(str(path), what)) from fault

    @property
    def has_changed_key(self) -> bool:
        """Whether other hands changed key.jsonl, as far as its arrays tell it."""
        return self._kept.has_changed_key

    def list_changed_keys(self) -> Mapping[tuple[str, str], list[str]]:
        """The asks whose keys other hands changed, by student and question, as far as the arrays of
        the key tell it. Raises ExamError.
        """
        changed: dict[tuple[str, str], list[str]] = {}
        for student, ask in self._kept.list_changed_keys():
            changed.setdefault((student, ask.question), []).append(ask.ask)
        return changed

    @cached_property
    def _kept(self) -> KeptPapers:
        """The papers by which marks are given."""
        # Arrays and mistakes are for marks: who prints a paper does without
        from kinegrade.exam.folder.columns.papers import KeptPapers  # noqa: PLC0415

        return KeptPapers(self.path, self.head)

    def _paper(self, student: str) -> Paper:
        index = self.keys.find_index(student)
        if index is None:
            raise self.keys.name_missing(student)
        return self._kept.paper(index, student)


def open_exam(path: Path) -> ExamFolder:
    """The exam folder there. Raises ExamError with all faults of its head, or where it is not
    finished.
    """
    note_reading(path, HEAD)
    require_finished(path)
    return ExamFolder(path, read_head(path))
