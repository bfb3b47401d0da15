"""Setting an exam: for each student of the roster, or for each version, every question is drawn and
solved.

`set_exam` gives the papers one after the other, so that memory does not grow with the class.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import count

from kinegrade.errors import DrawError
from kinegrade.exam.blueprint import Bank, BankAsk, BankQuestion
from kinegrade.exam.exam_secret import ExamSecret
from kinegrade.exam.roster import Roster, Student
from kinegrade.exam.versions import version_letters, version_of
from kinegrade.mechanics.doubles import MotionInDoubles
from kinegrade.problem.drawing import Deck, Drawn, address
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.tolerance import Tolerance, effective

SEEN_AHEAD = 64  # students whose draws are looked at together
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

    `questions` stand in the bank's order, `order` says in which they are printed; `version` is a
    letter, or "" where the paper is the student's own.
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
    secret: ExamSecret
    decks: Mapping[str, Deck]
    codes: Mapping[str, str]  # by student

    def papers(self, places: Sequence[int] | None = None) -> Iterator[SetPaper]:
        """The papers in roster order, or of the students at these places of the roster.

        Raises DrawError when a template has too few instances for the class.
        """
        letters = version_letters(self.bank.versions)
        versions = {letter: self.draw(f"version {letter}") for letter in letters}
        places = range(len(self.roster.students)) if places is None else places
        for number, place in enumerate(places):
            student = self.roster.students[place]
            code = self.codes[student.student]
            if versions:
                letter = version_of(self.secret.drawing, place, letters)
                yield SetPaper(
                    student,
                    f"{letter}-{code}",
                    versions[letter],
                    self.order(f"version {letter}"),
                    letter,
                )
            else:
                if number % SEEN_AHEAD == 0:
                    self.foresee(places[number : number + SEEN_AHEAD])
                yield SetPaper(
                    student, code, self.draw(student.student), self.order(student.student), ""
                )

    def foresee(self, places: Sequence[int]) -> None:
        """Look ahead at the draws of the students at these places."""
        for deck in self.decks.values():
            deck.foresee([self.roster.students[place].student for place in places])

    def draw(self, whose: str) -> tuple[SetQuestion, ...]:
        """The questions of a student, or of a version."""
        return tuple(
            set_question(question, self.decks[question.identifier], whose)
            for question in self.bank.questions
        )

    def order(self, whose: str) -> tuple[int, ...]:
        """The order in which the questions of a student, or of a version, are printed."""
        places = range(len(self.bank.questions))
        if not self.bank.shuffle:
            return tuple(places)
        return tuple(
            sorted(
                places,
                key=lambda place: address(
                    self.secret.drawing, "order", whose, self.bank.questions[place].identifier
                ),
            )
        )

    def combinations(self) -> dict[str, int]:
        """For each question how many combinations of values can be drawn."""
        return {name: deck.combinations() for name, deck in self.decks.items()}

    def refusals(self) -> dict[str, dict[str, int]]:
        """For each question how often a draw was refused, by reason."""
        return {name: dict(sorted(deck.refused.items())) for name, deck in self.decks.items()}


def set_exam(bank: Bank, roster: Roster, secret: ExamSecret) -> Setting:
    """A setting. Raises DrawError for every question with fewer combinations than there are papers
    to be drawn.
    """
    decks = {
        question.identifier: Deck(
            question.template,
            tuple(ask.name for ask in question.asks),
            secret.drawing,
            question.identifier,
            question.domains,
            tolerances={ask.name: ask.tolerance for ask in question.asks},
            four_decimals=bank.four_decimals,
        )
        for question in bank.questions
    }
    needed, whose = (
        (bank.versions, "versions") if bank.versions else (len(roster.students), "students")
    )
    few = [
        f"{name} ({deck.template.name}): {deck.combinations()} combinations are drawable for "
        f"{needed} {whose}: widen the domains"
        for name, deck in decks.items()
        if deck.combinations() < needed
    ]
    if few:
        raise DrawError(*few)
    codes = paper_codes(secret.coding, (student.student for student in roster.students))
    return Setting(bank, roster, secret, decks, codes)


def set_question(question: BankQuestion, deck: Deck, whose: str) -> SetQuestion:
    """A question drawn for a student, or for a version."""
    return set_drawn(question, deck.draw(whose))


def set_drawn(question: BankQuestion, drawn: Drawn) -> SetQuestion:
    """A question of which an instance is drawn already."""
    asks = tuple(
        set_ask(question, ask, drawn.solution[ask.name], drawn.solution.doubles)
        for ask in question.asks
    )
    return SetQuestion(question, drawn, asks)


def set_ask(
    question: BankQuestion, ask: BankAsk, answer: Quantity, motion: MotionInDoubles
) -> SetAsk:
    """An ask with its answer; `motion` gives room by the mechanism's own scale where the answer is
    next to zero.
    """
    tolerance = effective(ask.tolerance, answer.value, answer.measure, motion)
    return SetAsk(ask, answer, tolerance, question.template.asks[ask.name].cyclic)


def paper_codes(secret: str, students: Iterable[str]) -> dict[str, str]:
    """The code of everybody's paper, no two alike; where two would be, the one further down gets
    another.
    """
    codes: dict[str, str] = {}
    taken: set[str] = set()
    for student in students:
        attempts = (paper_code(secret, student, attempt) for attempt in count())
        codes[student] = next(code for code in attempts if code not in taken)
        taken.add(codes[student])
    return codes


def paper_code(secret: str, student: str, attempt: int = 0) -> str:
    """The code of a student's paper, like K7Q2-9FHM: 40 bits of the secret for codes and the
    student's id.
    """
    further = (attempt,) if attempt else ()
    number = address(secret, "paper", student, *further)
    text = "".join(LETTERS[number >> 5 * place & 31] for place in range(8))
    return f"{text[:4]}-{text[4:]}"
