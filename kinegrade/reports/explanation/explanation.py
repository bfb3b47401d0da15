"""Why a student's answers were marked as they were: what `kinegrade explain` tells.

The marks are those that MARKS holds; nothing is marked again. The rule is that of the policy kept
with them, and what would follow from own wrong answers is worked out anew.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

from kinegrade.errors import ExamError, suggest
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.faults import decoding, name_paper
from kinegrade.exam.folder.key.exact_keys import read_exact_keys
from kinegrade.exam.folder.keys import Key
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.follow_through import FollowThrough
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.grading.judging.carried_on import CarriedOn, find_carried_on
from kinegrade.grading.judging.follow import Decided, Follows
from kinegrade.grading.judging.judge import Verdict
from kinegrade.grading.policy.policy import Policy
from kinegrade.grading.same_key import require_same_key
from kinegrade.grading.typed.answers import Reading
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.marks_folder.cells import Record
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.hand_marks import HandMark
from kinegrade.marks_folder.open_questions import OpenQuestion
from kinegrade.marks_folder.rows import MarkedAnswer, StudentTotal
from kinegrade.numbers.written import read_number
from kinegrade.question_numbers import number_printed
from kinegrade.reports.paper_record import PaperRecord, PaperRecords


@dataclass(frozen=True)
class ExplainedAnswer:
    """One answer as it was marked: `key` is the right answer with the rule that judged it, which is
    the paper's or, where they differ, the policy's.

    `carried` is what would be right for a student who carried on from own wrong answers. `source`
    is whose paper has these numbers: another's where the question came from a pool.
    """

    marked: MarkedAnswer
    key: Key
    by_policy: bool
    carried: CarriedOn | None
    source: str


@dataclass(frozen=True)
class Explanation:
    """A student's paper as it was marked; `numbers` are those of its questions on the paper."""

    candidate: Candidate
    total: StudentTotal
    still_open: Sequence[OpenQuestion]
    paper: PaperRecord
    numbers: Mapping[str, int]
    log: tuple[Record, ...]
    answers: tuple[ExplainedAnswer, ...]
    by_hand: tuple[HandMark, ...] = ()


def explain_marks(
    exam: ExamFolder, marks: MarksFolder, student: str, which: str = ""
) -> Explanation:
    """The marks of a student, by id or by the code of the paper.

    `which` is empty for all answers, else a question or one answer: `q3.v_B` as in the answer
    sheet, `3.v_B` as on the student's paper. Raises ExamError, TableError, PolicyError.
    """
    require_same_key(exam, marks)
    candidate = _find_candidate(exam, student)
    if candidate.student in marks.elsewhere:
        where = Quoted(marks.elsewhere[candidate.student])
        what = Message("explain.merged", student=Quoted(candidate.student), marks=where)
        raise ExamError(Fault(str(marks.path), what, do=Message("explain.name-that-exam")))
    answers = dict(marks.answers_by_student()).get(candidate.student)
    total = marks.totals.by_student.get(candidate.student)
    if answers is None or total is None:
        what = Message("explain.not-marked", student=Quoted(candidate.student))
        raise ExamError(Fault(str(marks.path), what, do=Message("marks.name-exam")))
    papers = PaperRecords.of_marks(exam, marks)
    paper = papers.marked(candidate.student, (answer.column for answer in answers))
    numbers = dict(zip(paper.printed, number_printed(paper.printed), strict=True))
    wanted = _Wanted.read(which, numbers)
    chosen = [each for each in answers if wanted.has(each.question, each.ask)]
    given = marks.by_hand.get(candidate.student, {}).values()
    by_hand = tuple(each for each in given if wanted.has(each.question, each.ask))
    if not chosen and not by_hand:
        raise _refuse(which, candidate.student, answers)
    questions = {each.question for each in chosen}
    whole = [each for each in answers if each.question in questions]
    explained = _Explaining(exam, marks, papers.policy).explain(whole)
    asked = tuple(each for each in explained if each.marked in chosen)
    now = exam.former_ids
    log = tuple(each for each in marks.log if now.get(each[1], each[1]) == candidate.student)
    return Explanation(candidate, total, marks.open, paper, numbers, log, asked, by_hand)


def _find_candidate(exam: ExamFolder, student: str) -> Candidate:
    """The student meant, as ids are read in files of answers. Raises ExamError."""
    ids = StudentIds(exam.students, exam.codes, exam.former_ids)
    found = ids.exact(student)
    near = ids.near(student)
    if found is None and len(near) == 1:
        (found,) = near
    if found is None:
        what = Message("exam.no-student", student=Quoted(student))
        expected, do = Message("explain.id-or-code"), suggest(student, exam.students)
        raise ExamError(Fault(str(exam.head_file), what, expected, do))
    return exam.head.candidates[found]


@dataclass(frozen=True)
class _Wanted:
    """What is to be explained: a question, or one answer to it; everything where both are empty."""

    question: str
    ask: str

    @classmethod
    def read(cls, which: str, numbers: Mapping[str, int]) -> _Wanted:
        """Reads `q3.v_B`, or `3.v_B` by the number on the paper, or `3`; `2b` as `q2b`, for papers
        with alternatives print that number of the answer sheet.
        """
        question, _, ask = which.strip().partition(".")
        printed = {str(number): name for name, number in numbers.items()}
        in_sheet = f"q{question}"
        by_name = in_sheet if question.isdecimal() or in_sheet in numbers else question
        return cls(printed.get(question, by_name), ask)

    def has(self, question: str, ask: str) -> bool:
        """Whether an answer, or marks for a whole question, are meant."""
        if not self.question:
            return True
        return question == self.question and self.ask in ("", ask)


def _refuse(which: str, student: str, answers: Sequence[MarkedAnswer]) -> ExamError:
    what = Message("explain.not-asked", student=Quoted(student), which=Quoted(which))
    do = suggest(which, [each.column for each in answers])
    return ExamError(Fault("", what, Message("explain.which"), do))


@dataclass(frozen=True)
class _Explaining:
    exam: ExamFolder
    marks: MarksFolder
    policy: Policy

    def explain(self, answers: Sequence[MarkedAnswer]) -> Iterator[ExplainedAnswer]:
        """The answers of one student, in their order."""
        asks = {ask.column: ask for ask in self.exam.asks}
        for _, group in groupby(answers, lambda each: each.question):
            marked = tuple(group)
            decided = [self._decide(each, asks[each.column]) for each in marked]
            carried = self._carry_on(marked[0], decided)
            for each, known in zip(marked, decided, strict=True):
                key, source = (
                    known.ruling.key(known.key),
                    self._find_source(each.student, each.column),
                )
                by_policy = key.rule != known.key.rule
                yield ExplainedAnswer(each, key, by_policy, carried.get(each.ask), source)

    def _decide(self, answer: MarkedAnswer, ask: Ask) -> Decided:
        """An answer as it was read."""
        reading = (
            Reading("number", answer.typed, read_number(answer.read_as), answer.read_as)
            if answer.read_as
            else Reading("blank", answer.typed)
        )
        ruling = self.policy.ruling(ask.column)
        decision = Verdict("wrong", answer.reason), ruling.follow_through
        return Decided(ask, reading, self._find_key(answer, ask), ruling, decision)

    def _find_key(self, answer: MarkedAnswer, ask: Ask) -> Key:
        """The key by which it was marked: that of the student's paper, or of the one from which the
        question came.
        """
        source = self._find_source(answer.student, ask.column)
        line = self.exam.keys.line_of(source)
        with decoding(self.exam.keys.file, name_paper(source)):
            keys = read_exact_keys(self.exam.asks, line, self.exam.head.choices)
        return keys[self.exam.asks.index(ask)]

    def _find_source(self, student: str, column: str) -> str:
        """Whose paper has the numbers by which an answer was marked."""
        return self.marks.put.get(student, {}).get(column, student)

    def _carry_on(self, first: MarkedAnswer, decided: Sequence[Decided]) -> Mapping[str, CarriedOn]:
        """What would follow in a question; nothing where its asks come from several papers."""
        sources = {self._find_source(first.student, each.ask.column) for each in decided}
        if len(sources) > 1 or all(each.is_right for each in decided):
            return {}
        follow_through = FollowThrough(self.exam)
        return find_carried_on(
            sources.pop(), decided, Follows(follow_through, follow_through.stages)
        )
