"""What students type, and what it is read as."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.grading.answers import Reading, read
from kinegrade.grading.unit_spelling import same_unit

NUMBERS = [
    ("0.866", "0.866"),
    (".866", "0.866"),
    (",866", "0.866"),
    ("0,866", "0.866"),
    ("5.", "5"),
    ("5,", "5"),
    ("007", "007"),
    ("1.50", "1.50"),
    ("-12", "-12"),
    ("+3", "3"),
    ("- 12", "-12"),
    ("-.5", "-0.5"),
    ("+,5", "0.5"),
    ("-0", "-0"),
    ("8.66e-1", "8.66e-1"),
    ("8,66E-1", "8.66e-1"),
    ("8.66E+01", "8.66e1"),
    ("1e99", "1e99"),
    (".5e3", "0.5e3"),
    ("\uff10\uff0e\uff18\uff16\uff16", "0.866"),  # full-width 0.866
    ("\uff10\uff0c\uff18\uff16\uff16", "0.866"),  # full-width comma
    ("0\u30028", "0.8"),  # ideographic full stop
    ("\uff0d12", "-12"),  # full-width minus
    ("\uff0b3", "3"),
    ("\uff18.6\uff25\uff0d1", "8.6e-1"),
    ("\u221212", "-12"),  # minus sign
    ("\u201312", "-12"),  # en dash
    ("\u201412", "-12"),  # em dash
    ("\u201012", "-12"),  # hyphen
    ("\u201112", "-12"),  # no-break hyphen
    ("\u201212", "-12"),  # figure dash
    ("\ufe6312", "-12"),  # small hyphen-minus
    ("8.66e\u22121", "8.66e-1"),
    ("  0.5\t", "0.5"),
    ("\u00a00.5\u00a0", "0.5"),
    ("\u30000.5\u3000", "0.5"),
    ("\u202f0.5", "0.5"),
    ("\ufeff0.5\u200b", "0.5"),
    ("0.5\n", "0.5"),
    ("0.5m/s", "0.5"),
    ("0.5 m/s", "0.5"),
    ("0,5 m/s", "0.5"),
    ("0.5\u00a0m/s", "0.5"),
    ("0.5 m / s", "0.5"),
    ("0.5 m s^-1", "0.5"),
    ("0.5 m·s⁻¹", "0.5"),
    ("0.5 m\u22c5s\u207b\u00b9", "0.5"),
    ("0.5 m*s^(-1)", "0.5"),
    ("0.5 m.s-1", "0.5"),
    ("0.5 m·s\u22121", "0.5"),
    ("0.5 ㎧", "0.5"),
    ("0.5 \uff4d\uff0f\uff53", "0.5"),
    ("0.5 (m/s)", "0.5"),
    ("0.5 [m/s]", "0.5"),
    ("0.5 米/秒", "0.5"),
    ("5e2m/s", "5e2"),
    ("1,234", "1.234"),
    ("0" * 40, "0" * 40),
]

BLANKS = [
    "",
    " ",
    "\t",
    "\u3000",
    "\u00a0 ",
    "\ufeff",
    "\u200b",
    "-",
    "--",
    "\u2014",
    "\u2014\u2014",
    " \u2212 ",
    " " * 5000,
]

UNREADABLE = [
    ("1,234.5", "more than one number, or has a thousands separator"),
    ("1.234,5", "more than one number, or has a thousands separator"),
    ("1,234,567", "more than one number"),
    ("1 234", "more than one number"),
    ("1\u00a0234", "more than one number"),
    ("1'234", "more than one number"),
    ("1.2.3", "more than one number"),
    ("0.5; 0.6", "stands after the number"),
    ("0.5 0.6", "more than one number"),
    ("0.5\n0.6", r'"0.5\n0.6" is more than one number'),
    ("3/4", "is a calculation; a decimal number was expected"),
    ("1+1", "is a calculation"),
    ("2*3", "is a calculation"),
    ("2^3", "is a calculation"),
    ("2**3", "is a calculation"),
    ("5-", '"-" stands after the number'),
    ("8.66×10^-1", "a power of ten is written 8.66e-1"),
    ("8.66x10^-1", "a power of ten is written 8.66e-1"),
    ("nan", '"nan" is not a number'),
    ("inf", '"inf" is not a number'),
    ("-inf", "is not a number"),
    ("=1+1", '"=1+1" is not a number'),
    ("=0.5", "is not a number"),
    ("'0.5", "is not a number"),
    ("v=0.5", "is not a number"),
    ("about 0.5", "is not a number"),
    ("0.5?", '"?" stands after the number'),
    ("0.5 up", '"up" stands after the number; the unit "m/s" was expected'),
    ("0.5 km/h", '"km/h" stands after the number; the unit "m/s" was expected'),
    ("0.5 mm/s", '"mm/s"'),
    ("0.5 m/s^2", '"m/s^2"'),
    ("0.5 m/s²", '"m/s²"'),
    ("0.5 s/m", '"s/m"'),
    ("0.5 M/S", '"M/S"'),
    ("0.5 m/", '"m/"'),
    ("0.5 m/s 2", '"m/s 2"'),
    ("0.5 Hz", '"Hz"'),
    ("50%", '"%"'),
    ("0x10", "is a calculation"),
    ("1_000", '"_000"'),
    ("5e", '"e"'),
    ("5e3.2", "more than one number"),
    ("5j", '"j"'),
    ("½", "is not a number"),
    ("٣", "is not a number"),
    ("²", "is not a number"),
    ("2²", '"²"'),
    ("٣.5", "is not a number"),
    (".", "is not a number"),
    (",", "is not a number"),
    ("e5", "is not a number"),
    ("+", "is not a number"),
    ("+-5", "is not a number"),
    ("__import__('os')", "is not a number"),
    ("a\0b", r'"a\x00b" is not a number'),
    ("1e100", "a power of ten beyond 99"),
    ("1e-100", "a power of ten beyond 99"),
    ("1e" + "9" * 90, "a power of ten beyond 99"),
    ("1" * 41, "more than 40 digits"),
    ("0." + "3" * 41, "more than 40 digits"),
    ("1" * 101, "longer than 100 characters"),
    ("9" * 1_000_000, "longer than 100 characters"),
]


@pytest.mark.parametrize(("typed", "read_as"), NUMBERS)
def test_numbers(typed: str, read_as: str) -> None:
    reading = read(typed, "m/s")
    assert (reading.kind, reading.read_as, reading.value) == ("number", read_as, Fraction(read_as))
    assert reading.typed == typed


@pytest.mark.parametrize("typed", BLANKS)
def test_blanks(typed: str) -> None:
    assert read(typed, "m/s") == Reading("blank", typed)


@pytest.mark.parametrize(("typed", "reason"), UNREADABLE)
def test_unreadable(typed: str, reason: str) -> None:
    reading = read(typed, "m/s")
    assert (reading.kind, reading.value, reading.typed) == ("unreadable", None, typed)
    assert reason in reading.reason


@pytest.mark.parametrize(
    ("typed", "remarked"),
    [("1,234", True), ("12,500", True), ("-123,456 m/s", True), ("0,234", False), ("1.234", False),
     ("1,23", False), ("1234,567", False), ("1,2345", False), ("1,234e0", False)],
)  # fmt: skip
def test_what_looks_like_a_thousands_separator_is_read_as_decimal_and_remarked(
    typed: str, remarked: bool
) -> None:
    reading = read(typed, "m/s")
    assert reading.kind == "number"
    expected = f"read as {reading.read_as}; a comma is the decimal mark"
    assert reading.remark == (expected if remarked else "")


@pytest.mark.parametrize(
    ("typed", "unit", "same"),
    [
        ("m/s²", "m/s^2", True),
        ("m·s⁻²", "m/s^2", True),
        ("m s-2", "m/s^2", True),
        ("m/s2", "m/s^2", True),
        ("m/s**2", "m/s^2", True),
        ("m/s^{2}", "m/s^2", True),
        ("m/s/s", "m/s^2", True),
        ("m/(s)^2", "m/s^2", False),
        ("㎨", "m/s^2", True),
        ("ms^-2", "m/s^2", False),
        ("rad/s", "rad/s", True),
        ("rad s⁻¹", "rad/s", True),
        ("弧度/秒", "rad/s", True),
        ("1/s", "rad/s", False),
        ("deg/s", "rad/s", False),
        ("°", "deg", True),
        ("º", "deg", True),
        ("度", "deg", True),
        ("degrees", "deg", True),
        ("rad", "deg", False),
        ("mm/s", "mm/s", True),
        ("m/s", "mm/s", False),
        ("", "1", True),
        ("m", "1", False),
        ("r/min", "r/min", True),
        ("%", "%", True),
    ],
)
def test_spellings_of_a_unit(typed: str, unit: str, same: bool) -> None:
    assert same_unit(typed, unit) is same


@pytest.mark.parametrize(
    ("typed", "unit"), [("30°", "deg"), ("30 deg", "deg"), ("2,5", "1"), ("2 rad/s", "rad/s")]
)
def test_the_ask_s_own_unit_may_be_written_out(typed: str, unit: str) -> None:
    assert read(typed, unit).kind == "number"


def test_a_pure_number_has_no_unit() -> None:
    assert read("2 m", "1").reason == '"m" stands after the number; no unit was expected'


FULL_WIDTH = str.maketrans("0123456789.,-+eE", "０１２３４５６７８９．，－＋ｅＥ")


@st.composite
def written(draw: st.DrawFn) -> tuple[str, Fraction]:
    """A decimal number and one of the ways to write it."""
    digits, places, power = draw(st.integers(0, 10**18)), draw(st.integers(0, 18)), draw(st.integers(-99, 99))
    minus = draw(st.booleans())
    whole, decimals = divmod(digits, 10**places)
    text = f"{whole}{draw(st.sampled_from('.,'))}{decimals:0{places}d}" if places else str(whole)
    if places and not whole and draw(st.booleans()):
        text = text[1:]
    value = Fraction(digits, 10**places)
    if draw(st.booleans()):
        text, value = f"{text}{draw(st.sampled_from('eE'))}{power}", value * Fraction(10) ** power
    text = draw(st.sampled_from(["-", "\u2212", "\u2013"] if minus else ["", "+"])) + text
    if draw(st.booleans()):
        text = text.translate(FULL_WIDTH)
    blank = st.text(" \t\u3000\u00a0", max_size=2)
    unit = draw(st.sampled_from(["", "m/s", " m/s", " m·s⁻¹", "\u00a0m s^-1"]))
    return f"{draw(blank)}{text}{unit}{draw(blank)}", -value if minus else value


@given(written())
def test_a_number_written_in_any_accepted_way_reads_back_as_itself(case: tuple[str, Fraction]) -> None:
    typed, value = case
    assert read(typed, "m/s").value == value


@given(
    st.one_of(st.text(), st.text("0123456789.,-+eE m/s^²⁻·()°×\u2212\u3000", max_size=20)),
    st.sampled_from(["m/s", "deg", "1"]),
)
def test_no_text_raises_and_every_unreadable_one_has_its_reason(typed: str, unit: str) -> None:
    reading = read(typed, unit)
    assert reading.typed == typed
    assert (reading.kind == "number") is (reading.value is not None) is bool(reading.read_as)
    assert (reading.kind == "unreadable") is bool(reading.reason)
