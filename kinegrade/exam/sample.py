"""A sample page of a single template, for the author and for `kinegrade show -o`."""

from __future__ import annotations

from fractions import Fraction

from kinegrade.exam.blueprint import Bank, BankAsk, BankQuestion, Tolerance
from kinegrade.exam.pages import paper_pages
from kinegrade.exam.roster import Roster, Student
from kinegrade.exam.setting import set_exam
from kinegrade.exam.typst import TypstPress
from kinegrade.problem.template import Language, Template, Translated


def sample_bank(template: Template) -> Bank:
    """A bank that asks what the template asks."""
    tolerance = Tolerance(Fraction(1, 100), Fraction(0))
    asks = tuple(BankAsk(name, Fraction(template.asks[name].points), tolerance) for name in template.asked())
    question = BankQuestion("q1", template, asks, {})
    return Bank(template.title, Translated("kinegrade", "kinegrade"), "", tolerance, (question,), "")


def sample_page(template: Template, seed: str, language: Language) -> bytes:
    """A paper with one instance of the template, as PDF. Raises DrawError, TypesetError."""
    student = Student("sample", "Sample", "", "sample")
    setting = set_exam(sample_bank(template), Roster((student,), ()), seed)
    return TypstPress().paper(paper_pages(setting.bank, next(setting.papers()), language))
