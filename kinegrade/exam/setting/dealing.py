"""Dealing an exam to a class: who has which place, and what each place gets.

`deal_exam` looks for as many good combinations of every question as there are places, or more, and
deals them alike; after that `ClassDeal` says what anyone was dealt, and nothing is searched.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import partial
from itertools import count
from pathlib import Path
from types import MappingProxyType
from typing import assert_never

from kinegrade.draws.deal import Deal, DeckPart, Look, Verdicts, Whose, look_here
from kinegrade.draws.deck import Combination
from kinegrade.draws.examining import Reason
from kinegrade.draws.keyed_order import address
from kinegrade.exam.bank.blueprint import Bank, BankQuestion
from kinegrade.exam.bank.versions import choose_version, list_version_letters
from kinegrade.exam.folder.exam_secret import ExamSecret
from kinegrade.exam.folder.key.lines import KeyLine
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.alike_deal import deal_alike
from kinegrade.exam.setting.paper_codes import make_paper_codes
from kinegrade.exam.setting.places import assign_places
from kinegrade.exam.setting.setting import DealtPaper, Exam, SetPaper, set_paper
from kinegrade.language.message import Fault, Message, list_plainly
from kinegrade.processes.executor import Shared, map_in_order

_AHEAD = 32  # parts of decks that are under way or wait
_NOTHING: Mapping[str, KeyLine] = MappingProxyType({})


@dataclass(frozen=True)
class ClassDeal:
    """A bank dealt to a class: `places`, `codes` and `versions` by student, `deals` by question.

    `values` has for each question what everyone gets who is given it, by student, or by letter
    where there are versions: which questions a paper holds is said here. `orders` are those of the
    questions on papers that stay. What all papers are made from is `shared` by the processes that
    make them.
    """

    shared: Shared[Exam]
    roster: Roster
    secret: ExamSecret
    places: Mapping[str, int]
    codes: Mapping[str, str]
    versions: Mapping[str, str]
    orders: Mapping[str, Sequence[str]]
    deals: Mapping[str, Deal]
    values: Mapping[str, Mapping[str, Combination]]

    @property
    def exam(self) -> Exam:
        """What all papers are made from."""
        return self.shared.value

    @property
    def bank(self) -> Bank:
        """The questions, and what holds for all papers."""
        return self.exam.bank

    def papers(self) -> Iterator[SetPaper]:
        """The papers in the order of the roster."""
        return (set_paper(self.exam, self.dealt(student)) for student in self.roster.students)

    def dealt(self, student: Student) -> DealtPaper:
        """What a student of the roster was dealt."""
        place, code = self.places[student.student], self.codes[student.student]
        letter = self.versions.get(student.student, "")
        values = {
            name: each[letter or student.student]
            for name, each in self.values.items()
            if (letter or student.student) in each
        }
        return DealtPaper(
            student,
            place,
            f"{letter}-{code}" if letter else code,
            letter,
            self._find_order(student.student, letter, [*values]),
            values,
        )

    def combinations(self) -> dict[str, int]:
        """For each question how many combinations of values there are, good or not."""
        return {name: each.size for name, each in self.deals.items()}

    def refusals(self) -> dict[str, dict[Reason, int]]:
        """For each question how many combinations were refused, by reason."""
        return {name: each.refused for name, each in self.deals.items()}

    def shortages(self) -> tuple[Fault, ...]:
        """The lines of `find_shortages`."""
        return tuple(self.find_shortages().values())

    def find_shortages(self) -> Mapping[str, Fault]:
        """A line for each question of which several students, or versions, have the same numbers
        because there are too few, where the bank does not allow it.
        """
        return {
            each.identifier: self._explain_shortage(each)
            for each in self.bank.questions
            if each.dealing == "own" and not self.deals[each.identifier].lasting
        }

    def advise(self, question: str) -> Message:
        """What to do for more good numbers of a question."""
        return self.deals[question].advise(self.exam.filters[question])

    def _explain_shortage(self, question: BankQuestion) -> Fault:
        name = question.identifier
        where = f"{name} ({question.template.name})"
        fault = self.deals[name].shortage(where, self._whose, self.exam.filters[name])
        return replace(fault, do=Message("exam.or-repeat", advice=fault.do))

    def sharing(self) -> Iterator[Message]:
        """What is said of the questions whose numbers are meant not to be everybody's own."""
        for question in self.bank.questions:
            match question.dealing:
                case "own":
                    pass
                case "same":
                    yield Message("exam.same-numbers", question=question.identifier)
                case "repeated":
                    yield self._count_repeated(question.identifier)
                case _:
                    assert_never(question.dealing)

    def giving(self) -> Iterator[Message]:
        """For each choice how many papers hold which alternative."""
        templates = {each.identifier: each.template.name for each in self.bank.questions}
        whose = [self.versions.get(student, student) for student in self.places]
        for choice in self.bank.choices:
            held = {name: sum(each in self.values[name] for each in whose) for name in templates}
            listed = list_plainly(
                f"{name} ({templates[name]}): {held[name]}" for name in choice.questions
            )
            yield Message("exam.alternatives", count=choice.given, questions=listed)

    def _count_repeated(self, question: str) -> Message:
        """How many have numbers that somebody else has, too."""
        dealt = self.values[question]
        times = Counter(tuple(values.values()) for values in dealt.values())
        return Message(
            "exam.repeated-numbers",
            question=question,
            good=len(times),
            places=Message(f"template.for-{self._whose}", count=len(dealt)),
            count=sum(count for count in times.values() if count > 1),
        )

    @property
    def _whose(self) -> Whose:
        """What has numbers of its own."""
        return "versions" if self.bank.versions else "students"

    def _find_order(self, student: str, letter: str, names: Sequence[str]) -> tuple[int, ...]:
        """The order in which the questions of a student, of these names, are printed."""
        kept = self.orders.get(student)
        if kept is not None and self.bank.shuffle and sorted(kept) == sorted(names):
            return tuple(map(names.index, kept))
        return self._order(f"version {letter}" if letter else student, names)

    def _order(self, whose: str, names: Sequence[str]) -> tuple[int, ...]:
        """The order in which these questions of a student, or of a version, are printed."""
        if not self.bank.shuffle:
            return tuple(range(len(names)))
        ranks = [address(self.exam.secret, "order", whose, name) for name in names]
        return tuple(sorted(range(len(names)), key=ranks.__getitem__))


def deal_exam(
    bank: Bank,
    roster: Roster,
    secret: ExamSecret,
    workers: Executor | None = None,
    kept: Mapping[str, KeyLine] = _NOTHING,
    *,
    sketchbook: Path | None = None,
) -> ClassDeal:
    """A bank dealt to a class; `kept` are the papers of an exam that this one replaces, by student:
    they stay as they are. The figures drawn on the way are kept in the folder `sketchbook`.

    Raises DrawError for questions of which no combination is good.
    """
    shared = Shared(Exam(bank, secret.drawing, sketchbook))
    exam = shared.value
    places = _assign_places(roster, exam.secret, kept)
    letters = list_version_letters(bank.versions)
    versions = {
        whose: choose_version(exam.secret, places[whose], letters) for whose in places if letters
    }
    versions |= {whose: paper.version for whose, paper in kept.items() if paper.version in letters}
    units = {letter: place for place, letter in enumerate(letters)} or places
    stated = {
        versions.get(whose, whose): {each.question: each.values for each in paper.questions}
        for whose, paper in kept.items()
    }
    look = _look_by(workers, shared) if workers else partial(look_here, exam.filters)
    dealt = deal_alike(exam, units, stated, look)
    codes = make_paper_codes(secret.coding, places, _list_codes(kept))
    orders = {whose: paper.order for whose, paper in kept.items() if not letters}
    deals = {name: pool.deal for name, pool in dealt.pools.items()}
    return ClassDeal(shared, roster, secret, places, codes, versions, orders, deals, dealt.values)


def _list_codes(kept: Mapping[str, KeyLine]) -> dict[str, str]:
    """The codes of papers that stay, without the letters of versions."""
    return {
        whose: paper.paper.removeprefix(f"{paper.version}-")
        for whose, paper in kept.items()
        if paper.paper
    }


def _assign_places(roster: Roster, secret: str, kept: Mapping[str, KeyLine]) -> dict[str, int]:
    """The place of each student.

    Papers of earlier versions of kinegrade, which state none, have the free places in the order of
    the key: that of the roster.
    """
    stated = {whose: paper.place for whose, paper in kept.items() if paper.place is not None}
    taken = set(stated.values())
    free = (place for place in count() if place not in taken)
    earlier = {whose: next(free) for whose in kept if whose not in stated}
    return assign_places((each.student for each in roster.students), secret, {**stated, **earlier})


def _look_by(workers: Executor, shared: Shared[Exam]) -> Look:
    """Looking at parts of decks by other processes."""
    return lambda parts: map_in_order(workers, _look, [(shared, part) for part in parts], _AHEAD)


def _look(task: tuple[Shared[Exam], DeckPart]) -> Verdicts:
    """What is said of a part of a deck."""
    shared, part = task
    return shared.value.filters[part.question].verdicts(part.positions)
