"""Right or wrong: one reading compared with one key.

`judge` is pure; `fast.comparison` gives the same verdicts for thousands of answers wherever double
precision suffices. The rule is the one printed on the paper: an answer is right if it differs from
the key by at most the tolerance, exactly the tolerance included, and agrees with it to the
significant figures that are asked for.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Literal, assert_never

from kinegrade.exam.folder.keys import Key
from kinegrade.grading.typed.answers import Reading
from kinegrade.language.message import Message, Text
from kinegrade.numbers.decimals import round_to_decimal

_MOST_DIGITS = 40
#: Full turns between an answer and the key, at most: more are degrees typed for radians
MOST_TURNS = 3

Kind = Literal[
    #: Within the tolerance.
    "right",
    #: Another answer, which a policy accepts.
    "accepted",
    #: It follows from the student's own wrong answer to an earlier ask.
    "follow-through",
    #: It would follow from the student's own wrong answers, but all numeric answers to its
    #: question, and to another one at least, are right on one other paper of the exam.
    "another paper",
    #: A known mistake leads to it.
    "mistake",
    #: Anything else that could be read.
    "wrong",
    #: The right number in a wrong unit.
    "wrong unit",
    #: Nothing was typed.
    "blank",
    #: It could not be read as a number.
    "unreadable",
    #: A policy made the ask void.
    "void",
]


@dataclass(frozen=True, slots=True)
class Verdict:
    """What an answer is, and why.

    `comparison` says how far a number is from the one it was compared with. `mistakes` are the
    known mistakes that lead to it, the likeliest first; `by_policy` is whether it was compared by
    another rule than the paper's; `accepted` is the number of the policy's answer that it agrees
    with, 0 for none. `rests_on` are the asks whose answers another one follows from.
    """

    kind: Kind
    reason: Text
    comparison: Text = ""
    mistakes: tuple[str, ...] = ()
    by_policy: bool = False
    accepted: int = 0
    rests_on: tuple[str, ...] = ()


def judge(reading: Reading, key: Key) -> Verdict:
    """Decides by exact fractions; an irrational answer that cannot be distinguished from the bound
    counts as on it. Never raises.

    >>> from kinegrade.grading.typed.answers import read
    >>> from kinegrade.numbers.tolerance import ONE_PER_CENT
    >>> judge(read("1.01", "m/s"), Key(Fraction(1), ONE_PER_CENT)).comparison
    Message('marking.allowed', value='1', difference='0.01', allowed='0.01')
    """
    match reading.kind:
        case "blank":
            return Verdict("blank", "")
        case "wrong unit" | "unreadable":
            return Verdict(reading.kind, reading.reason)
        case "number":
            return _compare(reading, key)
        case _:
            assert_never(reading.kind)


def is_right(reading: Reading, key: Key) -> bool:
    """Whether `judge` finds it right, in half the time where the reason does not matter."""
    if reading.kind != "number" or reading.value is None:
        return False
    return _is_within(reading, key, _find_difference(reading.value, key))


def _compare(reading: Reading, key: Key) -> Verdict:
    """Right or wrong; a number without a value is unreadable, and the reason says why."""
    if reading.value is None:
        return Verdict("unreadable", reading.reason)
    difference = _find_difference(reading.value, key)
    right = _is_within(reading, key, difference)
    comparison = _explain_comparison(key, abs(difference))
    reason = Message("marking.key", comparison=comparison)
    return Verdict("right" if right else "wrong", reason, comparison)


def _find_difference(value: Fraction, key: Key) -> Fraction:
    """How far a value is from the key, but for a few full turns where they do not matter."""
    difference = value - key.value
    turns = round(difference / key.period) if key.period else 0
    return difference - turns * (key.period or 0) if abs(turns) <= MOST_TURNS else difference


def _is_within(reading: Reading, key: Key, difference: Fraction) -> bool:
    low, high = key.interval
    return low - reading.error <= key.value + difference <= high + reading.error


def _explain_comparison(key: Key, difference: Fraction) -> Message:
    """With as many digits as it takes to see which of the two is larger."""
    if key.rule.goes_by_figures(key.value):
        low, high = key.interval
        return Message(
            "marking.to-figures",
            value=_write_short(key.value),
            difference=_write_short(difference),
            low=_write_short(low),
            high=_write_short(high),
        )
    room = key.rule.room(key.value)
    shown, allowed = _write_short(difference), _write_short(room)
    if shown == allowed and difference != room:
        shown, allowed = _write_long(difference), _write_long(room)
    value = _write_short(key.value)
    return Message("marking.allowed", value=value, difference=shown, allowed=allowed)


def _write_short(number: Fraction) -> str:
    """Six significant digits."""
    return f"{float(number):.6g}"


def _write_long(number: Fraction) -> str:
    return str(round_to_decimal(number, _MOST_DIGITS))
