"""The exact keys of a paper from its line of key.jsonl, whatever its shape, or what is wrong with
it.

`key_decoding` reads lines of the usual shape many times faster and leaves all others to this.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import isclose

import msgspec

from kinegrade.errors import FieldError
from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.faults import damaged
from kinegrade.exam.folder.keys import Ask, Key, Rule, rule
from kinegrade.exam.folder.numbers import RATIONAL, not_negative, number
from kinegrade.exam.folder.records import KeyLine, StatedAnswer, StatedTolerance

AGREEMENT = 1e-9  # relative, between the ways in which a right answer is stated
_FIGURES = range(1, 16)
_LINE = msgspec.json.Decoder(KeyLine)


def key_line(text: bytes) -> KeyLine:
    """The record on a line. Raises FieldError, and UnicodeDecodeError where it is not UTF-8."""
    text.decode("utf-8")  # msgspec accepts any bytes in a text that it skips
    try:
        return _LINE.decode(text)
    except (ValueError, ArithmeticError, RecursionError) as fault:
        raise FieldError(damaged(fault)) from fault


def exact_keys(asks: Sequence[Ask], line: KeyLine) -> list[Key]:
    """The keys in the order of the asks. Raises FieldError."""
    found = {
        f"{question.question}.{name}": answer
        for question in line.questions
        for name, answer in question.asks.items()
    }
    if found.keys() != {ask.column for ask in asks}:
        differing = ", ".join(sorted(found.keys() ^ {ask.column for ask in asks}))
        raise FieldError(
            f'student "{line.student}": the asks differ from {HEAD} in {differing} - expected the '
            "same"
        )
    try:
        return [_key(ask, found[ask.column]) for ask in asks]
    except FieldError as fault:
        raise FieldError(f'student "{line.student}": {fault}') from fault


def _key(ask: Ask, answer: StatedAnswer) -> Key:
    try:
        if answer.unit != ask.unit or number("points", answer.points) != ask.points:
            raise FieldError(f"unit or points differ from {HEAD} - expected the same")
        value = exact_value(answer)
        stated = rule_of(answer.tolerance)
        period = None if answer.period is None else not_negative("period", answer.period)
        mistakes = mistakes_of(answer.mistakes)
    except FieldError as fault:
        raise FieldError(f"{ask.column}: {fault}") from fault
    return stated.key(value, period, mistakes)


def rule_of(tolerance: StatedTolerance) -> Rule:
    """The rule that a tolerance states; figures are those to which an answer has to agree. Raises
    FieldError.
    """
    relative = not_negative("relative", tolerance.relative)
    absolute = not_negative("absolute", tolerance.absolute)
    figures = tolerance.figures
    if figures is not None and figures not in _FIGURES:
        raise FieldError(f'"figures" is {figures} - expected a whole number from 1 to 15')
    return rule(relative, absolute, figures)


def mistakes_of(stated: Mapping[str, str]) -> Mapping[str, Fraction]:
    """What known mistakes lead to, by the mistake's id. Raises FieldError."""
    return {name: number(name, text) for name, text in stated.items()}


def exact_value(answer: StatedAnswer) -> Fraction:
    """What is right: the exact value where it is a plain number, else the decimal text, else the
    value's own digits. Raises FieldError.
    """
    plain = answer.exact if answer.exact and RATIONAL.fullmatch(answer.exact) else None
    stated = {"exact": plain, "decimal": answer.decimal, "value": answer.value}
    values = {name: number(name, text) for name, text in stated.items() if text is not None}
    if not values:
        raise FieldError('neither "decimal" nor "value" is there - expected the right answer')
    first, *others = values.values()
    # A check only: floats will do
    if not all(isclose(first, other, rel_tol=AGREEMENT) for other in others):
        raise FieldError(f"{', '.join(values)} state different numbers - expected the same one")
    return first
