"""What a student typed into one cell, read digit by digit: a number or formula, its unit, and its
sense in words.

`read` is called for every cell of an answer sheet; `judge` is the next level up. Values are exact
fractions, or known to 38 digits where they are irrational. Nothing is rounded, and nothing is
evaluated but the small grammar of `typed_value`. Text that can be understood in two ways is
unreadable, and the reason names both. `number_text` reads digits, `decimal_style` decides about
`1,234`, `unit_spelling` converts units, `sense` turns clockwise into a sign.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from typing import Literal, assert_never

from kinegrade.grading.typed.amount import Amount, convert, make_rational_amount, work_out
from kinegrade.grading.typed.conversion import Conversion, WrongUnit, find_conversion
from kinegrade.grading.typed.keyboard import BLANKS, fold, show
from kinegrade.grading.typed.number_and_unit import split_unit
from kinegrade.grading.typed.number_text import MOST_DIGITS, DecimalStyle, TypedNumber, Unreadable
from kinegrade.grading.typed.raised_dot import find_raised_dot
from kinegrade.grading.typed.sense import find_direction, split_sense
from kinegrade.grading.typed.undressing import undress
from kinegrade.grading.typed.value import Formula, scan_value
from kinegrade.language.message import Message, Quoted, Text
from kinegrade.numbers.decimals import round_to_decimal
from kinegrade.sign_conventions import Convention

_LONGEST_ANSWER = 200
_TOO_LONG = Message("marking.too-long", most=_LONGEST_ANSWER)
_SHOWN_DIGITS = 12
PAPERS_RULE = DecimalStyle()
_TRIED = "7", "2.25"  # numbers, as they are typed

# What most people type
PLAIN = rf"([+-]?)([0-9]{{1,{MOST_DIGITS // 2}}})(?:\.([0-9]{{1,{MOST_DIGITS // 2}}}))?"
_PLAIN = re.compile(PLAIN)
_DIGIT = re.compile(r"\d")
_TAIL = re.compile(r"[\s.;,!\u3001]+$")
_SIGN = re.compile(r"([+-]?)\s*")
_NEXT_NUMBER = re.compile(r"[\s.,;'\u3001~=\u2248]*(?:[+-]\s*)?\(?\s*[0-9]")
_DECIMAL = r"[0-9]+[.,][0-9]+"
_IN_BRACKETS = re.compile(rf"\(\s*(?:{_DECIMAL}|[0-9]+)\s*\)")
_SLASH = re.compile(rf"{_DECIMAL}\s*/\s*{_DECIMAL}")
_SHARE_OF_TIME = re.compile(r"\s*1\s*/\s*[^\W\d]|\s*\(\s*1\s*/")


@dataclass(frozen=True, slots=True)
class Reading:
    """One cell as read: `typed` is the original text, `read_as` plain digits with a point, `value`
    in the ask's unit.

    `error` bounds how far an irrational value may be off; it is zero where `value` is exact.
    `reason` says why a cell is unreadable or its unit wrong; `remark` is a note for the instructor
    on a cell that was read.
    """

    kind: Literal["number", "blank", "unreadable", "wrong unit"]
    typed: str
    value: Fraction | None = None
    read_as: str = ""
    reason: Text = ""
    remark: Text = ""
    error: Fraction = Fraction(0)


def read(
    typed: str,
    unit: str,
    style: DecimalStyle = PAPERS_RULE,
    convention: Convention | None = None,
    sign: str = "",
) -> Reading:
    """Reads an answer in `unit`, which is assumed where none is typed; dashes alone count as blank.
    Never raises.

    `style` decides about 1,234; `convention` and `sign` are the ask's sign convention and its
    words, for answers with a sense in words.

    >>> read("8,66E-1 m/s", "m/s").value, read("866 mm/s", "m/s").read_as
    (Fraction(433, 500), '0.866')
    >>> read("12 rad/s clockwise", "rad/s", convention="ccw").value
    Fraction(-12, 1)
    >>> read("5 m/s", "rad/s").kind
    'wrong unit'
    """
    plain = _PLAIN.fullmatch(typed)
    if plain and style.point == "decimal" and not style.point_reason:
        sign, whole, decimals = plain.groups("")
        value = Fraction(int(f"{sign}{whole}{decimals}"), 10 ** len(decimals))
        return Reading("number", typed, value, typed.removeprefix("+"))
    parted = split_unit(typed, style)
    alike = parted and _read_alike(parted.sign, parted.rest, unit, convention, sign)
    if parted and alike:
        if alike.kind != "number":
            return replace(alike, typed=typed)
        return Reading("number", typed, parted.value, parted.digits)
    if not _DIGIT.search(typed):
        return _read_words(typed, unit, convention, sign)
    return _read_any(typed, unit, style, convention, sign)


@lru_cache(maxsize=4096)
def _read_words(typed: str, unit: str, convention: Convention | None, sign: str) -> Reading:
    """The reading of a text without digits, which is the same in every style."""
    return _read_any(typed, unit, PAPERS_RULE, convention, sign)


def _read_any(
    typed: str, unit: str, style: DecimalStyle, convention: Convention | None, sign: str
) -> Reading:
    """The reading of a text, whatever it is."""
    text = typed.strip(BLANKS)
    if len(text) > _LONGEST_ANSWER:
        return Reading("unreadable", typed, reason=_TOO_LONG)
    raised = find_raised_dot(text)
    if raised is not None:
        return Reading("unreadable", typed, reason=raised)
    text = fold(text)
    if not text.strip("- "):
        return Reading("blank", typed)
    try:
        return _read(typed, text, unit, style, convention=convention, words=sign)
    except Unreadable as fault:
        return Reading("unreadable", typed, reason=fault.reason)
    except WrongUnit as fault:
        return Reading("wrong unit", typed, reason=fault.reason)


@lru_cache(maxsize=4096)
def _read_alike(
    sign: str, rest: str, unit: str, convention: Convention | None, words: str
) -> Reading | None:
    """How every number with that sign is read where `rest` stands behind it: as it is, or not at
    all for a reason that names no number; None for any other rest, such as one that makes zero of
    all numbers. It is the same behind any number, so two are tried.
    """
    found: list[Reading] = []
    for digits in (f"{sign}{each}" for each in _TRIED):
        tried = _read_any(f"{digits}{rest}", unit, PAPERS_RULE, convention, words)
        plain = Reading("number", tried.typed, Fraction(digits), digits)
        found.append(Reading("number", "") if tried == plain else replace(tried, typed=""))
    first, second = found
    return first if first == second and first.value is None and not first.remark else None


def _read(
    typed: str,
    text: str,
    unit: str,
    style: DecimalStyle,
    *,
    convention: Convention | None,
    words: str,
) -> Reading:
    answer, sense = split_sense(_TAIL.sub("", undress(text)))
    answer = _TAIL.sub("", undress(answer))
    sign = _SIGN.match(answer)
    place = sign.end() if sign else 0
    found = scan_value(answer, place, style)
    if found is None:
        raise Unreadable(Message("typing.not-a-number", typed=Quoted(show(typed.strip(BLANKS)))))
    rest = answer[found.end :]
    factor = _find_conversion(rest, unit, typed)
    if isinstance(found, Formula) and found.pi and unit == "deg" and not rest.strip():
        raise Unreadable(Message("typing.pi-for-degrees"))
    written = sign[1] if sign else ""
    turn, remark = find_direction(sense, written, convention, words) if sense else (1, "")
    minus = (written == "-") != (turn < 0)
    doubt = _describe_form(answer[: found.end]) or _describe_doubt(found, minus)
    both = Message("marking.two-remarks", first=doubt, second=remark)
    said = both if doubt and remark else doubt or remark
    if isinstance(found, TypedNumber) and factor == Conversion():
        return _read_as_typed(typed, found, minus, said)
    return _work_out(typed, found, minus, factor, said)


def _describe_doubt(found: TypedNumber | Formula, minus: bool) -> Text:
    """What the instructor should know about how a number was read, with the sign that was typed or
    given in words.
    """
    match found:
        case TypedNumber():
            digits = _apply_sign(found, minus)
            return found.reason and Message(
                "typing.number-read-as", digits=digits, reason=found.reason
            )
        case Formula():
            return found.remark
        case _:
            assert_never(found)


def _describe_form(text: str) -> Text:
    """What the instructor should know of a number in brackets, and of two with a slash between."""
    if _IN_BRACKETS.fullmatch(text):
        return Message("typing.in-brackets")
    if _SLASH.fullmatch(text):
        return Message("typing.quotient-of-decimals")
    return ""


def _apply_sign(found: TypedNumber, minus: bool) -> str:
    """A typed number in plain digits with its sign."""
    return f"-{found.digits}" if minus else found.digits


def _find_conversion(rest: str, unit: str, typed: str) -> Conversion:
    """The conversion that the text after the number calls for. Raises Unreadable or WrongUnit."""
    if _NEXT_NUMBER.match(rest) and not _SHARE_OF_TIME.match(rest):
        raise Unreadable(Message("typing.more-than-one", typed=Quoted(show(typed.strip(BLANKS)))))
    return find_conversion(rest, unit)


def _read_as_typed(typed: str, found: TypedNumber, minus: bool, remark: Text) -> Reading:
    value = -found.value if minus else found.value
    return Reading("number", typed, value, _apply_sign(found, minus), remark=remark)


def _work_out(
    typed: str, found: TypedNumber | Formula, minus: bool, factor: Conversion, remark: Text
) -> Reading:
    amount = _make_amount(found)
    value, error = convert(amount, -factor.factor if minus else factor.factor, factor.pi)
    return Reading("number", typed, value, decimal_text(value), remark=remark, error=error)


def _make_amount(found: TypedNumber | Formula) -> Amount:
    match found:
        case TypedNumber(value=value):
            return make_rational_amount(value)
        case Formula():
            return work_out(found)
        case _:
            assert_never(found)


def decimal_text(value: Fraction) -> str:
    """A fraction in digits: all of them where there are few, otherwise the first twelve.

    >>> decimal_text(Fraction(3, 4)), decimal_text(Fraction(2, 3))
    ('0.75', '0.666666666667')
    """
    short = round_to_decimal(value, _SHOWN_DIGITS)
    return f"{short:f}" if -7 < short.adjusted() < 21 else str(short).lower()
