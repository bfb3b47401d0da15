"""The instance at which a problem is shown, and the keys by which answers to it are judged."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from msgspec.structs import replace

from kinegrade.draws.deck import Combination
from kinegrade.exam.bank.blueprint import BankQuestion
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.key.exact_keys import read_exact_keys
from kinegrade.exam.folder.keys import Key
from kinegrade.exam.printing.head_record import make_ask
from kinegrade.exam.printing.sample import make_sample_bank
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.key_mistakes import find_mistaken_answers
from kinegrade.exam.setting.key_record import make_key_line
from kinegrade.exam.setting.setting import Drawn, Exam, SetPaper, SetQuestion, set_drawn
from kinegrade.language import Language
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template

_SECRET = "preview"  # what is drawn is the same in every preview
_NOBODY = Student(_SECRET, "", "", _SECRET)


@dataclass(frozen=True)
class Instance:
    """A problem at its published values, or at the first that a bank draws from."""

    question: BankQuestion

    @property
    def values(self) -> Combination:
        """The values as texts in the parameters' units."""
        given, parameters = self.question.domains, self.question.template.parameters
        return {
            name: given.get(name, (parameter.default,))[0] for name, parameter in parameters.items()
        }

    @property
    def asks(self) -> tuple[str, ...]:
        """What is asked, by name."""
        return tuple(ask.name for ask in self.question.asks)

    @cached_property
    def solution(self) -> Solution:
        """What is asked, solved. Raises TemplateError, MechanismError."""
        return solve_template(self.question.template, self.values, self.asks)

    def make_keys(self, language: Language) -> tuple[tuple[Ask, Key], ...]:
        """For each ask the key as an exam would keep it, with the sign convention in a language.
        Raises as `solution` does.
        """
        exam = make_exam(self.question)
        tolerances = exam.filters[self.question.identifier].dealt.tolerances_of(self.values)
        drawn = Drawn(self.values, self.solution)
        paper = _make_paper(set_drawn(self.question, drawn, tolerances))
        (mistakes,) = find_mistaken_answers([paper])
        asks = [make_ask(self.question, ask, language) for ask in self.question.asks]
        keys = read_exact_keys(asks, make_key_line(paper, mistakes))
        return tuple(zip(asks, keys, strict=True))


def make_exam(question: BankQuestion) -> Exam:
    """An exam of one question, from whose deck other draws are taken."""
    bank = make_sample_bank(question.template)
    return Exam(replace(bank, questions=(question,)), _SECRET)


def _make_paper(question: SetQuestion) -> SetPaper:
    """A paper with one question, which nobody gets."""
    return SetPaper(_NOBODY, _SECRET, (question,), (0,), "", 0)
