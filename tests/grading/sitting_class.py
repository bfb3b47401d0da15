"""A class of any size with own papers, whose students work, err, misread and copy as a test
wants.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from random import Random

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.keys import Key
from kinegrade.exam.keyed_exam import Examinee, KeyedExam
from kinegrade.marks_folder.rows import MarkedAnswer
from kinegrade.numbers.tolerance import ONE_PER_CENT

ASKS = {
    "q1": ("v", "omega", "a"),
    "q2": ("v", "a"),
    "q3": ("omega", "alpha", "a"),
    "q4": ("v", "a"),
}
FACTORS = {
    "sense-reversed": -1,
    "power-of-ten-up": 10,
    "power-of-ten-down": Fraction(1, 10),
    "coriolis-dropped": Fraction(3, 5),
    "diameter-for-radius": 2,
}
WRONG = tuple(map(float, FACTORS.values()))
Numbers = Mapping[tuple[str, str], Fraction]  # by question and what is drawn
Typing = Callable[[int], Mapping[str, Fraction]]  # what a student answers wrongly, by column


@dataclass(frozen=True)
class SittingClass:
    """Papers with numbers as templates draw them: `drawn` has those of each student."""

    exam: KeyedExam
    drawn: tuple[Numbers, ...]

    def answers(self, wrong: Typing) -> Iterator[MarkedAnswer]:
        """Marked answers of everybody; what is not answered wrongly is right."""
        for place, examinee in enumerate(self.exam.examinees):
            given = wrong(place)
            for ask in self.exam.asks:
                value = given.get(ask.column, examinee.keys[ask.column].value)
                verdict = "wrong" if ask.column in given else "right"
                text = f"{float(value):.4g}"
                yield MarkedAnswer(
                    examinee.student,
                    ask.question,
                    ask.ask,
                    text,
                    text,
                    ask.unit,
                    verdict,
                    Fraction(0),
                    ask.points,
                    "",
                )

    def key(self, place: int, column: str) -> Fraction:
        """What is right on a paper."""
        return self.exam.examinees[place].keys[column].value

    def copied(self, place: int, *columns: str) -> dict[str, Fraction]:
        """The right answers of a paper, rounded a little otherwise."""
        return {column: self.key(place, column) * Fraction(1003, 1000) for column in columns}


def sitting_class(
    students: int,
    seed: int,
    *,
    name: Callable[[int], str] = "Student {}".format,
    paper: Callable[[int], int] = int,
) -> SittingClass:
    """A class; `paper` says who has the same paper as whom, by a number."""
    asks = tuple(
        Ask(question, ask, "m/s", Fraction(2)) for question, names in ASKS.items() for ask in names
    )
    drawn = tuple(numbers(f"{seed} {paper(place)}") for place in range(students))
    examinees = tuple(
        Examinee(f"s{place}", name(place), keys(asks, drawn[place])) for place in range(students)
    )
    return SittingClass(KeyedExam(asks, examinees), drawn)


def numbers(seed: str) -> dict[tuple[str, str], Fraction]:
    """A length, an angle's ratio and an angular velocity for each question."""
    chance = Random(seed)
    return {
        (question, name): chance.choice(choices)
        for question in ASKS
        for name, choices in (
            ("r", [Fraction(count, 20) for count in range(2, 14)]),
            ("k", [Fraction(count, 7) for count in range(3, 12)]),
            ("omega", [Fraction(count) for count in range(2, 13)]),
        )
    }


def worked(question: str, ask: str, drawn: Numbers) -> Fraction:
    """An answer, from the numbers of its question."""
    r, k, omega = (drawn[question, name] for name in ("r", "k", "omega"))
    return {
        "v": r * omega * k,
        "omega": omega / k,
        "a": r * omega**2 * k,
        "alpha": omega**2 * k / 3,
    }[ask]


def keys(asks: tuple[Ask, ...], drawn: Numbers) -> dict[str, Key]:
    """The keys of a paper, with what some mistakes lead to."""
    values = {ask.column: worked(ask.question, ask.ask, drawn) for ask in asks}
    return {
        column: Key(
            value, ONE_PER_CENT, None, {name: factor * value for name, factor in FACTORS.items()}
        )
        for column, value in values.items()
    }


def honest_slips(sitting: SittingClass, seed: int) -> Typing:
    """Students who err on their own: a number misread in every third question, some answers wrong
    by any factor.
    """

    def wrong(place: int) -> dict[str, Fraction]:
        chance, given = Random(f"{seed} {place}"), {}
        for question, asks in ASKS.items():
            drawn = dict(sitting.drawn[place])
            if chance.random() < 1 / 3:
                name = chance.choice(["r", "k", "omega"])
                drawn[question, name] = numbers(str(chance.random()))[question, name]
            for ask in asks:
                value = worked(question, ask, drawn)
                if chance.random() < 1 / 5:
                    value *= Fraction(chance.uniform(0.2, 3))
                right = float(sitting.key(place, f"{question}.{ask}"))
                if all(
                    abs(float(value) - factor * right) > abs(factor * right) / 50
                    for factor in (1, *WRONG)
                ):
                    given[f"{question}.{ask}"] = value
        return given

    return wrong
