"""A simulated class: papers drawn as for an exam, their exam folder, and answers to them marked by
the real marking.

`classes` draws; `SimulatedClass.marked` goes from typed texts through the answer sheet to the
marks.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import floor, log10
from pathlib import Path
from tempfile import TemporaryDirectory

from kinegrade.exam.folder.contents import HEAD, KEY
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.folder.writing import encode_head, encode_line
from kinegrade.exam.keyed_exam import KeyedExam, read_whole
from kinegrade.exam.printing.head_record import candidate, make_exam_head
from kinegrade.exam.printing.printing import Extras, PressOrder, PrintRun
from kinegrade.exam.printing.sample import make_sample_bank
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import ClassDeal, deal_exam
from kinegrade.exam.setting.key_mistakes import find_mistaken_answers
from kinegrade.exam.setting.key_record import make_key_line
from kinegrade.exam.setting.setting import SetPaper
from kinegrade.files.csv_writing import write_csv_text
from kinegrade.files.tables import parse_table
from kinegrade.grading.marking import mark
from kinegrade.grading.marks import Mark
from kinegrade.grading.sheets.class_sheet import read_sheet
from kinegrade.press.sheet import KeyPaper
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.stated_marking import find_identifier
from kinegrade.students.comparison import measure_distance
from kinegrade.students.mistaking.consequences import attach_mistakes
from kinegrade.students.separation import Separation

CLASS = 50  # students of one exam: no template is short of instances for so few
FIGURES = 4  # that mistaken students type in


@dataclass(frozen=True, slots=True)
class Answer:
    """What a student types into one box; `value` is the number meant, in the ask's unit, `mistake`
    what led to it.
    """

    typed: str
    value: float
    mistake: str = ""


@dataclass(frozen=True)
class SimulatedClass:
    """Papers of one template, the exam as grading sees it, and by ask the mistakes that its draws
    do not keep apart.
    """

    template: Template
    number: int
    papers: tuple[SetPaper, ...]
    exam: KeyedExam
    inseparable: Mapping[str, frozenset[str]]

    @cached_property
    def solutions(self) -> tuple[Solution, ...]:
        """The solution of each paper, whose answers say what known mistakes lead to."""
        return tuple(attach_mistakes(paper.questions[0].drawn.solution) for paper in self.papers)

    def marked(self, answers: Sequence[Mapping[str, Answer]]) -> Iterator[tuple[int, Mark]]:
        """The mark of every ask of every paper, with the paper's place; `answers` are each
        student's, by ask.
        """
        header = ["student", *(ask.column for ask in self.exam.asks)]
        rows = [
            [
                paper.student.student,
                *(given[ask.ask].typed if ask.ask in given else "" for ask in self.exam.asks),
            ]
            for paper, given in zip(self.papers, answers, strict=True)
        ]
        sheet = read_sheet(
            parse_table(write_csv_text(header, rows).encode(), "answers.csv"), self.exam
        )
        for number, each in enumerate(mark(self.exam, sheet).marks):
            yield number // len(self.exam.asks), each

    def alike(self, place: int, ask: str, name: str, answer: Answer) -> bool:
        """Whether a mistake leads to the number that was meant, within a unit of the last figure
        typed in.
        """
        unit = 10.0 ** (floor(log10(abs(answer.value))) + 1 - FIGURES) if answer.value else 0.0
        return any(
            measure_distance(led, answer.value, self.template.asks[ask]) <= unit
            for label, led in self.solutions[place][ask].mistakes.items()
            if find_identifier(label) == name
        )

    @staticmethod
    def named(each: Mark) -> tuple[str, ...]:
        """The mistakes that the marks name."""
        return each.verdict.mistakes if each.verdict.kind == "mistake" else ()


def answered(
    simulated: SimulatedClass, answers: Sequence[Mapping[str, Answer]]
) -> Iterator[tuple[int, Mark, Answer]]:
    """The marks of what was answered."""
    for place, each in simulated.marked(answers):
        if each.ask.ask in answers[place]:
            yield place, each, answers[place][each.ask.ask]


def classes(template: Template, draws: int) -> Iterator[SimulatedClass]:
    """So many papers of what a template asks by default, in classes of CLASS students."""
    for number, first in enumerate(range(0, draws, CLASS)):
        yield simulated_class(template, number, min(CLASS, draws - first))


def simulated_class(template: Template, number: int, students: int) -> SimulatedClass:
    """The papers of one class; another number gives others."""
    names = [f"s{place}" for place in range(students)]
    roster = Roster(tuple(Student(name, name, "", name) for name in names), ())
    dealt = deal_exam(make_sample_bank(template), roster, FromWords(f"fairness {number}"))
    (draw_filter,) = dealt.exam.filters.values()
    papers = tuple(dealt.papers())
    return SimulatedClass(
        template, number, papers, as_read(dealt, papers), inseparable(draw_filter.separation)
    )


def inseparable(separation: Separation | None) -> dict[str, frozenset[str]]:
    """By ask the mistakes that draws do not keep apart from the right answer."""
    if separation is None:
        return {}
    identifiers = separation.compare(separation.sample).identifiers
    return {
        ask: frozenset(
            name
            for name, kept in zip(identifiers[ask], separation.kept[ask], strict=True)
            if not kept
        )
        for ask in separation.asks
    }


def as_read(dealt: ClassDeal, papers: Sequence[SetPaper]) -> KeyedExam:
    """The exam, written into a folder as generate writes it and read again as grade reads it."""
    candidates = [
        candidate(
            paper.student, KeyPaper(paper.student.student, paper.student.name, paper.code, ())
        )
        for paper in papers
    ]
    lines = (
        make_key_line(paper, mistakes)
        for paper, mistakes in zip(papers, find_mistaken_answers(papers), strict=True)
    )
    with TemporaryDirectory() as name:
        folder = Path(name)
        run = PrintRun(dealt.bank, "en", PressOrder(dealt.bank.engine, "a4"), Extras())
        (folder / HEAD).write_bytes(encode_head(make_exam_head(dealt, candidates, run)))
        (folder / KEY).write_bytes(b"".join(map(encode_line, lines)))
        return read_whole(open_exam(folder))
