"""The exact keys of a paper from its line of key.jsonl, whatever its shape, or what is wrong with
it.

`key_decoding` reads lines of the usual shape many times faster and leaves all others to this.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import isclose, nan

import msgspec

from kinegrade.errors import FieldError
from kinegrade.exam.choices import Choice, fits_paper
from kinegrade.exam.folder.asks import Ask, list_questions
from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.faults import describe_damage
from kinegrade.exam.folder.key.lines import KeyLine, StatedAnswer, StatedTolerance
from kinegrade.exam.folder.keys import NOT_ASKED, Key, StatedKey
from kinegrade.exam.folder.numbers import (
    RATIONAL,
    require_double,
    require_not_negative,
    require_number,
)
from kinegrade.language.message import Fault, Message, Quoted, list_plainly
from kinegrade.numbers.tolerance import Tolerance

_AGREEMENT = 1e-9  # relative, between the ways in which a right answer is stated
_FIGURES = range(1, 16)
_THE_SAME = Message("exam.the-same")
_LINE = msgspec.json.Decoder(KeyLine)


@dataclass(frozen=True, slots=True)
class ListedKeys:
    """Keys one by one: exact ones, or those of several papers from which one was put together."""

    keys: Sequence[Key | StatedKey]

    def __getitem__(self, ask: int, /) -> Key | StatedKey:
        """The key of an ask."""
        return self.keys[ask]

    def __len__(self) -> int:
        """How many there are."""
        return len(self.keys)

    def __iter__(self) -> Iterator[Key | StatedKey]:
        """All of them."""
        return iter(self.keys)

    def state(self, ask: int, /) -> str:
        """The right answer to an ask, as a fraction or a decimal."""
        return str(self.keys[ask].value)

    def list_centres(self) -> Sequence[float]:
        """The right answers; NaN where a number of turns is right too, or nothing was asked."""
        values = zip(self.keys, self.list_values(), strict=True)
        return [nan if key.period else value for key, value in values]

    def list_values(self) -> Sequence[float]:
        """The right answers; NaN where nothing was asked."""
        return [nan if key is NOT_ASKED else float(Fraction(key.value)) for key in self.keys]

    def list_periods(self) -> Sequence[Fraction | None]:
        """The full turn of each ask, where any number of turns is right too."""
        return [key.period for key in self.keys]

    def list_rules(self) -> tuple[Tolerance, ...]:
        """The rule of each ask."""
        return tuple(key.rule for key in self.keys)

    def find_lacking(self) -> frozenset[int]:
        """The numbers of the asks that were not asked."""
        return frozenset(number for number, key in enumerate(self.keys) if key is NOT_ASKED)


def read_key_line(text: bytes) -> KeyLine:
    """The record on a line. Raises FieldError, and UnicodeDecodeError where it is not UTF-8."""
    text.decode("utf-8")  # msgspec accepts any bytes in a text that it skips
    try:
        return _LINE.decode(text)
    except (ValueError, ArithmeticError, RecursionError) as fault:
        raise FieldError(describe_damage(fault)) from fault


def read_exact_keys(
    asks: Sequence[Ask], line: KeyLine, choices: Collection[Choice] = ()
) -> list[Key]:
    """The keys in the order of the asks, NOT_ASKED for those of alternatives that the paper does
    not hold. Raises FieldError.
    """
    found = {
        f"{question.question}.{name}": answer
        for question in line.questions
        for name, answer in question.asks.items()
    }
    held = [question.question for question in line.questions]
    fits = fits_paper(held, list_questions(asks), choices)
    wanted = {ask.column for ask in asks if not choices or ask.question in held}
    if found.keys() != wanted or (choices and not fits):
        differing = list_plainly(sorted(found.keys() ^ wanted or found.keys()))
        what = Message("exam.asks-differ", head=HEAD, asks=differing)
        raise FieldError(Fault(_name_student(line), what, _THE_SAME))
    try:
        return [
            _read_key(ask, found[ask.column]) if ask.column in wanted else NOT_ASKED for ask in asks
        ]
    except FieldError as fault:
        raise FieldError(Fault(_name_student(line), fault.faults[0])) from fault


def _name_student(line: KeyLine) -> Message:
    return Message("exam.student", student=Quoted(line.student))


def _read_key(ask: Ask, answer: StatedAnswer) -> Key:
    try:
        if answer.unit != ask.unit or require_number("points", answer.points) != ask.points:
            raise FieldError(Message("exam.unit-or-points-differ", head=HEAD), _THE_SAME)
        value = find_exact_value(answer)
        stated = read_rule(answer.tolerance)
        period = None if answer.period is None else require_not_negative("period", answer.period)
        mistakes = read_mistakes(answer.mistakes)
    except FieldError as fault:
        raise FieldError(Fault(ask.column, fault.faults[0])) from fault
    return Key(value, stated, period, mistakes)


@lru_cache(maxsize=1024)  # rules repeat on every paper
def read_rule(tolerance: StatedTolerance) -> Tolerance:
    """The rule that a tolerance states; figures are those to which an answer has to agree. Raises
    FieldError.
    """
    relative = require_not_negative("relative", tolerance.relative)
    absolute = require_not_negative("absolute", tolerance.absolute)
    figures = tolerance.figures
    if figures is not None and figures not in _FIGURES:
        what = Message("exam.is", name=Quoted("figures"), found=figures)
        raise FieldError(what, Message("exam.figures-from-to"))
    return Tolerance(relative, absolute, figures)


def read_mistakes(stated: Mapping[str, str]) -> Mapping[str, Fraction]:
    """What known mistakes lead to, by the mistake's id. Raises FieldError."""
    return {name: require_number(name, text) for name, text in stated.items()}


def find_exact_value(answer: StatedAnswer) -> Fraction:
    """What is right: the exact value where it is a plain number, else the decimal text, else the
    value's own digits. Raises FieldError.
    """
    plain = answer.exact if answer.exact and RATIONAL.fullmatch(answer.exact) else None
    named = {"exact": plain, "decimal": answer.decimal, "value": answer.value}
    stated = {name: text for name, text in named.items() if text is not None}
    if not stated:
        raise FieldError(Message("exam.no-right-answer"), Message("exam.the-right-answer"))
    (name, text), *others = stated.items()
    value = require_number(name, text)
    # A check only: floats will do
    doubles = [require_double(name, text) for name, text in others]
    if not all(isclose(value, other, rel_tol=_AGREEMENT) for other in doubles):
        what = Message("exam.different-numbers", names=list_plainly(stated))
        raise FieldError(what, Message("exam.the-same-one"))
    return value
