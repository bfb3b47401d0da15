"""The papers of an exam derived again from what its folder keeps, each held against the key."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Literal, TypeAlias

from msgspec import structs

from kinegrade.draws.deck import Combination
from kinegrade.errors import ExamError
from kinegrade.exam.bank.bank import read_kept_bank
from kinegrade.exam.bank.blueprint import Bank, BankQuestion
from kinegrade.exam.choices import fits_paper
from kinegrade.exam.folder.contents import BANK, HEAD, TEMPLATES
from kinegrade.exam.folder.contradictions import explain_contradiction, list_names, name_place
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.faults import explain_broken
from kinegrade.exam.folder.key.lines import KeyLine, KeyQuestion
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.roster.students import Student, read_place
from kinegrade.exam.setting.derivation import derive_question, find_differences, work_out
from kinegrade.exam.setting.setting import Exam, SetPaper, SetQuestion
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.mechanics.plan import Plan
from kinegrade.students.rounding.rounding import Rounding

_Term: TypeAlias = Literal["code", "version", "questions", "printed"]


@dataclass(frozen=True)
class KeptExam:
    """An exam as its folder keeps it: the bank and the templates by copies, and for each student
    the values drawn.

    With a bank that was `read` already, and `paper_by`, no file of the folder is needed.
    """

    exam: ExamFolder
    read: Bank | None = None

    @cached_property
    def bank(self) -> Bank:
        """The bank from its copy. Raises BankError."""
        if self.read is not None:
            return self.read
        chosen = {each.question: each.template for each in self.exam.head.questions}
        bank = read_kept_bank(self.exam.path / BANK, self.exam.path / TEMPLATES, chosen)
        return structs.replace(bank, earlier=self.exam.head.earlier)

    @cached_property
    def unkeyed(self) -> Exam:
        """The exam without its secret, for what does not depend on it. Raises BankError."""
        return Exam(self.bank, "")

    def derive(self, line: KeyLine, kept: KeyQuestion, plan: Plan | None = None) -> SetQuestion:
        """A question of a paper solved again, faster by a plan that may serve.

        Raises ExamError where something else follows than the key says, BankError.
        """
        where = name_place(self.exam.keys.file, line.student, kept.question)
        question = self._questions.get(kept.question)
        if question is None:
            raise explain_contradiction(where, [Message("exam.no-question-of-bank")])
        return derive_question(
            question, kept, where, partial(self._find_roundings, kept.question), plan
        )

    def rework(self, candidate: Candidate) -> tuple[SetPaper, tuple[Fault, ...]]:
        """The paper of a student worked out from its values, whatever follows from them, and each
        place where that differs from the key. Raises ExamError, BankError.
        """
        line = self._line(candidate.student)
        stated = {each.question: each for each in line.questions}
        names = self._list_held(line)
        questions, differences = [], []
        for name in names:
            question = self._questions[name]
            where = Message("exam.student-question", student=Quoted(line.student), question=name)
            reworked = work_out(question, stated[name], where, partial(self._find_roundings, name))
            differences += [Fault(where, each) for each in find_differences(reworked, stated[name])]
            questions.append(reworked)
        order = tuple(map(names.index, line.order))
        paper = SetPaper(
            student_of(candidate), line.paper, tuple(questions), order, line.version, line.place
        )
        return paper, tuple(differences)

    def paper(self, candidate: Candidate) -> SetPaper:
        """The paper of a student of the exam, as it was set.

        Raises ExamError where something else follows than the key says, BankError.
        """
        return self.paper_by(candidate, self.exam.keys.find_line(candidate.student))

    def paper_by(self, candidate: Candidate, line: KeyLine | None) -> SetPaper:
        """The same, by the key of the paper; None where the folder has lost it."""
        if line is None:
            raise self._explain_lost(candidate.student)
        names = self._list_held(line)
        self._require_same_paper(candidate, line, names)
        stated = {each.question: each for each in line.questions}
        return SetPaper(
            replace(student_of(candidate), spare=candidate in self.exam.head.spares),
            line.paper,
            tuple(self.derive(line, stated[name], self._plans[name]) for name in names),
            tuple(map(names.index, line.order)),
            line.version,
            line.place,
        )

    def _find_roundings(self, question: str, values: Combination) -> Mapping[str, Rounding[float]]:
        """How rounding bears on the answers to a question."""
        return self.unkeyed.filters[question].dealt.find_roundings(values)

    def _list_held(self, line: KeyLine) -> tuple[str, ...]:
        """The questions that a paper holds, in the bank's order; all of the bank where those of its
        key are not such as one paper may hold.
        """
        stated = [each.question for each in line.questions]
        everything = tuple(self._questions)
        if not fits_paper(stated, everything, self.bank.choices):
            return everything
        return tuple(name for name in everything if name in stated)

    def _line(self, student: str) -> KeyLine:
        """The key of a paper. Raises ExamError where the folder has lost it."""
        line = self.exam.keys.find_line(student)
        if line is None:
            raise self._explain_lost(student)
        return line

    def _explain_lost(self, student: str) -> ExamError:
        return explain_broken(
            self.exam.keys.file, [Message("exam.no-line", student=Quoted(student))]
        )

    def _require_same_paper(
        self, candidate: Candidate, line: KeyLine, names: Sequence[str]
    ) -> None:
        """Raises ExamError where the key has another paper than the head, or other questions than
        the bank.
        """
        stated = [each.question for each in line.questions]
        terms: tuple[tuple[_Term, Sequence[str], Sequence[str], str], ...] = (
            ("code", (line.paper,), (candidate.paper,), HEAD),
            ("version", (line.version,), (candidate.version,), HEAD),
            ("questions", sorted(stated), sorted(names), BANK),
            ("printed", sorted(line.order), sorted(names), BANK),
        )
        differences = [
            _describe(term, found, other, file)
            for term, found, other, file in terms
            if found != other
        ]
        if differences:
            raise explain_contradiction(name_place(self.exam.keys.file, line.student), differences)

    def require_no_contradiction(self) -> None:
        """Raises ExamError where something else follows for a paper than the key says."""
        from kinegrade.students.following.connections import find_generic_plan

        plans = {name: find_generic_plan(each.template) for name, each in self._questions.items()}
        for line in self.exam.keys.lines():
            for kept in line.questions:
                self.derive(line, kept, plans.get(kept.question))

    @cached_property
    def _questions(self) -> Mapping[str, BankQuestion]:
        return {each.identifier: each for each in self.bank.questions}

    @cached_property
    def _plans(self) -> Mapping[str, Plan | None]:
        """The plans by which `generate` solves, by question."""
        return {name: each.plan for name, each in self.unkeyed.filters.items()}


def list_with_keys(
    exam: ExamFolder, candidates: Iterable[Candidate]
) -> tuple[tuple[Candidate, KeyLine | None], ...]:
    """Students with the keys of their papers, for `paper_by`. Raises ExamError."""
    return tuple((each, exam.keys.find_line(each.student)) for each in candidates)


def student_of(candidate: Candidate) -> Student:
    """A student of an exam as a roster has them."""
    return Student(
        candidate.student,
        candidate.name,
        candidate.email,
        read_place(candidate.file),
        group=candidate.group,
        room=candidate.room,
        seat=candidate.seat,
        language=candidate.language,
        extra_time=candidate.extra_time,
        print_format=candidate.print_format,
    )


def _describe(term: _Term, found: Sequence[str], other: Sequence[str], file: str) -> Message:
    """The difference in a term between the key and another file."""
    here, there = list_names(found), list_names(other)
    return Message(f"exam.head-{term}-differs", found=here, other=there, file=file)
