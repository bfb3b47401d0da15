"""A part of the class drawn and printed ahead, as if nobody else were there, and confirmed afterwards.

Drawing takes long and depends on the other students only in that no two get the same numbers. So parts of the class are
drawn side by side; then, in roster order, every paper whose numbers somebody before it has is drawn and printed again.
The papers are those that drawing one after the other gives.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass

from kinegrade.errors import DrawError
from kinegrade.exam.press import Press
from kinegrade.exam.printing import Printed, PrintRun, print_papers
from kinegrade.exam.setting import SetPaper, Setting
from kinegrade.mechanics.plan import Plan

Plans = Mapping[str, Plan | None]  # by question
Values = tuple[str, ...]


@dataclass(frozen=True)
class Draft:
    """A paper that is printed; what was drawn for each question, and how often a draw was refused, by reason."""

    printed: Printed
    values: Mapping[str, Values]
    refused: Mapping[str, Counter[str]]


def drafts(run: PrintRun, setting: Setting, press: Press, places: Sequence[int], plans: Plans) -> list[Draft]:
    """The papers of the students at these places, up to the first for whom nothing can be drawn.

    Each question is solved by its plan of `plans`, whoever solves it. Raises TypesetError.
    """
    for name, deck in setting.decks.items():
        deck.taken.clear()
        deck.plan = plans[name]
    papers: list[SetPaper] = []
    refused = []
    with suppress(DrawError):
        for paper in setting.papers(places):
            papers.append(paper)
            refused.append({name: Counter(deck.refused) for name, deck in setting.decks.items()})
            for deck in setting.decks.values():
                deck.refused.clear()
    done = print_papers(run, press, papers)
    return [Draft(printed, values_of(paper), counts)
            for printed, paper, counts in zip(done, papers, refused, strict=True)]


def confirmed(run: PrintRun, setting: Setting, press: Press, places: Sequence[int],
              found: Sequence[Draft]) -> Iterator[Printed]:
    """What remains of the papers at these places, after all before them are confirmed; those that clash anew.

    Raises DrawError when nothing can be drawn for a student, TypesetError.
    """
    for number, place in enumerate(places):
        if number < len(found) and not clashes(setting, found[number]):
            note(setting, found[number])
            yield found[number].printed
        else:
            yield from print_papers(run, press, list(setting.papers([place])))


def clashes(setting: Setting, draft: Draft) -> bool:
    """Whether another student has the numbers of one of its questions; versions are nobody's own."""
    return not setting.bank.versions and any(values in setting.decks[name].taken
                                             for name, values in draft.values.items())


def note(setting: Setting, draft: Draft) -> None:
    """Let the decks know of a draft as if they had drawn it."""
    for name, values in draft.values.items():
        setting.decks[name].taken.add(values)
        setting.decks[name].refused.update(draft.refused[name])


def plans_of(setting: Setting) -> Plans:
    """The plan of each question, from the first paper of the class. Raises DrawError."""
    next(setting.papers([0]))
    return {name: deck.plan for name, deck in setting.decks.items()}


def values_of(paper: SetPaper) -> dict[str, Values]:
    """The values drawn, as a deck keeps them."""
    return {question.question.identifier: tuple(question.drawn.values.values()) for question in paper.questions}
