"""An exam's blueprint, and the exam that a secret makes of it.

`bank` reads a blueprint from its file; `setting` draws numbers for the questions of the Bank that
is chosen here. What is chosen is the same for the whole class, because the class shares one answer
sheet.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Set
from fractions import Fraction
from functools import partial
from string import ascii_lowercase
from typing import Literal, TypeAlias, assert_never

from msgspec import Struct, field
from msgspec.structs import replace

from kinegrade.draws.keyed_order import address
from kinegrade.exam.bank.by_hand import HandQuestion
from kinegrade.exam.bank.header import NO_HEADER, Header
from kinegrade.exam.bank.matching import match_slots
from kinegrade.exam.choices import Choice
from kinegrade.exam.homework import AN_EXAM, Homework
from kinegrade.grade_scale.stated import StatedScale
from kinegrade.numbers.tolerance import USUAL_CARRY, Tolerance
from kinegrade.press.protocol import Engine
from kinegrade.press.sheet import FormulaSheet
from kinegrade.problem.template.beside import Translations
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.translated import Translated
from kinegrade.stated_marking import StatedCredit

LMS = Literal["canvas"]  # systems that do not take every answer
# Numbers of each student's own, or repeated where there are too few, or the same for everybody
Dealing = Literal["own", "repeated", "same"]
# The key by which an entry names or draws the templates of its questions, or states its own
Chosen = Literal["template", "any", "family", "tag", "steps"]


class BankAsk(Struct, frozen=True):
    """One quantity asked for; the tolerance of one that is `honest` is widened on each paper to
    what honest rounding takes at its numbers.
    """

    name: str
    points: Fraction
    tolerance: Tolerance
    honest: bool = False


class BankQuestion(Struct, frozen=True):
    """One question: its template, what is asked, domains that replace the template's, the
    millimetres left for working, how its numbers are dealt, whether its points are a `bonus` on top
    of the maximum, and by which key of its entry its template was `chosen`.
    """

    identifier: str
    template: Template
    asks: tuple[BankAsk, ...]
    domains: Mapping[str, tuple[str, ...]]
    space: float = 0.0
    dealing: Dealing = "own"
    bonus: bool = False
    chosen: Chosen = "template"

    @property
    def points(self) -> Fraction:
        """The sum of the asks' points."""
        return sum((ask.points for ask in self.asks), Fraction(0))


Earlier: TypeAlias = Mapping[str, tuple[Mapping[str, str], ...]]  # by template the values dealt


class Bank(Struct, frozen=True):
    """An exam's questions with all that holds for the exam; `text` is the file as it was read, kept
    with the exam, as are the texts of the `translations` beside it.

    `tolerance`, `honest` as for an ask, is what asks have of which nothing else is stated; `carry`
    is the number of significant figures that students are asked to carry. `space` is what questions
    have for working that state nothing else, in millimetres; `shuffle` gives every paper its own
    order of the questions; `versions` is the number of different papers, 0 for a different one for
    each student; `engine` is the typesetter unless an instructor asks for another; `credit` is for
    answers that are not right, `scale` for the grades of totals, `homework` says what is set and
    when it is due; with `solutions`, feedback includes the worked solutions unless requested
    otherwise, and with `cycle` they end with graphs over it; `lms` is the system that the exam will
    be imported into, if its draws have to suit one; `header` is the head of the papers; the
    questions `by_hand` have no mechanism, and stand between the others; the `formula_sheet` is
    bound behind every paper; of the questions of `choices` each paper holds only some. `earlier` is
    no part of the file: what earlier exams dealt, and this one is not to deal again.
    """

    title: Translated
    course: Translated
    date: str
    tolerance: Tolerance
    questions: tuple[BankQuestion, ...]
    text: str
    translations: Translations = field(default_factory=dict)
    honest: bool = False
    carry: int = USUAL_CARRY
    space: float = 0.0
    shuffle: bool = False
    versions: int = 0
    engine: Engine = "typst"
    credit: StatedCredit = field(default_factory=StatedCredit)
    scale: StatedScale | None = None
    homework: Homework = AN_EXAM
    solutions: bool = False
    cycle: bool = False
    lms: LMS | None = None
    header: Header = NO_HEADER
    by_hand: tuple[HandQuestion, ...] = ()
    earlier: Earlier = field(default_factory=dict)
    formula_sheet: FormulaSheet | None = None
    choices: tuple[Choice, ...] = ()

    @property
    def states_orders(self) -> bool:
        """Whether the key states for each paper which questions it holds in which order."""
        return self.shuffle or bool(self.choices)

    @property
    def texts(self) -> Mapping[str, Translated]:
        """What is printed on papers of the bank's own, by the keys at which it stands."""
        head = {f"header.{name}": text for name, text in self.header.texts.items()}
        by_hand = {
            f"{each.identifier}.{name}": text
            for each in self.by_hand
            for name, text in (("title", each.title), ("text", each.text))
        }
        return {"title": self.title, "course": self.course, **head, **by_hand}

    @property
    def has_bonus(self) -> bool:
        """Whether points of some questions come on top of the maximum."""
        marked = any(each.bonus for each in self.questions)
        return marked or any(each.bonus for each in self.by_hand)

    @property
    def four_decimals(self) -> bool:
        """Whether the system keeps no more than four decimals of an answer."""
        match self.lms:
            case "canvas":
                return True
            case None:
                return False
            case _:
                assert_never(self.lms)


class Slot(Struct, frozen=True):
    """One question of an exam: the questions it may become; one of them is `drawn`, or there is
    only one.

    Where some are `given` to each paper, it stands for so many questions, and the candidates, those
    that are drawn without what the bank names elsewhere, are alternatives.
    """

    identifier: str
    candidates: tuple[BankQuestion, ...]
    drawn: bool
    given: int = 0

    @property
    def count(self) -> int:
        """How many questions of a paper it stands for."""
        return self.given or 1

    def list_alternatives(self, named: Set[str]) -> tuple[BankQuestion, ...]:
        """The alternatives, each with a letter; `named` are the templates that the bank names."""
        left = [
            each for each in self.candidates if not self.drawn or each.template.name not in named
        ]
        return tuple(
            replace(each, identifier=f"{self.identifier}{letter}")
            for each, letter in zip(left, ascii_lowercase, strict=False)
        )


class Blueprint(Struct, frozen=True):
    """A bank as it is read: `frame` holds everything but the questions, which are still to be
    chosen.
    """

    frame: Bank
    slots: tuple[Slot, ...]

    def bank(self, secret: str) -> Bank:
        """The exam that a secret makes; templates that are drawn differ from each other and from
        all that are named.

        A blueprint that was read has enough templates for every slot.
        """
        return self.choose(
            match_slots(
                list_wishes(self.slots, lambda slot, name: address(secret, "template", slot, name))
            )
        )

    def choose(self, names: Mapping[str, str]) -> Bank:
        """The exam in which the questions that are drawn become those of these templates, by
        question.
        """
        named = name_templates(self.slots)
        questions: list[BankQuestion] = []
        choices: list[Choice] = []
        for slot in self.slots:
            if slot.given:
                alternatives = slot.list_alternatives(named)
                questions += alternatives
                choices.append(Choice(tuple(each.identifier for each in alternatives), slot.given))
                continue
            drawn = slot.identifier in names
            questions += (
                each
                for each in slot.candidates
                if not drawn or each.template.name == names[slot.identifier]
            )
        return replace(self.frame, questions=tuple(questions), choices=tuple(choices))


def name_templates(slots: Iterable[Slot]) -> set[str]:
    """The templates that a bank names, which are not drawn besides."""
    return {each.template.name for slot in slots if not slot.drawn for each in slot.candidates}


def list_wishes(
    slots: Iterable[Slot], rank: Callable[[str, str], int]
) -> dict[str, tuple[str, ...]]:
    """For each slot that is drawn once for the class the templates it may take, those of lowest
    rank first.
    """
    slots = tuple(slots)
    given = {each.template.name for slot in slots if slot.given for each in slot.candidates}
    taken = name_templates(slots) | given
    return {
        slot.identifier: _rank_templates(slot, taken, partial(rank, slot.identifier))
        for slot in slots
        if slot.drawn and not slot.given
    }


def _rank_templates(slot: Slot, taken: set[str], rank: Callable[[str], int]) -> tuple[str, ...]:
    """The templates that a slot may take, without those that are `taken`, by rank and name."""
    candidates = {question.template.name for question in slot.candidates} - taken
    return tuple(sorted(candidates, key=lambda name: (rank(name), name)))
