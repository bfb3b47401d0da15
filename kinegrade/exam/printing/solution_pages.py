"""From a set paper to the worked solutions of its questions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

from kinegrade.cycles.chapter import write_cycle_chapter
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.printing.pages import (
    QuestionPlace,
    draw_figure,
    find_own_language,
    write_title,
)
from kinegrade.exam.setting.setting import SetPaper, SetQuestion
from kinegrade.language import Language
from kinegrade.press.sheet import SolutionSheet, WorkedQuestion
from kinegrade.press.solutions.axes import names_axes
from kinegrade.problem.printed_givens import mark_question
from kinegrade.problem.solution import Solution
from kinegrade.problem.statement import write_statement
from kinegrade.problem.template.template import Method
from kinegrade.worked.conventions import states_rounding
from kinegrade.worked.document import Block
from kinegrade.worked.solution import write_worked_solution

# A language, the identifier of a question, and its values as they were drawn
_Instance = tuple[Language, str, tuple[tuple[str, str], ...]]


@dataclass(frozen=True)
class SolutionWriter:
    """Writes worked solutions by `method` where several serve, None leaves it to each template, in
    `language` unless the student has another, or else in the one `for_all`, with graphs over the
    `cycle` if wanted; that of a question that several papers have in common is written once for all
    of them.
    """

    language: Language
    method: Method | None = None
    for_all: Language | None = None
    cycle: bool = False
    _done: dict[_Instance, WorkedQuestion] = field(default_factory=dict, repr=False)

    def write(self, number: int, question: SetQuestion, language: Language) -> WorkedQuestion:
        """A question with its worked solution, for the quantities that are asked."""
        values = tuple(question.drawn.values.items())
        instance = (language, question.question.identifier, values)
        if instance not in self._done:
            self._done[instance] = self._work(number, question, language)
        return replace(self._done[instance], number=number)

    def _work(self, number: int, question: SetQuestion, language: Language) -> WorkedQuestion:
        place = QuestionPlace(number, question.question.identifier)
        asks = tuple(entry.ask.name for entry in question.asks)
        solution = question.drawn.solution
        return work_question(place, solution, asks, language, self.method, cycle=self.cycle)


def write_solution_sheet(bank: Bank, paper: SetPaper, writer: SolutionWriter) -> SolutionSheet:
    """The worked solutions of one student's paper, in the order of the paper."""
    language = writer.for_all or find_own_language(paper, writer.language)
    written = (writer.write(number, question, language) for number, question in paper.numbered)
    questions = tuple(_say_rounding_once(written, language))
    return SolutionSheet(
        language,
        bank.course.in_language(language),
        write_title(bank, paper, language),
        bank.date,
        "" if paper.student.spare else paper.student.student,
        paper.student.name,
        paper.code,
        questions,
        large=paper.student.reads_large_print,
    )


def _say_rounding_once(
    questions: Iterable[WorkedQuestion], language: Language
) -> Iterator[WorkedQuestion]:
    """The questions, each without how values are rounded where the one before has said the same."""
    said = list[Block]()
    for question in questions:
        rounding = [block for block in question.blocks if states_rounding(block, language)]
        others = tuple(block for block in question.blocks if block not in rounding)
        yield replace(question, blocks=others) if rounding == said else question
        said = rounding or said


def work_question(
    place: QuestionPlace,
    solution: Solution,
    asks: tuple[str, ...],
    language: Language,
    method: Method | None = None,
    *,
    cycle: bool = False,
) -> WorkedQuestion:
    """A solved instance with its statement, its figure as on a paper, and its worked solution, with
    graphs over the `cycle` if wanted; where this speaks of axes that the paper has no need of, they
    stand aside in the figure.
    """
    template = solution.template
    hints = mark_question(template, asks)
    blocks = write_worked_solution(solution, asks, language, method).blocks
    if hints.axes is None and names_axes(blocks):
        hints = replace(hints, axes="aside")
    return WorkedQuestion(
        place.number,
        place.identifier,
        template.about.title.in_language(language),
        write_statement(template, solution.parameters, language, asks),
        (*blocks, *(write_cycle_chapter(solution, asks, language) if cycle else ())),
        draw_figure(template, solution.assembly.mechanism.map(float), hints),
        template.name,
    )
