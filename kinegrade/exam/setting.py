"""Setting an exam: for each student of the roster, or for each version, every question is drawn and solved.

`set_exam` gives the papers one after the other, so that memory does not grow with the class.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import floor, log10

from kinegrade.errors import DrawError
from kinegrade.exam.blueprint import Bank, BankAsk, BankQuestion, Tolerance
from kinegrade.exam.roster import Roster, Student
from kinegrade.exam.versions import version_letters, version_of
from kinegrade.problem.drawing import Deck, Drawn, address
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.scale import scale

LETTERS = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"  # without I, L, O, U, which are misread


@dataclass(frozen=True)
class SetAsk:
    """An ask of one paper with its answer and the tolerance that holds for it."""

    ask: BankAsk
    answer: Quantity
    tolerance: Tolerance
    cyclic: bool


@dataclass(frozen=True)
class SetQuestion:
    """A question of one paper: what was drawn and what is right."""

    question: BankQuestion
    drawn: Drawn
    asks: tuple[SetAsk, ...]


@dataclass(frozen=True)
class SetPaper:
    """One student's paper; `code` is printed on it and kept in the key.

    `questions` stand in the bank's order, `order` says in which they are printed; `version` is a letter, or "" where
    the paper is the student's own.
    """

    student: Student
    code: str
    questions: tuple[SetQuestion, ...]
    order: tuple[int, ...]
    version: str

    @property
    def printed(self) -> tuple[SetQuestion, ...]:
        """The questions as they follow on the paper."""
        return tuple(self.questions[place] for place in self.order)


@dataclass(frozen=True)
class Setting:
    """A bank, a class and a secret, ready to be drawn from."""

    bank: Bank
    roster: Roster
    secret: str
    decks: Mapping[str, Deck]

    def papers(self, places: Sequence[int] | None = None) -> Iterator[SetPaper]:
        """The papers in roster order, or of the students at these places of the roster.

        Raises DrawError when a template has too few instances for the class.
        """
        letters = version_letters(self.bank.versions)
        versions = {letter: self.draw(f"version {letter}") for letter in letters}
        for place in range(len(self.roster.students)) if places is None else places:
            student = self.roster.students[place]
            code = paper_code(self.secret, student.student)
            if versions:
                letter = version_of(self.secret, place, letters)
                yield SetPaper(student, f"{letter}-{code}", versions[letter], self.order(f"version {letter}"), letter)
            else:
                yield SetPaper(student, code, self.draw(student.student), self.order(student.student), "")

    def draw(self, whose: str) -> tuple[SetQuestion, ...]:
        """The questions of a student, or of a version."""
        return tuple(set_question(question, self.decks[question.identifier], whose) for question in self.bank.questions)

    def order(self, whose: str) -> tuple[int, ...]:
        """The order in which the questions of a student, or of a version, are printed."""
        places = range(len(self.bank.questions))
        if not self.bank.shuffle:
            return tuple(places)
        return tuple(sorted(places, key=lambda place: address(self.secret, "order", whose,
                                                              self.bank.questions[place].identifier)))

    def refusals(self) -> dict[str, dict[str, int]]:
        """For each question how often a draw was refused, by reason."""
        return {name: dict(sorted(deck.refused.items())) for name, deck in self.decks.items()}


def set_exam(bank: Bank, roster: Roster, secret: str) -> Setting:
    """A setting. Raises DrawError for every question with fewer combinations than there are papers to be drawn."""
    decks = {question.identifier: Deck(question.template, tuple(ask.name for ask in question.asks), secret,
                                       question.identifier, question.domains)
             for question in bank.questions}
    count, whose = (bank.versions, "versions") if bank.versions else (len(roster.students), "students")
    few = [f"{name} ({deck.template.name}): {deck.combinations()} combinations are drawable for {count} {whose}: "
           "widen the domains" for name, deck in decks.items() if deck.combinations() < count]
    if few:
        raise DrawError(*few)
    return Setting(bank, roster, secret, decks)


def set_question(question: BankQuestion, deck: Deck, whose: str) -> SetQuestion:
    """A question drawn for a student, or for a version."""
    drawn = deck.draw(whose)
    asks = tuple(SetAsk(ask, drawn.solution[ask.name], effective(ask, drawn),
                        question.template.asks[ask.name].cyclic) for ask in question.asks)
    return SetQuestion(question, drawn, asks)


def effective(ask: BankAsk, drawn: Drawn) -> Tolerance:
    """The tolerance of an ask; an answer that is exactly zero gets room from the mechanism's own scale."""
    answer = drawn.solution[ask.name]
    if not answer.is_zero:
        return ask.tolerance
    room = ask.tolerance.relative * two_figures(scale(drawn.solution.motion, answer.measure))
    return Tolerance(ask.tolerance.relative, max(ask.tolerance.absolute, room))


def two_figures(size: float) -> Fraction:
    """A size rounded to two significant figures, exactly."""
    if size <= 0:
        return Fraction(0)
    step = Fraction(10) ** (floor(log10(size)) - 1)
    return round(Fraction(size) / step) * step


def paper_code(secret: str, student: str) -> str:
    """The code of a student's paper, like K7Q2-9FHM: 40 bits of the secret and the student's id."""
    number = address(secret, "paper", student)
    text = "".join(LETTERS[number >> 5 * place & 31] for place in range(8))
    return f"{text[:4]}-{text[4:]}"
