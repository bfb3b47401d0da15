"""Pages of a single template: a sample for the author (`kinegrade show -o`), a worked solution
(`solve -o`).
"""

from __future__ import annotations

from fractions import Fraction

from kinegrade.errors import MechanismError
from kinegrade.exam.blueprint import Bank, BankAsk, BankQuestion
from kinegrade.exam.dealing import deal_exam
from kinegrade.exam.document import SolutionSheet, WorkedQuestion
from kinegrade.exam.exam_secret import FromWords
from kinegrade.exam.pages import paper_pages
from kinegrade.exam.roster import Roster, Student
from kinegrade.exam.typst import TypstPress
from kinegrade.language import Language
from kinegrade.problem.examining import Refused, require_doubles
from kinegrade.problem.solving import Solution
from kinegrade.problem.statement import statement
from kinegrade.problem.template import Method, Template, Translated
from kinegrade.problem.tolerance import ONE_PER_CENT
from kinegrade.worked.solution import worked_solution


def shown(template: Template) -> tuple[str, ...]:
    """What a page for the author asks: what has points, or all of it where everything is on
    request.
    """
    return template.asked() or tuple(template.asks)


def sample_bank(template: Template) -> Bank:
    """A bank that asks what the template asks; asks on request count one point."""
    asks = tuple(
        BankAsk(name, Fraction(template.asks[name].points or 1), ONE_PER_CENT)
        for name in shown(template)
    )
    question = BankQuestion("q1", template, asks, {})
    return Bank(
        template.about.title,
        Translated("kinegrade", "kinegrade"),
        "",
        ONE_PER_CENT,
        (question,),
        "",
    )


def sample_page(template: Template, seed: str, language: Language) -> bytes:
    """A paper with one instance of the template, as PDF. Raises DrawError, TypesetError."""
    student = Student("sample", "Sample", "", "sample")
    dealt = deal_exam(sample_bank(template), Roster((student,), ()), FromWords(seed))
    return TypstPress().paper(paper_pages(dealt.bank, next(dealt.papers()), language))


def worked_page(solution: Solution, language: Language, method: Method | None = None) -> bytes:
    """The worked solution of an instance for what the template asks, as PDF; the method as in
    `worked_solution`.
    """
    template = solution.template
    try:
        require_doubles(solution)
    except Refused as refusal:
        raise MechanismError(
            f"{template.name}: {refusal}: too large for a worked solution: give smaller values"
        ) from refusal
    worked = worked_solution(solution, shown(template), language, method)
    question = WorkedQuestion(
        1,
        "q1",
        template.about.title.in_language(language),
        statement(template, solution.parameters, language),
        worked.blocks,
        template.name,
    )
    sheet = SolutionSheet(
        language,
        "kinegrade",
        template.about.title.in_language(language),
        "",
        "",
        "",
        "",
        (question,),
    )
    return TypstPress().solution(sheet)
