"""Spellings of units, what they are worth, and what is told of those that measure something
else.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.grading.typed.conversion import Conversion, WrongUnit, find_conversion
from kinegrade.grading.typed.number_text import Unreadable
from kinegrade.grading.typed.unit_spelling import read_unit
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue

SAME = Conversion()


@pytest.mark.parametrize(("typed", "unit"), [
    ("m/s²", "m/s^2"), ("m·s⁻²", "m/s^2"), ("m s-2", "m/s^2"), ("m/s2", "m/s^2"), ("m/s**2", "m/s^2"),
    ("m/s^{2}", "m/s^2"), ("m/s/s", "m/s^2"), ("m/(s)^2", None), ("m/(s^2)", "m/s^2"), ("㎨", "m/s^2"),
    ("ms^-2", "m/s^2"), ("m/平方秒", "m/s^2"), ("rad s⁻¹", "rad/s"), ("rads-1", "rad/s"), ("弧度/秒", "rad/s"),
    ("°", "deg"), ("º", "deg"), ("˚", "deg"), ("Deg", "deg"), ("KM/H", "km/h"), ("kph", "km/h"), ("r/min", "rpm"),
    ("min^-1 r", "rpm"), ("公尺", "m"), ("m per square second", "m/s^2"), ("米/秒的平方", "m/s^2"), ("decimetre", "dm"), ("r", None), ("r m", None), ("Nm", None), ("m//s", None), ("m^", None),
    ("m)", None), ("(m", None), ("m^22", None), ("((m))", None), ("/", None),
    ("", None),
])  # fmt: skip
def test_spellings(typed: str, unit: str | None) -> None:
    assert read_unit(typed) == (None if unit is None else read_unit(unit))
    assert unit is None or read_unit(unit) is not None


@pytest.mark.parametrize(("typed", "unit", "factor", "pi"), [
    ("", "m", 1, 0), ("m", "mm", 1000, 0), ("mm/s", "cm/s", Fraction(1, 10), 0), ("km/h", "m/s", Fraction(5, 18), 0),
    ("rpm", "rad/s", Fraction(1, 30), 1), ("deg", "rad", Fraction(1, 180), 1), ("rad", "deg", 180, -1),
    ("deg/s", "rad/s", Fraction(1, 180), 1), ("rpm", "deg/s", 6, 0), ("1/s", "rad/s", 1, 0),
    ("%", "1", Fraction(1, 100), 0),
    ("(m/s)", "m/s", 1, 0), ("[1]", "1", 1, 0), ("*m", "m", 1, 0), ("dm", "m", Fraction(1, 10), 0), ("N", "N", 1, 0),
])  # fmt: skip
def test_conversions_are_exact(typed: str, unit: str, factor: Fraction, pi: int) -> None:
    assert find_conversion(typed, unit) == Conversion(Fraction(factor), pi)


@pytest.mark.parametrize(("typed", "unit", "reason"), [
    ("m", "m/s", '"m" measures a length; a speed was expected, in "m/s"'),
    ("rad", "1", '"rad" measures an angle; a pure number was expected'),
    ("1/s", "rad/s^2", '"1/s" measures a rate (1/s); an angular acceleration was expected, in '
                       '"rad/s^2"'),
    ("m rad/s", "m/s", '"m rad/s" measures m^1 s^-1 rad^1; a speed was expected, in "m/s"'),
    ("kHz", "rad/s", '"kHz" counts turns or cycles, not radians; an angular velocity was expected, '
                     'in "rad/s"'),
    ("Hz", "furlong", '"Hz" counts turns or cycles, not radians; the unit "furlong" was expected'),
])  # fmt: skip
def test_another_dimension_is_told(typed: str, unit: str, reason: str) -> None:
    with pytest.raises(WrongUnit) as told:
        find_conversion(typed, unit)
    assert str(told.value) == reason


def test_a_refusal_is_said_in_any_language() -> None:
    with pytest.raises(WrongUnit) as told:
        find_conversion("m", "m/s")
    chinese = open_catalogue(Language("zh")).write(told.value.reason)
    assert chinese == '"m" 表示长度；此处应为速度，单位为 "m/s"'


@pytest.mark.parametrize(("typed", "unit", "reason"), [
    (" up", "m/s", '"up" stands after the number; the unit "m/s" was expected'),
    ("m\n", "furlong", '"m" stands after the number; the unit "furlong" was expected'),
    ("1/minute", "rad/s", '"1/minute" can mean turns or radians per minute; write r/min or rad/min'),
    ("1/min", "deg/s", '"1/min" can mean turns or radians per minute; write r/min or rad/min'),
    ("1/min", "rad/s", '"1/min" can mean turns or radians per minute; write r/min or rad/min'),
])  # fmt: skip
def test_an_unknown_unit_is_told(typed: str, unit: str, reason: str) -> None:
    with pytest.raises(Unreadable) as told:
        find_conversion(typed, unit)
    assert str(told.value) == reason


@given(
    st.text(max_size=30) | st.text("mskcrad/^²-1()· 秒", max_size=20),
    st.sampled_from(["m/s", "deg", "1", ""]),
)
def test_any_text_is_converted_or_refused(typed: str, unit: str) -> None:
    told = ""
    try:
        find_conversion(typed, unit)
    except (Unreadable, WrongUnit) as refusal:
        told = str(refusal)
    assert not told or unit in told or '"' in told
