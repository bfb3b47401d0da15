"""Follow-through: the answers of one student that follow from the student's wrong answers to other
asks.

`follow_answers` is pure. It takes the answers to one question as decided by the key, the policy and
the known mistakes. The argument `follows` works out what follows (`kinegrade.exam.follow_through`);
this module holds the rules. The key is tried first, and an error is charged once: of answers that
follow from each other, the one with the fewest points, of equals the first. No credit comes from an
answer that is right, missing, zero, absurd, copied, or so chosen that it makes the rest trivial
(`kinegrade.grading.judging.trivial_answers`).
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence, Set
from dataclasses import dataclass, replace
from fractions import Fraction

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.keys import Key
from kinegrade.grading.judging.decision import Decision
from kinegrade.grading.judging.judge import Verdict, is_right, judge
from kinegrade.grading.judging.own_answers import EarlierAnswers, find_followed, select_used
from kinegrade.grading.judging.trivial_answers import Later, Own, is_trivial
from kinegrade.grading.policy.policy import FULL_CREDIT, Ruling
from kinegrade.grading.typed.answers import Reading
from kinegrade.language.message import Message, Text, list_all

# Of the right answer: outside of these a value is no honest slip, and nothing follows from it.
# A misplaced decimal point, revolutions per minute (9.5) and degrees for radians (57.3) are inside.
_LEAST, _MOST = Fraction(1, 20), 60
_SIGN_ALONE = Fraction(1, 100)  # of the right answer: a wrong one no farther off but for its sign


# Of a student, in a question, from the answers to some of its asks, for another ask: the values in
# the unit of that ask, one for each way of going on; none where it does not depend on those answers
Consequence = Callable[[str, str, Own, str], Sequence[Fraction]]


def _stage_as_asked(question: str, asks: Sequence[str]) -> Sequence[Sequence[str]]:
    """The asks of a question, each a stage of its own, in the order in which they are put."""
    return [[ask] for ask in asks]


def _is_possible_everywhere(_question: str) -> bool:
    return True


@dataclass(frozen=True, slots=True)
class Follows:
    """What follows, and `stages`, which sorts the asks of a question so that none depends on a
    later stage; those of one stage may follow from each other. Of a question of which it is not
    `possible` nothing is asked.
    """

    consequence: Consequence
    stages: Callable[[str, Sequence[str]], Sequence[Sequence[str]]] = _stage_as_asked
    possible: Callable[[str], bool] = _is_possible_everywhere

    def sorted(self, answers: Sequence[Decided]) -> list[list[Decided]]:
        """The answers to a question in those stages."""
        by_name = {answer.ask.ask: answer for answer in answers}
        stages = self.stages(answers[0].ask.question, tuple(by_name)) if answers else ()
        return [[by_name[name] for name in stage] for stage in stages]


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
        """The number to follow from, if it is within a sensible factor of the right answer."""
        value, right = self.reading.value, self.key.value
        return value if value and right and _LEAST <= abs(value / right) <= _MOST else None

    @property
    def is_absurd(self) -> bool:
        """Whether it is a number from which nothing sensible follows."""
        return bool(self.reading.value and self.key.value) and self.own_value is None

    @property
    def is_right(self) -> bool:
        """Whether it is right by the key, whatever else is decided about it."""
        return is_right(self.reading, self.ruling.key(self.key))

    @property
    def is_uncharged(self) -> bool:
        """Whether nothing is charged for it, even if it is wrong by the key: by the policy it has
        full credit, or is void.
        """
        return self.ruling.void is not None or self.decision[1] == FULL_CREDIT

    @property
    def leads(self) -> bool:
        """Whether later answers may follow from it; one that the policy accepts, unless it says
        that it does not.
        """
        number = self.decision[0].accepted
        return all(each.leads for each in self.ruling.accepted if each.number == number)

    def may_follow(self, credit: Fraction) -> bool:
        """Whether following from earlier answers, with this credit, could benefit the student."""
        verdict, share = self.decision
        open_still = self.reading.kind == "number" and verdict.kind not in ("right", "void")
        return open_still and credit > share


def follow_answers(
    student: str, answers: Sequence[Decided], follows: Follows
) -> dict[str, Decision]:
    """The decisions that follow-through improves, by ask; `answers` are those to one question.

    An answer that earned follow-through counts as a student's answer for later asks, so an error is
    charged once however far it carries, and never where the answers it rests on are not charged.
    """
    found: dict[str, Decision] = {}
    uncharged = {answer.ask.ask for answer in answers if answer.is_uncharged}
    for stage, earlier in walk_stages(answers, follows):
        for answer in _sort_by_points(stage):
            given = earlier.leave_out(answer.ask.ask)
            free = uncharged & given.wrong.keys()
            best = FULL_CREDIT if free else answer.ruling.follow_through
            if given.wrong and answer.may_follow(best):
                credits = _find_credits(student, answer, given, follows)
                credited = _choose_credit(answer, credits, free)
                if credited:
                    verdict, share, earlier.basis[answer.ask.ask] = credited
                    found[answer.ask.ask] = verdict, share
                    if uncharged >= set(earlier.basis[answer.ask.ask]):
                        uncharged.add(answer.ask.ask)
    return found


def _choose_credit(
    answer: Decided, credits: Iterator[tuple[Verdict, Collection[str]]], free: Set[str]
) -> tuple[Verdict, Fraction, Collection[str]] | None:
    """The first that rests on `free` answers alone, for which nothing is charged, with full
    credit; else the first of all, with that for follow-through.
    """
    found = None
    for verdict, wrong in credits:
        if free >= set(wrong):
            return verdict, FULL_CREDIT, wrong
        found = found or (verdict, answer.ruling.follow_through, wrong)
        if not free:
            break
    return found if found and answer.may_follow(found[1]) else None


def walk_stages(
    answers: Sequence[Decided], follows: Follows
) -> Iterator[tuple[Sequence[Decided], EarlierAnswers]]:
    """The answers to one question stage by stage, each with all own answers as far as that.

    Where one answer is absurd, nothing follows from any: the others may have been found from it.
    """
    if any(answer.is_absurd for answer in answers):
        return
    earlier = EarlierAnswers({}, {}, {answer.ask.ask: answer.key.value for answer in answers}, {})
    for stage in follows.sorted(answers):
        for answer in stage:
            value = answer.own_value
            if value is not None and answer.leads:
                (earlier.right if answer.is_right else earlier.wrong)[answer.ask.ask] = value
        yield stage, earlier


def withhold(decision: Decision) -> Decision:
    """The decision without follow-through, where the answers are those to another paper."""
    verdict, share = decision
    reason = Message("marking.another-paper", reason=verdict.reason)
    return replace(verdict, kind="another paper", reason=reason), share


def _sort_by_points(answers: Sequence[Decided]) -> list[Decided]:
    """Those with the most points first, of equals the last: what is left is charged."""
    ordered = list(reversed(answers))
    ordered.sort(key=lambda answer: -answer.ask.points)
    return ordered


def _find_credits(
    student: str, answer: Decided, earlier: EarlierAnswers, follows: Follows
) -> Iterator[tuple[Verdict, Collection[str]]]:
    """Agreements with what follows from the student's answers, at least one of them wrong and none
    of them copied or making the rest trivial; each with the wrong answers that it rests on.
    """
    question, ask = answer.ask.question, answer.ask.ask

    def what_follows(answers: Own) -> Sequence[Fraction]:
        return follows.consequence(student, question, answers, ask)

    def beside(value: Fraction) -> Key:
        return answer.ruling.beside(answer.key, value)

    later = Later(what_follows, lambda value: is_right(answer.reading, beside(value)))
    for answers, value in find_followed(earlier, what_follows):
        if later.agrees(value):
            used = select_used(answers, value, what_follows)
            wrong = used.keys() & earlier.wrong.keys()
            copied = any(_is_copied(answer, used[name], earlier.keys[name]) for name in wrong)
            if not copied and not any(
                is_trivial(name, used, earlier.keys[name], later) for name in wrong
            ):
                comparison = judge(answer.reading, beside(value)).comparison
                reason, rests_on = _explain(question, used, comparison), tuple(sorted(wrong))
                yield Verdict("follow-through", reason, rests_on=rests_on), wrong


def _is_copied(answer: Decided, own: Fraction, right: Fraction) -> bool:
    """Whether the number is that of another answer, although the right numbers differ. One that is
    wrong by its sign alone was worked out.
    """
    same = answer.reading.value is not None and abs(answer.reading.value) == abs(own)
    return (
        same
        and abs(abs(own) - abs(right)) > _SIGN_ALONE * abs(right)
        and not is_right(
            replace(answer.reading, value=abs(right)),
            replace(answer.key, value=abs(answer.key.value)),
        )
    )


def _explain(question: str, used: Own, comparison: Text) -> Message:
    """The answers used, what follows from them, and how far the answer is from that."""
    answers = list_all(f"{question}.{name} = {float(value):.6g}" for name, value in used.items())
    return Message("marking.follows", answers=answers, comparison=comparison)
