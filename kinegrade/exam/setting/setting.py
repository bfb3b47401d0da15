"""Setting papers: what a student was dealt is solved, for each question, with what is right.

A paper is a function of the exam and of what was dealt to the student, so that any paper can be set
anywhere, alone. `kinegrade.exam.setting.dealing` deals to a class.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from kinegrade.draws.deck import Combination, make_deck
from kinegrade.draws.draw_filter import DrawFilter
from kinegrade.draws.earlier import find_earlier_draws
from kinegrade.exam.bank.blueprint import Bank, BankAsk, BankQuestion
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.widening import say_how_to_widen
from kinegrade.figure.sketch import Sketcher
from kinegrade.figure.sketchbook import choose_sketcher
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.solution import Solution
from kinegrade.question_numbers import number_printed


@dataclass(frozen=True)
class Exam:
    """What all papers of an exam are made from: a bank, and the secret that orders its decks.

    `sketchbook` is a private folder where processes share figures.
    """

    bank: Bank
    secret: str
    sketchbook: Path | None = None

    @property
    def sketcher(self) -> Sketcher:
        """What draws the figures of its papers."""
        return choose_sketcher(self.sketchbook)

    @cached_property
    def filters(self) -> Mapping[str, DrawFilter]:
        """The filter of each question."""
        return {
            question.identifier: self._make_filter(question) for question in self.bank.questions
        }

    def _make_filter(self, question: BankQuestion) -> DrawFilter:
        template, asks = question.template, tuple(ask.name for ask in question.asks)
        deck = make_deck(template, self.secret, question.identifier, question.domains)
        return DrawFilter(
            template,
            asks,
            deck,
            {ask.name: ask.tolerance for ask in question.asks},
            four_decimals=self.bank.four_decimals,
            carry=self.bank.carry,
            honest=frozenset(ask.name for ask in question.asks if ask.honest),
            sketcher=self.sketcher,
            earlier=find_earlier_draws(
                template, asks, deck, self.bank.earlier.get(template.name, ())
            ),
            widening=say_how_to_widen(question),
        )


class DealtPaper(Struct, frozen=True):
    """What a student was dealt: a place, from which all else follows, a code that is printed on the
    paper, and the values of each of its questions, in the bank's order.

    `order` says in which order these are printed; `version` is a letter, or "" where the
    numbers are the student's alone.
    """

    student: Student
    place: int
    code: str
    version: str
    order: tuple[int, ...]
    values: Mapping[str, Combination]


class SetAsk(Struct, frozen=True):
    """An ask of one paper with its answer and the tolerance that holds for it."""

    ask: BankAsk
    answer: Quantity
    tolerance: Tolerance
    cyclic: bool

    @property
    def stated(self) -> Tolerance:
        """The tolerance as the paper states it: without the amount that holds next to zero, which
        would give the answer away.
        """
        return state_tolerance(self.ask, self.tolerance)


class Drawn(Struct, frozen=True):
    """An instance: the values as texts in the parameters' units, and its solution."""

    values: Combination
    solution: Solution


class SetQuestion(Struct, frozen=True):
    """A question of one paper: what was drawn and what is right."""

    question: BankQuestion
    drawn: Drawn
    asks: tuple[SetAsk, ...]


class SetPaper(Struct, frozen=True):
    """One student's paper; `code` is printed on it and kept in the key.

    `questions` are those that it holds, in the bank's order, `order` is the one in which they are
    printed; `version` is a letter, or "" where the paper is the student's alone; `place` is the
    student's in the class, None where a folder of format 1 does not say it.
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

    @property
    def numbered(self) -> list[tuple[int, SetQuestion]]:
        """The same with their numbers on the paper."""
        printed = self.printed
        numbers = number_printed([each.question.identifier for each in printed])
        return list(zip(numbers, printed, strict=True))


def set_paper(exam: Exam, dealt: DealtPaper) -> SetPaper:
    """The paper with what was dealt. Raises MechanismError where that cannot be solved."""
    questions = tuple(
        _set_question(
            question, dealt.values[question.identifier], exam.filters[question.identifier]
        )
        for question in exam.bank.questions
        if question.identifier in dealt.values
    )
    return SetPaper(dealt.student, dealt.code, questions, dealt.order, dealt.version, dealt.place)


def set_papers(exam: Exam, dealt: Sequence[DealtPaper]) -> list[SetPaper]:
    """Several papers, which are set faster together than one by one. Raises as `set_paper`."""
    for name, draw_filter in exam.filters.items():
        draw_filter.dealt.round_together(each.values[name] for each in dealt if name in each.values)
    return [set_paper(exam, each) for each in dealt]


def _set_question(
    question: BankQuestion, values: Combination, draw_filter: DrawFilter
) -> SetQuestion:
    drawn = Drawn(values, draw_filter.dealt.solved(values))
    return set_drawn(question, drawn, draw_filter.dealt.tolerances_of(values))


def set_drawn(
    question: BankQuestion, drawn: Drawn, tolerances: Mapping[str, Tolerance]
) -> SetQuestion:
    """A question whose instance has been drawn; `tolerances` are those by which its answers are
    marked, by ask.
    """
    solution, template = drawn.solution, question.template
    asks = (
        SetAsk(ask, solution[ask.name], tolerances[ask.name], template.asks[ask.name].cyclic)
        for ask in question.asks
    )
    return SetQuestion(question, drawn, tuple(asks))


def state_tolerance(ask: BankAsk, kept: Tolerance) -> Tolerance:
    """The tolerance that a paper states for an ask, from the one that its key keeps."""
    return replace(kept, absolute=ask.tolerance.absolute)
