"""What one answer is worth: compared with the key, and with everything else a policy gives credit
for.

`decide` is pure and is called by `block_judge` for every answer that a plain comparison leaves
open; `judge` compares, this module chooses. The best credit counts; among equals the first of: the
key, the accepted answers in their order, the mistakes, the right number in a wrong unit.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import assert_never

from kinegrade.exam.folder.keys import Key
from kinegrade.grading.judging.judge import Verdict, judge
from kinegrade.grading.policy.accepted import Alternative
from kinegrade.grading.policy.policy import NO_ROOM, Ruling
from kinegrade.grading.typed.answers import Reading
from kinegrade.language.message import Message, Text, list_plainly
from kinegrade.stated_marking import find_identifier

Decision = tuple[Verdict, Fraction]  # what the answer is, and its share of the points
MistakeRank = tuple[Fraction, Fraction | float, str]
_FULL, _NONE = Fraction(1), Fraction(0)


def decide(
    reading: Reading,
    key: Key,
    ruling: Ruling,
    others: Sequence[Alternative],
    reread: Callable[[str], Reading],
) -> Decision:
    """The verdict and the share of the points, before any voiding. Never raises.

    `reread` reads a part of the typed text in the same way as the whole was read.
    """
    now = ruling.key(key)
    verdict = judge(reading, now)
    if verdict.kind == "right":
        return _mention_rule(verdict, ruling), _FULL
    match reading.kind:
        case "number":
            mistaken = find_mistaken(reading, now, ruling)
            found = [
                *_find_accepted(reading, now, ruling, others),
                *([] if mistaken is None else [mistaken]),
            ]
        case "wrong unit":
            found = list(_judge_bare_number(reading, now, ruling, reread))
        case "blank" | "unreadable":
            found = []
        case _:
            assert_never(reading.kind)
    return max(
        found, key=lambda decision: decision[1], default=(_mention_rule(verdict, ruling), _NONE)
    )


def void(decision: Decision, ruling: Ruling, *, handed_in: bool) -> Decision:
    """The decision once the ask is void: full points for every student who handed in, or no points
    out of none.
    """
    verdict, _ = decision
    by_key: Text = verdict.kind
    if verdict.reason:
        by_key = Message("marking.because", verdict=verdict.kind, reason=verdict.reason)
    match ruling.void:
        case "drop":
            return Verdict("void", Message("marking.dropped", verdict=by_key)), _NONE
        case "full" | None:
            if handed_in:
                return Verdict("void", Message("marking.full-points", verdict=by_key)), _FULL
            return Verdict("void", Message("marking.nothing-handed-in")), _NONE
        case _:
            assert_never(ruling.void)


def _mention_rule(verdict: Verdict, ruling: Ruling) -> Verdict:
    """Adds a note on the rule where it is not the one printed on the paper."""
    if ruling.room == NO_ROOM or verdict.kind not in ("right", "wrong"):
        return verdict
    reason = Message("marking.by-policy", reason=verdict.reason)
    return replace(verdict, reason=reason, by_policy=True)


def _find_accepted(
    reading: Reading, key: Key, ruling: Ruling, others: Sequence[Alternative]
) -> Iterable[Decision]:
    for other in others:
        margin = replace(reading, error=reading.error + other.error)
        verdict = judge(margin, ruling.beside(key, other.value))
        if verdict.kind == "right":
            reason = Message(
                "marking.accepted",
                number=other.accepted.number,
                text=other.accepted.text,
                comparison=verdict.comparison,
            )
            verdict = Verdict("accepted", reason, accepted=other.accepted.number)
            yield verdict, other.accepted.credit


def find_mistaken(reading: Reading, key: Key, ruling: Ruling) -> Decision | None:
    """The mistake that leads to this answer, by its rank where several do; it names the others."""
    value = reading.value or Fraction(0)
    leading: dict[str, Text] = {}
    for name, wrong in key.mistakes.items():
        if _may_agree(value, wrong, key):
            verdict = judge(reading, ruling.beside(key, wrong))
            if verdict.kind == "right":
                leading[name] = verdict.comparison
    if not leading:
        return None

    def rank(name: str) -> MistakeRank:
        return rank_mistake(name, abs(key.mistakes[name] - value), ruling.mistakes)

    best, *_ = sorted(leading, key=rank)
    mistakes = name_mistakes(best, leading)
    verdict = Verdict("mistake", explain_mistakes(mistakes, leading[best]), mistakes=mistakes)
    return verdict, ruling.mistakes.get(mistakes[0], _NONE)


def rank_mistake(
    label: str, difference: Fraction | float, shares: Mapping[str, Fraction]
) -> MistakeRank:
    """The sort key of mistakes that lead to one answer: first the one with the best credit, of
    equals the nearest, then the first by label.
    """
    share = -shares.get(find_identifier(label), _NONE) if shares else _NONE
    return share, difference, label


def name_mistakes(best: str, labels: Collection[str]) -> tuple[str, ...]:
    """The identifiers of mistakes that lead to one answer, each once: that of the best by rank
    first.
    """
    first = find_identifier(best)
    if len(labels) == 1:
        return (first,)
    return first, *sorted({find_identifier(label) for label in labels} - {first})


def explain_mistakes(mistakes: tuple[str, ...], comparison: Text) -> Message:
    """The reason of an answer that a mistake leads to: the first; so do the others.

    `comparison` says how far the answer is from what the first leads to.
    """
    first, *others = mistakes
    if not others:
        return Message("marking.leads-to", mistake=first, comparison=comparison)
    return Message(
        "marking.leads-to-so",
        mistake=first,
        comparison=comparison,
        count=len(others),
        others=list_plainly(others),
    )


def _may_agree(value: Fraction, wrong: Fraction, key: Key) -> bool:
    """False only where `judge` would certainly find no agreement, at a twentieth of its cost."""
    if key.period:
        return True
    size = abs(float(wrong))
    room = key.rule.widest_share * size + float(key.rule.absolute)
    return abs(float(value) - float(wrong)) <= 1.01 * room + 1e-9 * size


def _judge_bare_number(
    reading: Reading, key: Key, ruling: Ruling, reread: Callable[[str], Reading]
) -> Iterable[Decision]:
    """The number alone, where its unit is wrong and a policy gives credit for it: the longest
    leading part that is a number.
    """
    if reading.kind != "wrong unit" or not ruling.wrong_unit:
        return
    ends = range(len(reading.typed) - 1, 0, -1)
    numbers = (reread(reading.typed[:end]) for end in ends)
    number = next((each for each in numbers if each.kind == "number"), None)
    if number is not None and judge(number, key).kind == "right":
        yield (
            Verdict("wrong unit", Message("marking.bare-number", reason=reading.reason)),
            ruling.wrong_unit,
        )
