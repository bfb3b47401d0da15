"""Follow-through: the answers of one student that follow from the student's wrong answers to
earlier asks.

`follow_answers` is pure. It takes the answers to one question as decided by the key, the policy and
the known mistakes. The argument `follows` works out what follows (`kinegrade.exam.follow_through`);
this module holds the rules. The key is tried first, and an error is charged once. No credit comes
from an earlier answer that is right, missing, zero, absurd, or so chosen that it makes the rest
trivial (`kinegrade.grading.judging.trivial_answers`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kinegrade.exam.folder.keys import Ask, Key
from kinegrade.grading.judging.decision import Decision
from kinegrade.grading.judging.judge import Verdict, judge
from kinegrade.grading.judging.trivial_answers import Later, Own, WhatFollows, is_trivial
from kinegrade.grading.policy.policy import Ruling
from kinegrade.grading.typed.answers import Reading
from kinegrade.language.message import Message, Text, list_all

_FARTHEST = (
    1000  # times the right answer, or below its thousandth part: no follow-through from there
)
_SAME = Fraction(1, 10**9)  # relative: closer values differ only by rounding


# Of a student, in a question, from the answers to some of its asks, for another ask: the value in
# the unit of that ask; None where it does not depend on those answers, or nothing follows
Consequence = Callable[[str, str, Own, str], Fraction | None]


def _order_as_asked(question: str, asks: Sequence[str]) -> Sequence[str]:
    """The asks of a question in the order in which they are put."""
    return asks


@dataclass(frozen=True, slots=True)
class Follows:
    """What follows, and `order`, which sorts the asks of a question so that none depends on a later
    one.
    """

    consequence: Consequence
    order: Callable[[str, Sequence[str]], Sequence[str]] = _order_as_asked

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
    """A student's answer as decided so far; `key` is the paper's, `ruling` the policy's."""

    ask: Ask
    reading: Reading
    key: Key
    ruling: Ruling
    decision: Decision

    @property
    def own_value(self) -> Fraction | None:
        """The number to follow from, if it is within a factor of a thousand of the right answer."""
        value, right = self.reading.value, self.key.value
        sensible = value and right and 1 <= _FARTHEST * abs(value / right) <= _FARTHEST**2
        return value if sensible else None

    @property
    def is_right(self) -> bool:
        """Whether it is right by the key, whatever else is decided about it."""
        return judge(self.reading, self.ruling.key(self.key)).kind == "right"

    @property
    def may_follow(self) -> bool:
        """Whether following from earlier answers could benefit the student."""
        verdict, share = self.decision
        open_still = self.reading.kind == "number" and verdict.kind not in ("right", "void")
        return open_still and self.ruling.follow_through > share


def follow_answers(
    student: str, answers: Sequence[Decided], follows: Follows
) -> dict[str, Decision]:
    """The decisions that follow-through improves, by ask; `answers` are those to one question.

    An answer that earned follow-through counts as a student's answer for later asks, so an error is
    charged once however far it carries.
    """
    found: dict[str, Decision] = {}
    wrong: dict[str, Fraction] = {}
    right: dict[str, Fraction] = {}
    earlier = _Earlier(wrong, right, {answer.ask.ask: answer.key.value for answer in answers})
    for answer in follows.sorted(answers):
        if wrong and answer.may_follow:
            verdict = next(_find_verdicts(student, answer, earlier, follows), None)
            if verdict:
                found[answer.ask.ask] = verdict, answer.ruling.follow_through
        value = answer.own_value
        if value is not None:
            (right if answer.is_right else wrong)[answer.ask.ask] = value
    return found


@dataclass(frozen=True, slots=True)
class _Earlier:
    """The student's answers so far, wrong and right, and the right values."""

    wrong: Own
    right: Own
    keys: Own


def _find_verdicts(
    student: str, answer: Decided, earlier: _Earlier, follows: Follows
) -> Iterator[Verdict]:
    """Agreements with what follows from the student's answers, at least one of them wrong and none
    of them making the rest trivial.
    """
    question, ask = answer.ask.question, answer.ask.ask

    def what_follows(answers: Own) -> Fraction | None:
        return follows.consequence(student, question, answers, ask)

    def compared(value: Fraction) -> Verdict:
        return judge(answer.reading, answer.ruling.beside(answer.key, value))

    later = Later(what_follows, lambda value: compared(value).kind == "right")
    for answers, value in _find_followed(earlier, what_follows):
        if later.agrees(value):
            used = _select_used(answers, value, what_follows)
            wrong = used.keys() & earlier.wrong.keys()
            if not any(is_trivial(name, used, earlier.keys[name], later) for name in wrong):
                comparison = compared(value).comparison
                yield Verdict("follow-through", _explain(question, used, comparison))


def _find_followed(earlier: _Earlier, what_follows: WhatFollows) -> Iterator[tuple[Own, Fraction]]:
    """What follows from all wrong answers, from single ones, and from wrong and right ones
    together. A student may have carried on from one answer and not from another, and what would
    follow for a third may still be right.
    """
    wrong, right = earlier.wrong, earlier.right
    singles = ({name: wrong[name]} for name in reversed(tuple(wrong)) if len(wrong) > 1)
    for answers in (wrong, *singles):
        value = what_follows(answers)
        if value is not None:
            yield answers, value
    value = what_follows({**wrong, **right}) if right else None
    if value is not None and not _are_alike(value, what_follows(right)):
        yield {**wrong, **right}, value


def _select_used(answers: Own, value: Fraction, what_follows: WhatFollows) -> Own:
    """The answers without which a different value would follow."""
    used = dict(answers)
    for name in answers:
        rest = {each: number for each, number in used.items() if each != name}
        if rest and _are_alike(value, what_follows(rest)):
            used = rest
    return used


def _are_alike(value: Fraction, other: Fraction | None) -> bool:
    """Whether the two differ only by rounding."""
    return other is not None and abs(other - value) <= _SAME * abs(value)


def _explain(question: str, used: Own, comparison: Text) -> Message:
    """The answers used, what follows from them, and how far the answer is from that."""
    answers = list_all(f"{question}.{name} = {float(value):.6g}" for name, value in used.items())
    return Message("marking.follows", answers=answers, comparison=comparison)
