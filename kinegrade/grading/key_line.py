"""One line of key.jsonl, of whatever shape a key may have: the exact keys of a paper, or what is
wrong with it.

`key_decoding` reads lines of the usual shape many times faster and leaves all others to this.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from math import isclose
from typing import Any

from kinegrade.grading.json_fields import RATIONAL, FieldError, amount, field, not_negative, parsed
from kinegrade.grading.key import Ask, Key, Rule, rule

AGREEMENT = 1e-9  # relative, between the ways in which a right answer is stated
_FIGURES = range(1, 16)


def exact_paper(asks: Sequence[Ask], line: str) -> tuple[str, list[Key]]:
    """(student, the keys in the order of the asks). Raises FieldError."""
    paper = parsed(line)
    student = field(paper, "student", str)
    found = {
        f"{field(question, 'question', str)}.{name}": entry
        for question in field(paper, "questions", list)
        for name, entry in field(question, "asks", dict).items()
    }
    if found.keys() != {ask.column for ask in asks}:
        odd = ", ".join(sorted(found.keys() ^ {ask.column for ask in asks}))
        raise FieldError(
            f'student "{student}": the asks differ from exam.json in {odd} - expected the same'
        )
    try:
        return student, [_key(ask, found[ask.column]) for ask in asks]
    except FieldError as fault:
        raise FieldError(f'student "{student}": {fault}') from fault


def _key(ask: Ask, entry: Any) -> Key:
    try:
        if field(entry, "unit", str) != ask.unit or amount(entry, "points") != ask.points:
            raise FieldError("unit or points differ from exam.json - expected the same")
        value = _value(entry)
        stated = rule_of(field(entry, "tolerance", dict))
        period = not_negative(entry, "period") if "period" in entry else None
        mistakes = mistakes_of(entry)
    except FieldError as fault:
        raise FieldError(f"{ask.column}: {fault}") from fault
    return stated.key(value, period, mistakes)


def rule_of(tolerance: Any) -> Rule:
    """The rule that a tolerance states; figures are those to which an answer has to agree. Raises
    FieldError.
    """
    relative, absolute = not_negative(tolerance, "relative"), not_negative(tolerance, "absolute")
    figures = tolerance.get("figures")
    if "figures" in tolerance and (not isinstance(figures, Decimal) or figures not in _FIGURES):
        raise FieldError(f'"figures" is {figures!r} - expected a whole number from 1 to 15')
    return rule(relative, absolute, None if figures is None else int(figures))


def mistakes_of(entry: Any) -> Mapping[str, Fraction]:
    """What known mistakes lead to, by the mistake's id; earlier versions do not state it. Raises
    FieldError.
    """
    if "mistakes" not in entry:
        return {}
    mistakes = field(entry, "mistakes", dict)
    return {name: amount(mistakes, name) for name in mistakes}


def _value(entry: Any) -> Fraction:
    """The exact value where it is a plain number, else the decimal text, else the value's own
    digits.
    """
    exact = entry.get("exact")
    texts = {"exact": exact if isinstance(exact, str) and RATIONAL.fullmatch(exact) else None}
    texts |= {name: entry.get(name) for name in ("decimal", "value")}
    values = {name: amount(texts, name) for name, text in texts.items() if text is not None}
    if not values:
        raise FieldError('neither "decimal" nor "value" is there - expected the right answer')
    first, *others = values.values()
    # A check only: floats will do
    if not all(isclose(first, other, rel_tol=AGREEMENT) for other in others):
        raise FieldError(f"{', '.join(values)} say different numbers - expected one and the same")
    return first
