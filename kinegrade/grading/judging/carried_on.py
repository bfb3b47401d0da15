"""What would be right for a student who carried on from own wrong answers: to be told, whether it
was credited or not.

`follow` decides about credit, by the same order of asks and the same own values.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from kinegrade.exam.folder.keys import Key
from kinegrade.grading.judging.follow import Decided, Follows, walk_stages
from kinegrade.grading.judging.judge import judge
from kinegrade.grading.judging.own_answers import EarlierAnswers, find_followed, select_used
from kinegrade.grading.judging.trivial_answers import Own


@dataclass(frozen=True, slots=True)
class CarriedOn:
    """`own` are the student's answers by ask, at least one of them wrong; `key` is what follows
    from them for another ask, by the rule of that ask.
    """

    own: Own
    key: Key


def find_carried_on(
    student: str, answers: Sequence[Decided], follows: Follows
) -> dict[str, CarriedOn]:
    """What follows for each wrong answer to a question, by ask: what the answer agrees with, else
    what follows from all wrong answers before it. Nothing where an answer is absurd.
    """
    found: dict[str, CarriedOn] = {}
    for stage, earlier in walk_stages(answers, follows):
        for answer in stage:
            given = earlier.leave_out(answer.ask.ask)
            if given.wrong and not answer.is_right:
                carried = _carry_on(student, answer, given, follows)
                found |= {} if carried is None else {answer.ask.ask: carried}
    return found


def _carry_on(
    student: str, answer: Decided, earlier: EarlierAnswers, follows: Follows
) -> CarriedOn | None:
    """What follows for one answer; None where it does not depend on the others."""
    question, ask = answer.ask.question, answer.ask.ask

    def what_follows(own: Own) -> Sequence[Fraction]:
        return follows.consequence(student, question, own, ask)

    possible = [
        (own, answer.ruling.beside(answer.key, value))
        for own, value in find_followed(earlier, what_follows)
        if earlier.wrong.keys() & own.keys()
    ]
    if not possible:
        return None
    agreeing = (each for each in possible if judge(answer.reading, each[1]).kind == "right")
    own, key = next(agreeing, possible[0])
    return CarriedOn(select_used(own, key.value, what_follows), key)
