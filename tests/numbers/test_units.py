"""Units: products of powers, their factors to SI, and how they print."""

from __future__ import annotations

from typing import Any

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import ExpressionError
from kinegrade.numbers.units import SCALES, Scale, read_unit

Q = fmpq


@pytest.mark.parametrize(
    ("text", "factor", "dimension"),
    [
        ("m", Q(1), (1, 0, 0)),
        ("mm", Q(1, 1000), (1, 0, 0)),
        ("cm/s", Q(1, 100), (1, -1, 0)),
        ("mm/s^2", Q(1, 1000), (1, -2, 0)),
        ("km/h", Q(5, 18), (1, -1, 0)),
        ("m/min", Q(1, 60), (1, -1, 0)),
        ("rad/s", Q(1), (0, -1, 1)),
        ("rad/s^2", Q(1), (0, -2, 1)),
        ("rad", Q(1), (0, 0, 1)),
        ("1", Q(1), (0, 0, 0)),
        ("1/s", Q(1), (0, -1, 0)),
        ("s^-1", Q(1), (0, -1, 0)),
        ("m^2/s^2", Q(1), (2, -2, 0)),
        ("m*s", Q(1), (1, 1, 0)),
        ("cm^2", Q(1, 10000), (2, 0, 0)),
    ],
)
def test_factors_and_dimensions(text: str, factor: Any, dimension: tuple[int, int, int]) -> None:
    unit = read_unit(text)
    assert unit.scale == Scale(factor)
    assert (unit.length, unit.time, unit.angle) == dimension
    assert unit.text == text


@pytest.mark.parametrize(
    "text",
    [
        "",
        " ",
        "Hz",
        "N",
        "m s",
        "m//s",
        "/s",
        "m/",
        "*m",
        "m^5",
        "m^",
        "m^-",
        "M",
        "Rpm",
        "m/s²",
        "m1",
        "m;s",
        "__class__",
        "mm mm",
        "1e3",
        "m^0",
        "µm",
    ],
)
def test_what_is_no_unit_is_told_with_what_is_known(text: str) -> None:
    with pytest.raises(ExpressionError) as refusal:
        read_unit(text)
    known = "1, cm, deg, ft, h, in, km, m, min, mm, r, rad, rpm, s"
    expected = f'unit "{text}" - expected a product or quotient like m/s^2 of {known}'
    assert str(refusal.value).startswith(expected)


def test_a_misspelt_unit_is_told_with_the_nearest() -> None:
    with pytest.raises(ExpressionError, match='unit "rads/s" - .* - did you mean "rad"'):
        read_unit("rads/s")


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("kph", "km/h"),
        ("U/min", "r/min"),
        ("rev/min", "r"),
        ("m/sec", "s"),
        ("degrees", "deg"),
        ("°", "deg"),
    ],
)
def test_a_unit_as_people_write_it_is_told_with_what_is_meant(text: str, meant: str) -> None:
    with pytest.raises(ExpressionError, match=f'did you mean "{meant}"'):
        read_unit(text)


@pytest.mark.parametrize(
    ("text", "metres"), [("in", "127/5000"), ("ft", "381/1250"), ("ft/s^2", "381/1250")]
)
def test_inches_and_feet_are_exact(text: str, metres: str) -> None:
    assert str(read_unit(text).scale.rational) == metres


@pytest.mark.parametrize(
    ("text", "scale", "dimension"),
    [
        ("deg", Scale(Q(1, 180), 1), (0, 0, 1)),
        ("deg/s", Scale(Q(1, 180), 1), (0, -1, 1)),
        ("deg/s^2", Scale(Q(1, 180), 1), (0, -2, 1)),
        ("r/min", Scale(Q(1, 30), 1), (0, -1, 1)),
        ("rpm", Scale(Q(1, 30), 1), (0, -1, 1)),
        ("r/s", Scale(Q(2), 1), (0, -1, 1)),
        ("r/min^2", Scale(Q(1, 1800), 1), (0, -2, 1)),
        ("r/min/s", Scale(Q(1, 30), 1), (0, -2, 1)),
    ],
)
def test_degrees_and_revolutions_are_exact_multiples_of_pi(
    text: str, scale: Scale, dimension: tuple[int, int, int]
) -> None:
    unit = read_unit(text)
    assert (unit.text, unit.scale) == (text, scale)
    assert (unit.length, unit.time, unit.angle) == dimension


@pytest.mark.parametrize("text", ["deg^2", "deg*m", "m/deg", "r", "r*m/s", "deg*s", "r/s^3"])
def test_degrees_and_revolutions_stand_in_angles_and_rates_alone(text: str) -> None:
    with pytest.raises(ExpressionError, match="deg and r count in rates: deg/s, r/min, r/min"):
        read_unit(text)


@given(st.text("ms\n\r\u2028 /^2", max_size=12) | st.text(max_size=12))
def test_any_text_is_a_unit_or_refused_in_one_line(text: str) -> None:
    problem = ""
    try:
        read_unit(text)
    except ExpressionError as error:
        problem = str(error)
    assert "\n" not in problem


@given(
    st.lists(
        st.tuples(st.sampled_from(sorted(set(SCALES) - {"deg", "r"})), st.integers(1, 4)),
        min_size=1,
        max_size=4,
    )
)
def test_a_product_has_the_product_of_the_factors(parts: list[tuple[str, int]]) -> None:
    unit = read_unit("*".join(f"{name}^{power}" for name, power in parts))
    factor = Q(1)
    for name, power in parts:
        factor *= SCALES[name][0].rational ** power
    assert unit.scale == Scale(factor)


@pytest.mark.parametrize(
    ("text", "latex", "printed"),
    [
        ("m/s^2", r"\mathrm{m}/\mathrm{s}^2", "m/s²"),
        ("rad/s", r"\mathrm{rad}/\mathrm{s}", "rad/s"),
        ("deg", r"^\circ", "°"),
        ("1", "", "1"),
        ("s^-1", r"\mathrm{s}^{-1}", "s^-1"),
        ("mm", r"\mathrm{mm}", "mm"),
    ],
)
def test_how_units_print(text: str, latex: str, printed: str) -> None:
    unit = read_unit(text)
    assert (unit.latex, unit.printed, unit.degrees) == (latex, printed, text == "deg")
