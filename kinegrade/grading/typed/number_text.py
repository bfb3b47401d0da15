"""Decimal numbers as they are typed: grouping in threes, decimal point or comma, powers of ten.

`scan` takes one number off the front of a text that `keyboard` has folded. Digits are kept exactly.
A `DecimalStyle` decides what a single mark before three digits means.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from kinegrade.grading.typed.keyboard import show
from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message, Quoted, Text

MOST_DIGITS = 40
LARGEST_EXPONENT = 99

MarkUse = Literal["decimal", "groups", "unknown"]
# How a number may hold its power of ten: 2e3 and 2·10^3, 2e3 alone, or not at all
Power = Literal["any", "letter", "none"]

_BODY = (
    r"(?:(?P<body>[0-9]+(?:[.,'\u2009][0-9]+|\ [0-9]{3}(?![0-9]))*)(?P<last>[.,](?![0-9√π(½-¾]))?"
    r"|(?P<decimals>[.,][0-9]+))"
)
_LETTER = r"[eE](?P<power>[+-]?[0-9]+)"
_NEVER = "(?P<ten>(?!))?"
_DIGITS = re.compile(_BODY + "(?P<power>(?!))?" + _NEVER)
_WITH_LETTER = re.compile(f"{_BODY}(?:{_LETTER})?{_NEVER}")
_RUN = re.compile(
    _BODY + rf"(?:{_LETTER}"
    r"|\s?(?:\*|[xX](?=\s?10\s?(?:\^|\*\*)))\s?10\s?(?:\^|\*\*)\s?(?P<bracket>\()?"
    r"(?P<ten>[+-]?[0-9]+)"
    r"(?![0-9]|[.,][0-9])(?(bracket)\)))?"
)
_RUNS: Mapping[Power, re.Pattern[str]] = {"any": _RUN, "letter": _WITH_LETTER, "none": _DIGITS}
_IN_BRACKETS = re.compile(r"\(\s*[0-9]+\s*\)")
_FIRST_GROUP = re.compile(r"[1-9][0-9]{0,2}")


class TypingFault(Exception):
    """What was typed cannot be marked as a number; `reason` says why and what to write instead."""

    def __init__(self, reason: Text) -> None:
        self.reason = reason
        super().__init__(reason)

    def __str__(self) -> str:
        return open_catalogue(ENGLISH).write(self.reason)


class Unreadable(TypingFault):
    """What was typed is not one number in an acceptable unit."""


_BY_RULE = Message("typing.comma-by-rule")


@dataclass(frozen=True, slots=True)
class DecimalStyle:
    """What a single comma or point before exactly three digits means, and why: `1,234` is 1.234 or
    1234.

    The reasons end the sentence "read as 1.234: ...". The default is the rule printed on papers.
    """

    comma: MarkUse = "decimal"
    point: MarkUse = "decimal"
    comma_reason: Text = _BY_RULE
    point_reason: Text = ""


@dataclass(frozen=True, slots=True)
class TypedNumber:
    """A number without its sign, exactly as typed: `digits` in plain form with a point, and where
    it ends.

    `reason` says why it was read this way where there are several ways, "" where there is only one.
    A message that uses it first says how the whole answer was read, with its sign.
    """

    value: Fraction
    digits: str
    end: int
    reason: Text = ""


@dataclass(frozen=True, slots=True)
class Mantissa:
    """The pieces of a run of digits and the separators between them; `exponent` is whether a power
    of ten follows.
    """

    pieces: tuple[str, ...]
    separators: tuple[str, ...]
    exponent: bool

    @property
    def marks(self) -> tuple[str | None, str | None]:
        """(the mark that is certainly decimal, the mark that certainly groups); None where there is
        none.
        """
        *earlier, last = self.separators or ("",)
        if not last:
            return None, None
        if set(earlier) == {last}:
            return None, last
        if not earlier and (last not in ".," or self.ambiguous):
            return None, last if last not in ".," else None
        return last, earlier[0] if earlier else None

    @property
    def ambiguous(self) -> bool:
        """Whether a single mark stands before exactly three digits, as in 1,234."""
        return (
            len(self.separators) == 1
            and self.separators[0] in ".,"
            and not self.exponent
            and self._grouped(2)
        )

    def _grouped(self, count: int) -> bool:
        """Whether the first `count` pieces are proper groups: one to three digits, then always
        three.
        """
        first, *others = self.pieces[:count]
        return bool(_FIRST_GROUP.fullmatch(first)) and all(len(piece) == 3 for piece in others)

    @property
    def well_formed(self) -> bool:
        """Whether the separators are used as in some country."""
        decimal, grouping = self.marks
        kinds = set(self.separators)
        if decimal is not None:
            return (
                self.separators.count(decimal) == 1
                and decimal in ".,"
                and len(kinds) <= 2
                and (grouping is None or self._grouped(len(self.pieces) - 1))
            )
        return not kinds or (len(kinds) == 1 and self._grouped(len(self.pieces)))


def read_mantissa(text: str, place: int = 0) -> Mantissa | None:
    """The run of digits that begins at `place` of a folded text; None where none begins there."""
    found = _RUN.match(text, place)
    return _make_mantissa(found) if found else None


def _make_mantissa(found: re.Match[str]) -> Mantissa:
    exponent = found["power"] is not None or found["ten"] is not None
    if found["decimals"]:
        return Mantissa(("", found["decimals"][1:]), (found["decimals"][0],), exponent)
    pieces = re.split(r"[.,'\u2009 ]", found["body"])
    return Mantissa(tuple(pieces), tuple(re.findall(r"[.,'\u2009 ]", found["body"])), exponent)


def scan(text: str, place: int, style: DecimalStyle, *, power: Power = "any") -> TypedNumber | None:
    """The number that begins at `place` of a folded text, None where none does, with such a power
    of ten as is wanted.

    Raises Unreadable for wrong grouping, too many digits, too large powers, and ambiguous marks.
    """
    found = _RUNS[power].match(text, place)
    if found is None:
        return None
    parts = _make_mantissa(found)
    if not parts.well_formed:
        raise Unreadable(Message("typing.many-numbers", typed=Quoted(show(found[0]))))
    decimal, reason = _find_decimal_mark(parts, style)
    whole = "".join(parts.pieces[:-1] if decimal else parts.pieces)
    decimals = parts.pieces[-1] if decimal else ""
    tens = found["power"] or found["ten"] or "0"
    _require_bounded(whole + decimals, tens)
    digits = (
        f"{whole or '0'}{'.' if decimals else ''}{decimals}{f'e{int(tens)}' if int(tens) else ''}"
    )
    value = _scale(int(whole + decimals), int(tens) - len(decimals))
    return TypedNumber(value, digits, found.end(), reason)


def _scale(digits: int, power_of_ten: int) -> Fraction:
    """digits * 10**power_of_ten, exactly."""
    return (
        Fraction(digits * 10**power_of_ten)
        if power_of_ten >= 0
        else Fraction(digits, 10**-power_of_ten)
    )


def _find_decimal_mark(parts: Mantissa, style: DecimalStyle) -> tuple[str | None, Text]:
    """The decimal mark of this number, None where it has none, and the reason where that is
    ambiguous.
    """
    if not parts.ambiguous:
        certain = parts.marks
        return certain[0], Message("typing.blank-groups") if " " in parts.separators else ""
    [mark] = parts.separators
    use, reason = (
        (style.comma, style.comma_reason) if mark == "," else (style.point, style.point_reason)
    )
    if use == "unknown":
        typed = Quoted(mark.join(parts.pieces))
        one, other = ".".join(parts.pieces), "".join(parts.pieces)
        raise Unreadable(
            Message("typing.either-number", typed=typed, one=one, other=other, reason=reason)
        )
    return mark if use == "decimal" else None, reason


def _require_bounded(digits: str, power: str) -> None:
    if len(digits.lstrip("0")) > MOST_DIGITS:
        raise Unreadable(Message("typing.many-digits", most=MOST_DIGITS))
    if len(power) > 6 or abs(int(power)) > LARGEST_EXPONENT:
        raise Unreadable(Message("typing.large-power", largest=LARGEST_EXPONENT))


def require_no_uncertainty(text: str, found: TypedNumber, typed: Quoted) -> None:
    """Raises Unreadable for 1.234(5): the uncertainty of the last digit, or a second try; it quotes
    the answer as it was `typed`.
    """
    if "." in found.digits and _IN_BRACKETS.match(text, found.end):
        raise Unreadable(Message("typing.range", typed=typed))


def describe_number(text: str, place: int, found: TypedNumber) -> Text:
    """What the instructor should know about a number just read at a place, quoted as it was typed;
    "" where nothing is in doubt.
    """
    if not found.reason:
        return ""
    typed = Quoted(show(text[place : found.end]))
    return Message("typing.read-as", typed=typed, digits=found.digits, reason=found.reason)
