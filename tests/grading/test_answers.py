"""Reading answers: what is written in any accepted way reads back as itself; what is not is refused
at once.

The answers one by one stand in typed_answers.tsv.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import gcd

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.grading.typed.answers import Reading, decimal_text, read
from kinegrade.grading.typed.decimal_style import find_file_style
from kinegrade.grading.typed.number_text import DecimalStyle
from kinegrade.sign_conventions import Convention
from tests.said import said

PI = Fraction("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899")
FULL_WIDTH = str.maketrans({chr(code): chr(code + 0xFEE0) for code in range(0x21, 0x7F)})
SUPERSCRIPTS = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
STYLES = {",": find_file_style([], "comma").style, ".": find_file_style([], "point").style}
GROUPS = {",": [".", " ", "'", "\u2009", "\u202f"], ".": [",", " ", "\u2019", "\u00a0", "\uff0c"]}
UNITS = {  # the ask's unit -> what may be typed for it, and what that is worth
    "m/s": {"": 1, "m/s": 1, "m·s⁻¹": 1, "mm/s": Fraction(1, 1000), "cm s^-1": Fraction(1, 100),
            "km/h": Fraction(5, 18), "米/秒": 1, "m/min": Fraction(1, 60)},
    "rad/s": {"": 1, "rad/s": 1, "1/s": 1, "s⁻¹": 1, "弧度/秒": 1},
    "mm/s^2": {"": 1, "mm/s²": 1, "m/s^2": 1000, "cm·s⁻²": 10},
    "deg": {"": 1, "°": 1, "度": 1, "turn": 360, "rev": 360},
}  # fmt: skip
TURNING = {
    "rpm": Fraction(1, 30),
    "r/min": Fraction(1, 30),
    "转/分": Fraction(1, 30),
    "deg/s": Fraction(1, 180),
    "rev/s": Fraction(2),
    "°/s": Fraction(1, 180),
}  # times pi rad/s


@dataclass(frozen=True)
class Written:
    """A number's size as it is typed, and the decimal style of its file."""

    text: str
    size: Fraction
    style: DecimalStyle


@st.composite
def decimals(draw: st.DrawFn) -> Written:
    """A decimal number not below zero with its digits grouped or not, and perhaps a power of
    ten.
    """
    digits, places, mark = (
        draw(st.integers(0, 10**12)),
        draw(st.integers(0, 8)),
        draw(st.sampled_from(",.")),
    )
    whole, rest = divmod(digits, 10**places)
    scientific = draw(st.booleans())  # then a lone mark is the decimal mark: 1.234e3
    text = (
        f"{whole:,}".replace(",", draw(st.sampled_from(["", *GROUPS[mark]])))
        if not scientific
        else str(whole)
    )
    text += f"{mark}{rest:0{places}d}" if places else draw(st.sampled_from(["", mark]))
    size = Fraction(digits, 10**places)
    if scientific:
        power = draw(st.integers(-30, 30))
        text += draw(
            st.sampled_from(
                [
                    f"e{power}",
                    f"E{power:+}",
                    f"×10^{power}",
                    f" * 10**{power}",
                    f"·10^({power})",
                    f" × 10{str(power).translate(SUPERSCRIPTS)}",
                    f"x10^{power}",
                ]
            )
        )
        size *= Fraction(10) ** power
    return Written(text, size, STYLES[mark])


def dressed(draw: st.DrawFn, text: str, *, full_width: bool = True) -> str:
    """With a label, blanks, full-width forms or a full stop about it."""
    if full_width and draw(st.booleans()):
        text = text.translate(FULL_WIDTH)
    label = draw(st.sampled_from(["", "", "ω=", "v_B = ", "a_{C}^t：", "≈", "= "]))
    blank = st.sampled_from(["", " ", "\u3000", "\u00a0", "\t", "\ufeff"])
    return f"{draw(blank)}{label}{text}{draw(st.sampled_from(['', '', '.', '。']))}{draw(blank)}"


@st.composite
def signed(draw: st.DrawFn, text: str) -> tuple[str, int]:
    """A typed size with a sign before it or a sense behind it, for an ask that counts
    counter-clockwise positive.
    """
    ways = [
        (text, 1),
        (f"+{text}", 1),
        (f"-{text}", -1),
        (f"\u2212{text}", -1),
        (f"－ {text}", -1),
        (f"{text} cw", -1),
        (f"{text}, clockwise", -1),
        (f"{text} （逆时针）", 1),
        (f"顺时针 {text}", -1),
    ]
    return draw(st.sampled_from(ways))


@given(st.data())
def test_a_decimal_number_written_in_any_accepted_way_reads_back_as_itself(
    data: st.DataObject,
) -> None:
    number, unit = data.draw(decimals()), data.draw(st.sampled_from(sorted(UNITS)))
    spelled = data.draw(st.sampled_from(sorted(UNITS[unit])))
    text, sign = data.draw(
        signed(f"{number.text}{' ' if spelled.startswith('1') else ''}{spelled}")
    )
    found = read(dressed(data.draw, text), unit, number.style, "ccw")
    assert (found.value, found.error, said(found.reason)) == (
        sign * number.size * UNITS[unit][spelled],
        0,
        "",
    )
    assert float(found.read_as) == pytest.approx(float(found.value or 0), rel=1e-11)


@given(st.data(), st.integers(1, 999), st.integers(1, 99))
def test_a_fraction_of_whole_numbers_reads_back_as_itself(
    data: st.DataObject, above: int, below: int
) -> None:
    text = data.draw(
        st.sampled_from(["{}/{}", "{} / {}", "{}÷{}", "({})/({})", "{}\u2044{}", "{}/{} m"])
    )
    found = read(dressed(data.draw, text.format(above, below)), "m")
    assert (found.value, found.error) == (Fraction(above, below), 0)


@given(st.data(), st.integers(1, 99), st.integers(1, 99), st.integers(1, 99))
def test_a_root_reads_back_as_itself(
    data: st.DataObject, factor: int, radicand: int, below: int
) -> None:
    forms = [
        "{}√{}/{}",
        "{}*sqrt({})/{}",
        "{} sqrt({}) / {}",
        "({}√({}))/{}",
        "{}·√{}÷{} m",
        "{}*{}^0.5/{}",
        "{}×{}^(1/2)/{}",
        "({0}/{2})√{1}",
    ]
    found = read(
        dressed(data.draw, data.draw(st.sampled_from(forms)).format(factor, radicand, below)), "m"
    )
    square = Fraction(factor**2 * radicand, below**2)
    assert found.value is not None
    assert abs(found.value**2 - square) <= 3 * found.error * found.value
    assert (found.error == 0) is (found.value**2 == square)
    assert found.error <= found.value / 10**37


@given(st.data(), st.integers(1, 99), st.integers(1, 99))
def test_a_multiple_of_pi_reads_back_as_itself(data: st.DataObject, above: int, below: int) -> None:
    common = gcd(above, below)
    text = data.draw(
        st.sampled_from(["{}π/{}", "{}*pi/{}", "{} π / {}", "{}·π/{} rad", "({}/{})π"])
    )
    found = read(dressed(data.draw, text.format(above // common, below // common)), "rad")
    assert found.value is not None
    assert abs(found.value - PI * above / below) <= found.error <= found.value / 10**37


@given(decimals(), st.sampled_from(sorted(TURNING)))
def test_turns_and_degrees_are_certified_to_38_digits(number: Written, unit: str) -> None:
    found = read(f"{number.text} {unit}", "rad/s", number.style)
    exact = number.size * TURNING[unit] * PI
    assert found.value is not None
    assert abs(found.value - exact) <= found.error <= Fraction(1, 10**37) * max(exact, 1)


@given(decimals())
def test_radians_that_are_multiples_of_pi_are_exact_degrees(number: Written) -> None:
    found = read(f"({number.text.replace(' ', '')})π rad", "deg", number.style)
    assert (found.value, found.error) == (number.size * 180, 0)


@pytest.mark.parametrize(("typed", "read_as"), [
    ("1.50", "1.50"), ("1,50", "1.50"), ("007", "007"), ("+3", "3"), ("-0", "-0"), (",5", "0.5"),
    ("8,66E-1", "8.66e-1"),
    ("1 234,5", "1234.5"), ("5 cw", "-5"), ("3/4", "0.75"), ("2/3", "0.666666666667"), ("√3", "1.73205080757"),
    ("5 mm/s", "0.005"), ("1e-9 mm/s", "1e-12"), ("1e30 km/s", "1e+33"), ("5 000 mm/s", "5"),
])  # fmt: skip
def test_digits_are_shown_as_typed_and_those_of_other_values_to_twelve(
    typed: str, read_as: str
) -> None:
    assert read(typed, "m/s", convention="cw" if "cw" not in typed else "ccw").read_as == read_as


def test_zero_and_whole_numbers_are_shown_plainly() -> None:
    assert [decimal_text(Fraction(number)) for number in (0, 100, -120)] == ["0", "100", "-120"]


HOSTILE = [
    "1" * 201, "9" * 1_000_000, "x" * 10_000_000, "(" * 10_000_000, "(" * 200, "√" * 200, "√(" * 99, "((1)" * 50,
    "(1)" * 66, "1," * 100, "1 " * 100, ", " * 100, "a " * 100, "-" * 199 + "1", "1" + "/1" * 99, "1" + "+√2" * 66,
    "(" * 7 + "1+√2" + ")^16" * 7, "2^16" * 50, "((9^16)^16)^16", "√(1+√(2+√(3+√(5+√(7+√(11+√(13+√17)))))))",
    "1/(√2-√2)", "1/(π-π)", "1e-99/(1e99)", "(1e99)(1e99)", "√3*1e99*1e99", "√3/1e99/1", "π" * 200, "½" * 200,
    "9**9**9", "9**9**9**9", "10**(10**10)", "1e" + "9" * 150, "m" * 200, "5 " + "m" * 190, "5 " + "m/" * 95,
    "5 m^999999999", "5 m^9" * 40, "5 (((((((m)))))))", "5 " + "(" * 190, "cw " * 66, "a_" * 90 + "=5", "=" * 200,
    "\x00", "5\x00", "\ud800", "5\udfff", "\u202e12", "12\u200b34", "__import__('os').system('ls')", "{{7*7}}",
    "${7*7}", "%s%n", "1;DROP TABLE", "=cmd|' /C "
                                      "calc'!A0", "\ufeff" * 500, "e" * 199, "." * 199, "-" * 100_000 + "a",
    "\u3000" * 1_000_000 + "5", " \u200b" * 1_000_000 + "5",
]  # fmt: skip


@pytest.mark.parametrize("typed", HOSTILE, ids=range(len(HOSTILE)))
def test_hostile_text_ends_at_once_in_a_reading(typed: str) -> None:
    reading = read(typed, "m/s")
    assert_consistent(reading, typed)


@pytest.mark.parametrize(("typed", "reason"), [
    ("1" * 201, "longer than 200 characters"), ("1" * 41, "more than 40 digits; round the number"),
    ("+".join(["√2"] * 9), "more than 8 roots; write a decimal number"),
    ("(" * 9 + "√2" + ")" * 9, "brackets nested deeper than 8; write a decimal number"),
    ("π" * 25, "a formula of more than 24 parts; write a decimal number"),
    ("(√2*1e99)*1e9", "has no finite value, or one beyond "
                      "1e99"), ("√3*1e-99/9", "a value below 1e-99"),
    ("2e99*2", "a value beyond 1e99 or below 1e-99"),
    ("5 rad/s ", "measures an angular velocity; a speed was expected"),
])  # fmt: skip
def test_bounds_are_told(typed: str, reason: str) -> None:
    assert reason in said(read(typed, "m/s").reason)


SIGNS = "0123456789.,-+eE m/s^²⁻·()°×\u2212\u3000√π½*=≈cw顺时针rad'\u2009:;x "


@given(
    st.one_of(st.text(max_size=300), st.text(SIGNS, max_size=30)),
    st.sampled_from(["m/s", "rad/s", "deg", "1", "no unit"]),
    st.sampled_from([None, "ccw", "magnitude", "signed"]),
    st.sampled_from([*STYLES.values(), DecimalStyle("unknown", "unknown", "?", "?")]),
)
def test_no_text_raises_and_every_unreadable_one_has_its_reason(
    typed: str, unit: str, convention: Convention | None, style: DecimalStyle
) -> None:
    assert_consistent(read(typed, unit, style, convention), typed)


def assert_consistent(reading: Reading, typed: str) -> None:
    assert reading.typed == typed
    assert (reading.kind == "number") is (reading.value is not None) is bool(reading.read_as)
    assert (reading.kind in ("unreadable", "wrong unit")) is bool(reading.reason)
    assert len(said(reading.reason)) < 2000
    assert "\n" not in said(reading.reason)
