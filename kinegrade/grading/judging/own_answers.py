"""A student's own answers to a question as far as it is marked, and what follows from them.

`follow` credits what follows, `carried_on` tells it to people.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kinegrade.grading.judging.trivial_answers import Own, WhatFollows

_SAME = Fraction(1, 10**9)  # relative: closer values differ only by rounding


@dataclass(frozen=True, slots=True)
class EarlierAnswers:
    """The student's answers so far, wrong and right, the right values, and the asks on which an
    answer that earned follow-through rests.
    """

    wrong: dict[str, Fraction]
    right: dict[str, Fraction]
    keys: Own
    basis: dict[str, Collection[str]]

    def leave_out(self, ask: str) -> EarlierAnswers:
        """Without the answer to an ask, and without those that rest on it."""
        wrong = {name: value for name, value in self.wrong.items() if not self._rests(name, ask)}
        right = {name: value for name, value in self.right.items() if name != ask}
        return EarlierAnswers(wrong, right, self.keys, self.basis)

    def _rests(self, name: str, ask: str) -> bool:
        """Whether an answer is that to an ask, or rests on it."""
        return name == ask or any(self._rests(each, ask) for each in self.basis.get(name, ()))


def find_followed(
    earlier: EarlierAnswers, what_follows: WhatFollows
) -> Iterator[tuple[Own, Fraction]]:
    """What follows from all wrong answers, from single ones, and from wrong and right ones
    together. A student may have carried on from one answer and not from another, and what would
    follow for a third may still be right.
    """
    wrong, right = earlier.wrong, earlier.right
    singles = ({name: wrong[name]} for name in reversed(tuple(wrong)) if len(wrong) > 1)
    for answers in (wrong, *singles):
        for value in what_follows(answers):
            yield answers, value
    for value in what_follows({**wrong, **right}) if right else ():
        if not _is_among(value, what_follows(right)):
            yield {**wrong, **right}, value


def select_used(answers: Own, value: Fraction, what_follows: WhatFollows) -> Own:
    """The answers without which a different value would follow."""
    used = dict(answers)
    for name in answers:
        rest = {each: number for each, number in used.items() if each != name}
        if rest and _is_among(value, what_follows(rest)):
            used = rest
    return used


def _is_among(value: Fraction, others: Sequence[Fraction]) -> bool:
    """Whether it is one of the others, but for rounding."""
    return any(abs(other - value) <= _SAME * abs(value) for other in others)
