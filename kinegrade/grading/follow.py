"""Follow-through: the answers of one student that follow from the student's own wrong answers to
earlier asks.

`follow_through` is pure and is called with the answers to one question as they were decided by the
key, the policy and the known mistakes. What follows is worked out by whoever is given as `follows`
(`kinegrade.exam.follow_through`); here stands what counts: the key is tried first, an error is
charged once, and no credit comes from an earlier answer that is right, missing, zero, beyond any
sense, or such that it makes the rest trivial (`kinegrade.grading.trivial_answers`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Protocol

from kinegrade.exam.folder.keys import Ask, Key
from kinegrade.grading.answers import Reading
from kinegrade.grading.decision import Decision
from kinegrade.grading.judge import Verdict, judge
from kinegrade.grading.policy import Ruling
from kinegrade.grading.trivial_answers import Later, is_trivial

FARTHEST = (
    1000  # times the right answer, or below its thousandth part: no follow-through from there
)
SAME = Fraction(1, 10**9)  # relative: what is closer is the same but for rounding
Own = Mapping[str, Fraction]  # a student's own answers by ask, each in its unit


class Consequence(Protocol):
    """What follows for an ask from a student's own answers to other asks of the question, put in
    all at once.
    """

    def __call__(self, student: str, question: str, own: Own, later: str) -> Fraction | None:
        """The value in the unit of `later`; None where it does not depend on those answers, or
        nothing follows.
        """


def as_asked(question: str, asks: Sequence[str]) -> Sequence[str]:
    """The asks of a question in the order in which they are put."""
    return asks


@dataclass(frozen=True, slots=True)
class Follows:
    """Who knows what follows; `order` sorts the asks of a question so that nothing depends on what
    comes after it.
    """

    consequence: Consequence
    order: Callable[[str, Sequence[str]], Sequence[str]] = as_asked

    def __call__(self, student: str, question: str, own: Own, later: str) -> Fraction | None:
        """The consequence."""
        return self.consequence(student, question, own, later)

    def sorted(self, answers: Sequence[Decided]) -> list[Decided]:
        """The answers to a question in that order."""
        by_name = {answer.ask.ask: answer for answer in answers}
        return (
            [by_name[name] for name in self.order(answers[0].ask.question, tuple(by_name))]
            if answers
            else []
        )


@dataclass(frozen=True, slots=True)
class Decided:
    """An answer of one student as it is decided so far; `key` is the paper's, `ruling` what a
    policy says.
    """

    ask: Ask
    reading: Reading
    key: Key
    ruling: Ruling
    decision: Decision

    @property
    def own_value(self) -> Fraction | None:
        """What may be followed: a number of the right one's size, give or take a thousand times."""
        value, right = self.reading.value, self.key.value
        sensible = value and right and 1 <= FARTHEST * abs(value / right) <= FARTHEST**2
        return value if sensible else None

    @property
    def is_right(self) -> bool:
        """Whether it is right by the key, whatever else is decided about it."""
        return judge(self.reading, self.ruling.key(self.key)).kind == "right"

    @property
    def may_follow(self) -> bool:
        """Whether following from earlier answers could be to the student's good."""
        verdict, share = self.decision
        open_still = self.reading.kind == "number" and verdict.kind not in ("right", "void")
        return open_still and self.ruling.follow_through > share


def follow_through(
    student: str, answers: Sequence[Decided], follows: Follows
) -> dict[str, Decision]:
    """The decisions that follow-through makes better, by ask; `answers` are those to one question.

    An answer that got follow-through is an own one for those after it, so that an error is charged
    once however far it goes.
    """
    found: dict[str, Decision] = {}
    wrong: dict[str, Fraction] = {}
    right: dict[str, Fraction] = {}
    earlier = _Earlier(wrong, right, {answer.ask.ask: answer.key.value for answer in answers})
    for answer in follows.sorted(answers):
        if wrong and answer.may_follow:
            verdict = next(_verdicts(student, answer, earlier, follows), None)
            if verdict:
                found[answer.ask.ask] = verdict, answer.ruling.follow_through
        value = answer.own_value
        if value is not None:
            (right if answer.is_right else wrong)[answer.ask.ask] = value
    return found


@dataclass(frozen=True, slots=True)
class _Earlier:
    """The student's own answers so far, the wrong ones and the right ones, and what would be
    right.
    """

    wrong: Own
    right: Own
    keys: Own


def _verdicts(
    student: str, answer: Decided, earlier: _Earlier, follows: Follows
) -> Iterator[Verdict]:
    """Agreements with what follows from own answers, of which one at least is wrong and none makes
    the rest trivial.
    """

    def what_follows(own: Own) -> Fraction | None:
        return follows(student, answer.ask.question, own, answer.ask.ask)

    def compared(value: Fraction) -> Verdict:
        return judge(answer.reading, answer.ruling.beside(answer.key, value))

    later = Later(what_follows, lambda value: compared(value).kind == "right")
    for own, value in _followed(student, answer.ask, earlier.wrong, earlier.right, follows):
        if later.agrees(value):
            used = _used(student, answer.ask, own, value, follows)
            wrong = used.keys() & earlier.wrong.keys()
            if not any(is_trivial(name, used, earlier.keys[name], later) for name in wrong):
                yield Verdict("follow-through", _reason(answer.ask.question, used, compared(value)))


def _followed(
    student: str, later: Ask, wrong: Own, right: Own, follows: Follows
) -> Iterator[tuple[Own, Fraction]]:
    """What follows from all wrong answers, from single ones, and from the wrong and the right ones
    together: somebody may have gone on from one and not from another, and what would follow for a
    third may be right all the same.
    """
    singles = ({name: wrong[name]} for name in reversed(tuple(wrong)) if len(wrong) > 1)
    for own in (wrong, *singles):
        value = follows(student, later.question, own, later.ask)
        if value is not None:
            yield own, value
    value = follows(student, later.question, {**wrong, **right}, later.ask) if right else None
    if value is not None and not _alike(value, follows(student, later.question, right, later.ask)):
        yield {**wrong, **right}, value


def _used(student: str, later: Ask, own: Own, value: Fraction, follows: Follows) -> Own:
    """Those of the own answers without which something else would follow."""
    used = dict(own)
    for name in own:
        rest = {each: number for each, number in used.items() if each != name}
        if rest and _alike(value, follows(student, later.question, rest, later.ask)):
            used = rest
    return used


def _alike(value: Fraction, other: Fraction | None) -> bool:
    """Whether both are the same but for rounding."""
    return other is not None and abs(other - value) <= SAME * abs(value)


def _reason(question: str, own: Own, verdict: Verdict) -> str:
    """In words: from which answers, what follows, and how far from it the answer is."""
    answers = " and ".join(f"{question}.{name} = {float(value):.6g}" for name, value in own.items())
    return f"follows from the own {answers}: {verdict.reason.removeprefix('key ')}"
