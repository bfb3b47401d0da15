"""Setting papers: what a student was dealt is solved, for each question, with what is right.

A paper is a function of the exam and of what was dealt to the student, so that any paper can be set
anywhere, alone. `kinegrade.exam.setting.dealing` deals to a class.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from kinegrade.draws.deck import Combination, make_deck
from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.exam.bank.blueprint import Bank, BankAsk, BankQuestion
from kinegrade.exam.roster.roster import Student
from kinegrade.mechanics.motion import Motion
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.solution import Solution
from kinegrade.problem.tolerance import find_effective_tolerance


@dataclass(frozen=True)
class Exam:
    """What all papers of an exam are made from: a bank, and the secret that orders its decks."""

    bank: Bank
    secret: str

    @cached_property
    def filters(self) -> Mapping[str, DrawFilter]:
        """The filter of each question."""
        return {
            question.identifier: DrawFilter(
                question.template,
                tuple(ask.name for ask in question.asks),
                make_deck(question.template, self.secret, question.identifier, question.domains),
                {ask.name: ask.tolerance for ask in question.asks},
                self.bank.four_decimals,
            )
            for question in self.bank.questions
        }


@dataclass(frozen=True)
class DealtPaper:
    """What a student was dealt: a place, from which all else follows, a code that is printed on the
    paper, and the values of each question in the bank's order.

    `order` says in which order the questions are printed; `version` is a letter, or "" where the
    numbers are the student's alone.
    """

    student: Student
    place: int
    code: str
    version: str
    order: tuple[int, ...]
    values: tuple[Combination, ...]


@dataclass(frozen=True)
class SetAsk:
    """An ask of one paper with its answer and the tolerance that holds for it."""

    ask: BankAsk
    answer: Quantity
    tolerance: Tolerance
    cyclic: bool


@dataclass(frozen=True)
class Drawn:
    """An instance: the values as texts in the parameters' units, and its solution."""

    values: Combination
    solution: Solution


@dataclass(frozen=True)
class SetQuestion:
    """A question of one paper: what was drawn and what is right."""

    question: BankQuestion
    drawn: Drawn
    asks: tuple[SetAsk, ...]


@dataclass(frozen=True)
class SetPaper:
    """One student's paper; `code` is printed on it and kept in the key.

    `questions` are in the bank's order, `order` is the one in which they are printed; `version` is
    a letter, or "" where the paper is the student's alone; `place` is the student's in the class,
    None where a folder of format 1 does not say it.
    """

    student: Student
    code: str
    questions: tuple[SetQuestion, ...]
    order: tuple[int, ...]
    version: str
    place: int | None

    @property
    def printed(self) -> tuple[SetQuestion, ...]:
        """The questions in their order on the paper."""
        return tuple(self.questions[place] for place in self.order)


def set_paper(exam: Exam, dealt: DealtPaper) -> SetPaper:
    """The paper with what was dealt. Raises MechanismError where that cannot be solved."""
    questions = tuple(
        set_drawn(question, Drawn(values, exam.filters[question.identifier].solved(values)))
        for question, values in zip(exam.bank.questions, dealt.values, strict=True)
    )
    return SetPaper(dealt.student, dealt.code, questions, dealt.order, dealt.version, dealt.place)


def set_drawn(question: BankQuestion, drawn: Drawn) -> SetQuestion:
    """A question whose instance has been drawn."""
    asks = tuple(
        _set_ask(question, ask, drawn.solution[ask.name], drawn.solution.doubles)
        for ask in question.asks
    )
    return SetQuestion(question, drawn, asks)


def _set_ask(question: BankQuestion, ask: BankAsk, answer: Quantity, motion: Motion) -> SetAsk:
    """An ask with its answer; `motion` gives the mechanism's scale, which sets the tolerance if the
    answer is close to zero.
    """
    tolerance = find_effective_tolerance(ask.tolerance, answer.value, answer.measure, motion)
    return SetAsk(ask, answer, tolerance, question.template.asks[ask.name].cyclic)
