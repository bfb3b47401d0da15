"""Pages outside an exam: a sample of a template for its author (`kinegrade show -o`), a first proof
of a bank (`sample`), a worked solution (`solve -o`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from kinegrade.cycles.chapter import require_graphs
from kinegrade.draws.examining import Refused, require_doubles
from kinegrade.errors import MechanismError
from kinegrade.exam.bank.blueprint import Bank, BankAsk, BankQuestion, Blueprint
from kinegrade.exam.bank.texts import require_bank_language
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.printing.pages import QuestionPlace, lay_out_paper
from kinegrade.exam.printing.printing import PressOrder
from kinegrade.exam.printing.solution_pages import work_question
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.contradictions import list_contradictions
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.language import Language
from kinegrade.language.message import Fault, Message
from kinegrade.numbers.tolerance import ONE_PER_CENT
from kinegrade.press.sheet import SolutionSheet
from kinegrade.press.typst.press import TypstPress
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Method, Template
from kinegrade.problem.template.texts import require_language
from kinegrade.problem.template.translated import Translated


def _list_shown(template: Template) -> tuple[str, ...]:
    """What a page for the author asks: what has points, or all of it where everything is on
    request.
    """
    return template.asked() or tuple(template.asks)


def make_sample_bank(template: Template) -> Bank:
    """A bank that asks what the template asks; asks on request count one point."""
    asks = tuple(
        BankAsk(name, Fraction(template.asks[name].points or 1), ONE_PER_CENT, True)
        for name in _list_shown(template)
    )
    question = BankQuestion("q1", template, asks, {})
    return Bank(
        template.about.title,
        Translated(plain="kinegrade"),
        "",
        ONE_PER_CENT,
        (question,),
        "",
        honest=True,
    )


def print_sample(template: Template, seed: str, language: Language) -> bytes:
    """A paper with one instance of the template, as PDF. Raises DrawError, TypesetError."""
    student = Student("sample", "Sample", "", "sample")
    dealt = deal_exam(make_sample_bank(template), Roster((student,), ()), FromWords(seed))
    return TypstPress().paper(lay_out_paper(dealt.bank, next(dealt.papers()), language))


@dataclass(frozen=True)
class FirstProof:
    """One paper of a bank, as nobody gets it, as PDF, and what it says that is not so."""

    pdf: bytes
    complaints: tuple[Fault, ...]


def print_first_proof(blueprint: Blueprint, seed: str, language: Language) -> FirstProof:
    """A first proof of a bank. Raises BankError, DrawError, TypesetError."""
    secret = FromWords(seed)
    bank = blueprint.bank(secret.drawing)
    require_bank_language(bank, language)
    student = Student("sample", "Sample", "", "sample")
    dealt = deal_exam(bank, Roster((student,), ()), secret)
    press = PressOrder(bank.engine, "a4").press()
    sheet = lay_out_paper(bank, next(dealt.papers()), language)
    pdf = press.papers({student.file_name: sheet})[student.file_name].pdf
    return FirstProof(pdf, tuple(list_contradictions(dealt)))


def print_worked_solution(
    solution: Solution,
    language: Language,
    asks: Sequence[str] | None = None,
    method: Method | None = None,
    *,
    cycle: bool = False,
    large: bool = False,
) -> bytes:
    """The worked solution of an instance for these asks, by default for what the template gives
    points for, as PDF, with graphs over the `cycle` or in `large` print if wanted; the method as in
    `write_worked_solution`. Raises MechanismError for what cannot be worked or does not move,
    TemplateError where no answer has a graph.
    """
    template = solution.template
    require_language([template], language)
    try:
        require_doubles(solution)
    except Refused as refusal:
        what = Message("exam.too-large-to-work", reason=refusal.detail)
        raise MechanismError(Fault(template.name, what)) from refusal
    worked_out = _list_shown(template) if asks is None else tuple(asks)
    if cycle:
        require_graphs(solution, worked_out)
    place = QuestionPlace(1, "q1")
    question = work_question(place, solution, worked_out, language, method, cycle=cycle)
    sheet = SolutionSheet(
        language,
        "kinegrade",
        template.about.title.in_language(language),
        "",
        "",
        "",
        "",
        (question,),
        large,
    )
    return TypstPress().solution(sheet)
