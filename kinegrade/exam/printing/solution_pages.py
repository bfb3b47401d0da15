"""From a set paper to the worked solutions of its questions."""

from __future__ import annotations

from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.printing.pages import write_title
from kinegrade.exam.setting.setting import SetPaper, SetQuestion
from kinegrade.language import Language
from kinegrade.press.sheet import SolutionSheet, WorkedQuestion
from kinegrade.problem.statement import write_statement
from kinegrade.problem.template.template import Method
from kinegrade.worked.solution import write_worked_solution


def write_solution_sheet(
    bank: Bank, paper: SetPaper, language: Language, method: Method | None = None
) -> SolutionSheet:
    """The worked solutions of one student's paper, in the order of the paper.

    By `method` where several serve; None leaves it to each template.
    """
    questions = tuple(
        _work_question(number, question, language, method)
        for number, question in enumerate(paper.printed, start=1)
    )
    return SolutionSheet(
        language,
        bank.course.in_language(language),
        write_title(bank, paper, language),
        bank.date,
        paper.student.student,
        paper.student.name,
        paper.code,
        questions,
    )


def _work_question(
    number: int, question: SetQuestion, language: Language, method: Method | None
) -> WorkedQuestion:
    """A question with its worked solution, for the quantities that are asked."""
    template, solution = question.question.template, question.drawn.solution
    asks = tuple(entry.ask.name for entry in question.asks)
    worked = write_worked_solution(solution, asks, language, method)
    return WorkedQuestion(
        number,
        question.question.identifier,
        template.about.title.in_language(language),
        write_statement(template, solution.parameters, language, asks),
        worked.blocks,
        template.name,
    )
