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

from kinegrade.grading.typed.amount import (
    Amount,
    convert,
    decimal_text,
    make_rational_amount,
    work_out,
)
from kinegrade.grading.typed.conversion import (
    Conversion,
    WrongUnit,
    find_conversion,
    find_only_conversion,
)
from kinegrade.grading.typed.keyboard import BLANKS, fold, show
from kinegrade.grading.typed.number_and_unit import NumberAndUnit, split_unit
from kinegrade.grading.typed.number_text import MOST_DIGITS, DecimalStyle, TypedNumber, Unreadable
from kinegrade.grading.typed.raised_dot import find_raised_dot
from kinegrade.grading.typed.remarks import apply_sign, describe_doubt, describe_form
from kinegrade.grading.typed.sense import find_direction, split_sense
from kinegrade.grading.typed.undressing import undress
from kinegrade.grading.typed.value import Formula, scan_value
from kinegrade.language.message import Message, Quoted, Text
from kinegrade.sign_conventions import Convention

_LONGEST_ANSWER = 200
_TOO_LONG = Message("marking.too-long", most=_LONGEST_ANSWER)
PAPERS_RULE = DecimalStyle()
_MOST = 10**30  # the largest factor: no number of few digits becomes too large or too small by it
_TRIED = "7", "2.25"  # numbers, as they are typed

# What most people type
PLAIN = rf"([+-]?)([0-9]{{1,{MOST_DIGITS // 2}}})(?:\.([0-9]{{1,{MOST_DIGITS // 2}}}))?"
_PLAIN = re.compile(PLAIN)
_DIGIT = re.compile(r"\d")
_TAIL = re.compile(r"[\s.;,!\u3001]+$")
_TEXT_MARK = re.compile(r"'(?=[-+.,\d])")  # with which spreadsheets, too, begin a text
_MARKED = Message("typing.text-mark")
_SIGN = re.compile(r"([+-]?)\s*")


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
    behind = parted and read_behind(parted.sign, parted.rest, unit, convention, sign)
    if parted and behind:
        return behind.read(typed, parted)
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
    if _TEXT_MARK.match(text):
        meant = _read_any(text[1:], unit, style, convention, sign)
        return replace(meant, typed=typed, remark=meant.remark or _MARKED)
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


@dataclass(frozen=True, slots=True)
class Behind:
    """What any number becomes by what stands behind it: another by a `factor`, or what is `alike`
    for all of them.
    """

    factor: Conversion
    alike: Reading | None = None

    @property
    def keeps_number(self) -> bool:
        """Whether the number is the answer as it stands."""
        return self.alike is None and self.factor == Conversion()

    def read(self, typed: str, parted: NumberAndUnit) -> Reading:
        """The reading of such a text."""
        if self.alike is not None:
            return Reading(self.alike.kind, typed, reason=self.alike.reason)
        if self.keeps_number:
            return Reading("number", typed, parted.value, parted.digits)
        if self.factor.pi:
            return _convert(typed, make_rational_amount(parted.value), self.factor)
        value = parted.value * self.factor.factor
        return Reading("number", typed, value, decimal_text(value))


@lru_cache(maxsize=4096)
def read_behind(
    sign: str, rest: str, unit: str, convention: Convention | None, words: str
) -> Behind | None:
    """What every number with that sign becomes where `rest` stands behind it; None where a reading
    says more of the number. It is the same behind any number, so two are tried.
    """
    try:
        factor = find_conversion(rest, unit)
    except (Unreadable, WrongUnit):
        factor = Conversion()
    if not 1 / _MOST < factor.factor < _MOST:
        return None
    parted = [NumberAndUnit(f"{sign}{each}", sign, rest) for each in _TRIED]
    texts = [f"{each.digits}{rest}" for each in parted]
    tried = [_read_any(each, unit, PAPERS_RULE, convention, words) for each in texts]
    converted = Behind(factor)
    if tried == [converted.read(*each) for each in zip(texts, parted, strict=True)]:
        return converted
    first, second = (replace(each, typed="") for each in tried)
    if first == second and first.kind in ("unreadable", "wrong unit") and not first.remark:
        return Behind(factor, first)
    return None


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
    written = sign[1] if sign else ""
    found = scan_value(answer, place, style, typed.strip(BLANKS), minus=written == "-")
    if found is None:
        raise Unreadable(Message("typing.not-a-number", typed=Quoted(show(typed.strip(BLANKS)))))
    rest = answer[found.end :]
    factor = find_only_conversion(rest, unit, typed)
    if isinstance(found, Formula) and found.pi and unit == "deg" and not rest.strip():
        raise Unreadable(Message("typing.pi-for-degrees"))
    turn, remark = find_direction(sense, written, convention, words) if sense else (1, "")
    # The minus before a formula is in its tree
    signed = written == "-" and isinstance(found, TypedNumber)
    minus = signed != (turn < 0)
    doubt = describe_form(answer[: found.end]) or describe_doubt(found, minus)
    both = Message("marking.two-remarks", first=doubt, second=remark)
    said = both if doubt and remark else doubt or remark
    if isinstance(found, TypedNumber) and factor == Conversion():
        return _read_as_typed(typed, found, minus, said)
    return _work_out(typed, found, minus, factor, said)


def _read_as_typed(typed: str, found: TypedNumber, minus: bool, remark: Text) -> Reading:
    value = -found.value if minus else found.value
    return Reading("number", typed, value, apply_sign(found, minus), remark=remark)


def _work_out(
    typed: str, found: TypedNumber | Formula, minus: bool, factor: Conversion, remark: Text
) -> Reading:
    turned = Conversion(-factor.factor if minus else factor.factor, factor.pi)
    return _convert(typed, _make_amount(found), turned, remark)


def _convert(typed: str, amount: Amount, factor: Conversion, remark: Text = "") -> Reading:
    value, error = convert(amount, factor.factor, factor.pi)
    return Reading("number", typed, value, decimal_text(value), remark=remark, error=error)


def _make_amount(found: TypedNumber | Formula) -> Amount:
    match found:
        case TypedNumber(value=value):
            return make_rational_amount(value)
        case Formula():
            return work_out(found)
        case _:
            assert_never(found)
