"""A part of the class drawn and printed by one of several processes, as if papers were drawn one
after the other.

Drawing takes long and depends on the other students only in that no two get the same numbers. So
parts of the class are drawn side by side as if nobody else were there; then a process learns from
the ledger what everybody before its part got, and draws again, in roster order, each question whose
numbers somebody before has. Nothing is printed twice.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

from kinegrade.errors import DrawError
from kinegrade.exam.ledger import Ledger, Numbers, Values
from kinegrade.exam.press import Press
from kinegrade.exam.printing import Printed, PrintRun, print_papers
from kinegrade.exam.setting import SetPaper, SetQuestion, Setting, set_question
from kinegrade.mechanics.plan import Plan
from kinegrade.problem.drawing import Deck

Plans = Mapping[str, Plan | None]  # by question
Refusals = Mapping[str, Counter[str]]  # by question: how often a draw was refused, by reason
DrawnPaper = tuple[SetPaper, Refusals]


@dataclass(frozen=True)
class Draft:
    """A paper that is printed; what was drawn for each question, and what was refused on the
    way.
    """

    printed: Printed
    values: Numbers
    refused: Refusals


@dataclass(frozen=True)
class Workplace:
    """What a process works with: the decks, the press, and what it knows of the others."""

    setting: Setting
    press: Press
    ledger: Ledger


def drafts(run: PrintRun, workplace: Workplace, part: int, places: Sequence[int]) -> list[Draft]:
    """The papers of the students at these places, up to the first for whom nothing can be drawn.

    Raises TypesetError. Whatever happens, the ledger gets the page of this part, for which others
    wait.
    """
    papers: list[DrawnPaper] = []
    try:
        papers = drawn(workplace.setting, workplace.ledger, part, places)
    finally:
        workplace.ledger.write(part, [values_of(paper) for paper, _ in papers])
    done = print_papers(run, workplace.press, [paper for paper, _ in papers]) if papers else []
    return [
        Draft(printed, values_of(paper), refused)
        for printed, (paper, refused) in zip(done, papers, strict=True)
    ]


def drawn(setting: Setting, ledger: Ledger, part: int, places: Sequence[int]) -> list[DrawnPaper]:
    """The papers of a part of the class. Versions are drawn for every part, and counted for the
    first.
    """
    papers = drawn_alone(setting, places)
    if setting.bank.versions:
        return papers if part == 0 else [(paper, {}) for paper, _ in papers]
    ledger.read_before(part)
    return drawn_apart(setting, papers, ledger.taken)


def drawn_alone(setting: Setting, places: Sequence[int]) -> list[DrawnPaper]:
    """The papers as if there were no other students, up to the first for whom nothing can be
    drawn.
    """
    for deck in setting.decks.values():
        deck.taken = set()
        deck.refused.clear()
    papers: list[DrawnPaper] = []
    with suppress(DrawError):
        for paper in setting.papers(places):
            papers.append((paper, {name: counted(deck) for name, deck in setting.decks.items()}))
    return papers


def drawn_apart(
    setting: Setting, papers: Sequence[DrawnPaper], taken: Mapping[str, set[Values]]
) -> list[DrawnPaper]:
    """The papers without numbers that are taken, up to the first for which none are left; what they
    get is taken.
    """
    for name, deck in setting.decks.items():
        deck.taken = taken[name]
        deck.refused.clear()
    done: list[DrawnPaper] = []
    with suppress(DrawError):
        for paper, refused in papers:
            apart = tuple(
                question_apart(
                    question, setting.decks[question.question.identifier], paper.student.student
                )
                for question in paper.questions
            )
            again = {
                new.question.identifier: counted(setting.decks[new.question.identifier])
                for new, old in zip(apart, paper.questions, strict=True)
                if new is not old
            }
            done.append((replace(paper, questions=apart), {**refused, **again}))
    return done


def question_apart(question: SetQuestion, deck: Deck, student: str) -> SetQuestion:
    """The question, or another one for this student where its numbers are taken. Raises
    DrawError.
    """
    numbers = values(question)
    if numbers in deck.taken:
        return set_question(question.question, deck, student)
    deck.taken.add(numbers)
    return question


def counted(deck: Deck) -> Counter[str]:
    """What a deck has refused since this was last asked."""
    refused = Counter(deck.refused)
    deck.refused.clear()
    return refused


def confirmed(
    run: PrintRun, setting: Setting, press: Press, places: Sequence[int], found: Sequence[Draft]
) -> Iterator[Printed]:
    """What remains of the papers at these places, noted in the decks after all before them as if
    those had drawn them.

    Raises DrawError when nothing can be drawn for a student, TypesetError.
    """
    for draft in found:
        for name, numbers in draft.values.items():
            setting.decks[name].taken.add(numbers)
        for name, counts in draft.refused.items():
            setting.decks[name].refused.update(counts)
        yield draft.printed
    for place in places[len(found) :]:
        yield from print_papers(run, press, list(setting.papers([place])))


def plans_of(setting: Setting) -> Plans:
    """The plan of each question, from the first paper of the class. Raises DrawError."""
    next(setting.papers([0]))
    return {name: deck.plan for name, deck in setting.decks.items()}


def use(plans: Plans, setting: Setting) -> None:
    """Let each question be solved by its plan, whoever solves it."""
    for name, deck in setting.decks.items():
        deck.plan = plans[name]


def values_of(paper: SetPaper) -> Numbers:
    """The values drawn for each question."""
    return {question.question.identifier: values(question) for question in paper.questions}


def values(question: SetQuestion) -> Values:
    """The values drawn, as a deck keeps them."""
    return tuple(question.drawn.values.values())
