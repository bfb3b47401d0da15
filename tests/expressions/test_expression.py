"""Reading arithmetic: the grammar by examples, and that nothing else than an ExpressionError ever
comes out.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import ExpressionError
from kinegrade.expressions.angular import find_angular_degree, is_angle
from kinegrade.expressions.evaluation import evaluate, make_elementary_functions
from kinegrade.expressions.reading import MAX_DEPTH, MAX_LENGTH, read_expression, read_rational
from kinegrade.expressions.tree import Call, Name, Number, Operation, find_names
from kinegrade.mechanics.geometry import make_constructions
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.balls import Balls
from kinegrade.numbers.doubles import Doubles
from kinegrade.numbers.field import Field
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.noting.noting import Noting
from kinegrade.numbers.noting.pad import Pad
from kinegrade.numbers.refusals import Inexact
from kinegrade.numbers.text import write_angle, write_exact

KNOWN = {"r": fmpq(3, 2), "k": fmpq(2)}


def value(text: str) -> str:
    """What an expression comes to, as exact text; angles in radians."""
    field = Field()
    number = evaluate(
        read_expression(text),
        {**KNOWN, "pi": field.turns(1), "phi": field.turns(fmpq(1, 3))},
        make_elementary_functions(field),
        field,
    )
    return write_angle(number, degrees=False) if isinstance(number, Angle) else write_exact(number)


@pytest.mark.parametrize(
    ("text", "result"),
    [
        ("1 + 2*3", "7"),
        ("(1 + 2)*3", "9"),
        ("7 - 2 - 1", "4"),
        ("8/4/2", "1"),
        ("2/3*3", "2"),
        ("-2**2", "-4"),
        ("(-2)**2", "4"),
        ("2**-2", "1/4"),
        ("--3", "3"),
        ("-+-+3", "3"),
        ("2*-3", "-6"),
        ("- 3 + 5", "2"),
        ("0.1 + 0.2", "3/10"),
        (".5", "1/2"),
        ("5.", "5"),
        ("1e3", "1000"),
        ("1.5E-2", "3/200"),
        ("2e+1", "20"),
        ("r*k", "3"),
        ("r/k - 1/4", "1/2"),
        ("k**3", "8"),
        ("+r", "3/2"),
        ("0 - r", "-3/2"),
        ("sqrt(2)*sqrt(6)", "2*sqrt(3)"),
        ("sqrt(1/2)", "sqrt(2)/2"),
        ("abs(1 - sqrt(2))", "sqrt(2) - 1"),
        ("sin(phi)", "sqrt(3)/2"),
        ("cos(pi/4)", "sqrt(2)/2"),
        ("tan(phi/2)", "sqrt(3)/3"),
        ("sin(0)", "0"),
        ("asin(1/2)", "pi/6"),
        ("acos(-1/2)", "2*pi/3"),
        ("atan(1)", "pi/4"),
        ("atan2(1, -1)", "3*pi/4"),
        ("atan2(0, -1)", "pi"),
        ("cos(2*atan(1/2))", "3/5"),
        ("180*phi/pi", "60"),
        ("pi - 2*phi", "pi/3"),
        ("sin(atan(3/4) + pi/2)", "4/5"),
        (" 1\t+\n1 ", "2"),
    ],
)
def test_what_expressions_come_to(text: str, result: str) -> None:
    assert value(text) == result


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", '"", character 1: found the end, expected a number, a name or a bracket'),
        ("1 +", '"1 +", character 4: found the end, expected a number, a name or a bracket'),
        ("1 2", '"1 2", character 3: found "2", expected an operator or the end'),
        ("left of A B", '"left of A B", character 11: found "B", expected an arrow from point'),
        ("left of 2->B", '"left of 2->B", character 9: found "2", expected the name of a point'),
        ("2x", '"2x", character 2: found "x", expected an operator or the end'),
        ("(1", '"(1", character 3: found the end, expected "," or ")"'),
        ("1)", '"1)", character 2: found ")", expected an operator or the end'),
        (
            "(1, 2, 3)",
            '"(1, 2, 3)", character 10: found the end, expected one value or a pair (x, y) in the '
            "brackets before",
        ),
        ("x.y", '"x.y", character 2: found ".", expected an operator or the end'),
        ("a[0]", '"a[0]", character 2: found "[", expected an operator or the end'),
        ("lambda: 1", '"lambda: 1", character 7: found ":", expected an operator or the end'),
        (
            "1 if 1 else 2",
            '"1 if 1 else 2", character 3: found "if", expected an operator or the end',
        ),
        ("r^2", '"r^2", character 2: found "^", expected a power written as **'),
        ("r²", '"r²", character 2: found "²", expected a square written as **2'),
        (
            "30°",
            '"30°", character 3: found "°", expected the number alone where the unit is deg, '
            "and parts of pi elsewhere: 30 degrees is pi/6",
        ),
        ("x == y", '"x == y", character 3: found "=", expected an operator or the end'),
        ("'a'", '"\'a\'", character 1: found "\'", expected a number, a name or a bracket'),
        ("1 // 2", '"1 // 2", character 4: found "/", expected a number, a name or a bracket'),
        ("x := 1", '"x := 1", character 3: found ":", expected an operator or the end'),
        ("1\x00", '"1·", character 2: found "·", expected an operator or the end'),
        ("1 +\n;", '"1 +·;", character 5: found ";", expected a number, a name or a bracket'),
        ("٣", '"٣", character 1: found "٣", expected a number, a name or a bracket'),
        ("１", '"１", character 1: found "１", expected a number, a name or a bracket'),
        ("1_000", '"1_000", character 2: found "_000", expected an operator or the end'),
        ("0x10", '"0x10", character 2: found "x10", expected an operator or the end'),
        ("1e999", '"1e999", character 5: found "9", expected an operator or the end'),
        ("(" * 60 + "1" + ")" * 60, "nested deeper than 40: write it more simply"),
        ("1+" * 300 + "1", "an expression of 601 characters: at most 400 are read"),
        ("9" * 61, "99999999999999999999...: a number of more than 60 digits: round it"),
    ],
)
def test_what_is_no_expression_is_told_with_its_place(text: str, message: str) -> None:
    with pytest.raises(ExpressionError) as refusal:
        read_expression(text)
    assert message in str(refusal.value)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("q", 'unknown name "q": known here: k, phi, pi, r'),
        ("ph", 'unknown name "ph": did you mean "phi"? (known here: k, phi, pi, r)'),
        ("__class__", 'unknown name "__class__"'),
        ("__import__(1)", 'unknown function "__import__"'),
        ("eval(1)", 'unknown function "eval"'),
        ("sine(phi)", 'unknown function "sine": did you mean "sin" or "asin"?'),
        ("(1, 2)", "a pair (x, y): expected a number or an angle here"),
        (
            "sin()",
            "sin cannot be made from the arguments in its brackets: check their number, order and kind",
        ),
        ("sqrt(1, 2)", "sqrt cannot be made from the arguments in its brackets"),
        ("sqrt(pi)", "sqrt cannot be made from the arguments in its brackets"),
        ("sqrt(-1)", "sqrt(...): square root of a negative number: check the values given"),
        ("asin(2)", "asin(...): square root of a negative number: check the values given"),
        ("atan2(0, 0)", "atan2(...): the direction of a zero vector: check the values given"),
        ("tan(pi/2)", "tan(...): division by zero: check the values given"),
        ("1/0", "division by zero: check the values given"),
        ("1/(sqrt(2)*sqrt(2) - 2)", "division by zero"),
        ("0**-1", "division by zero"),
        ("phi + 1", '"+" between things that do not go together: angles go with angles'),
        ("1 - phi", '"-" between things that do not go together'),
        ("2**k", "a power must be a whole number of at most 16: for roots write sqrt(...)"),
        ("2**0.5", "a power must be a whole number of at most 16"),
        ("2**17", "a power must be a whole number of at most 16"),
        ("9**9**9", "a power must be a whole number of at most 16"),
        ("2**-17", "a power must be a whole number of at most 16"),
    ],
)
def test_what_cannot_be_worked_out_is_told(text: str, message: str) -> None:
    with pytest.raises(ExpressionError) as refusal:
        value(text)
    assert message in str(refusal.value)
    assert "\n" not in str(refusal.value)


def test_a_point_has_no_power() -> None:
    field, values = Field(), {"A": Vector(fmpq(1), fmpq(2))}
    with pytest.raises(ExpressionError, match="only a number can be raised to a power"):
        evaluate(read_expression("A**2"), values, {}, field)


def test_the_square_of_an_angle_is_a_number() -> None:
    assert (value("phi**2"), value("phi*pi")) == ("pi**2/9", "pi**2/3")


@pytest.mark.parametrize(
    "text",
    [
        "((((9**16)**16)**16)**16)**16",
        "(((((9**16)**16)**16)**16)**16)**16*0",
        "((((1 + sqrt(2))**16)**16)**16)**16",
        "(1e99**16)**-16",
    ],
)
def test_towers_of_powers_do_not_fill_the_memory(text: str) -> None:
    with pytest.raises(Inexact):
        value(text)
    balls = Balls(256)
    with balls.context():
        assert isinstance(
            evaluate(read_expression(text), {}, make_elementary_functions(balls), balls), arb
        )
    floats = Floats()
    with floats.context(), pytest.raises(ExpressionError, match="too large for a double"):
        evaluate(read_expression("1e99**16"), {}, make_elementary_functions(floats), floats)


PIECES = st.sampled_from(
    [
        "1",
        "2.5",
        "r",
        "phi",
        "pi",
        "(",
        ")",
        ",",
        "+",
        "-",
        "*",
        "/",
        "**",
        "sqrt(",
        "sin(",
        "atan2(",
        " ",
        "__",
        ".",
        "x",
        "1e9",
        "meet(",
        "line(",
        "circle(",
        "O",
        "right",
        "polar(",
        "distance(",
    ]
)


@given(st.one_of(st.text(max_size=60), st.lists(PIECES, max_size=25).map("".join)))
def test_any_text_gives_a_value_or_one_line_that_says_why_not(text: str) -> None:
    field = Field()
    known = {**KNOWN, "pi": field.turns(1), "phi": field.turns(fmpq(1, 3)), "right": "right"}
    points: dict[str, Any] = {}
    functions = {**make_elementary_functions(field), **make_constructions(field, points)}
    known["O"] = points["O"] = functions[""](fmpq(0), fmpq(1))
    with suppress(Inexact):
        problems = problems_of(lambda: evaluate(read_expression(text), known, functions, field))
        assert len(problems) <= 1
        assert [problem for problem in problems if not (problem and "\n" not in problem)] == []


def problems_of(make: Callable[[], Any]) -> tuple[str, ...]:
    """The problems that an ExpressionError tells; none when a value comes out."""
    try:
        make()
    except ExpressionError as error:
        return error.problems
    return ()


TREES = st.recursive(
    st.one_of(st.integers(0, 99).map(str), st.sampled_from(["r", "k"])),
    lambda inner: st.one_of(
        st.tuples(inner, st.sampled_from("+-*"), inner).map(lambda parts: f"({' '.join(parts)})"),
        inner.map(lambda part: f"-{part}"),
        inner.map(lambda part: f"abs({part})"),
    ),
    max_leaves=12,
)


@given(TREES)
def test_sums_and_products_come_to_what_python_makes_of_them(text: str) -> None:
    field = Field()
    number = evaluate(read_expression(text), KNOWN, make_elementary_functions(field), field)
    assert number == eval(text, {"__builtins__": {"abs": abs}}, dict(KNOWN))


# r, s and the coordinates of A, an entry for each instance
COLUMNS = ((0.3, 0.25, 0.4), (0.12, 0.15, 0.1), (0.8, -0.7, 1.1), (0.4, 0.9, -0.35))


@pytest.mark.parametrize(
    "text",
    [
        *("s*(A - O)", "(A - O)*s", "(A - O)/s", "-s*(A - O)", "2*(A - O)", "(A - O)/2"),
        *("s/r*(A - O)", "(A - O)*s/r", "s*(A - O)/r", "O + s/r*(A - O)", "1/r*A", "s**2*A"),
        *("turned(A - O)", "s*turned(A - O)", "turned(A - O)*s", "turned(A - O)/s"),
        *("turned(s*(A - O))", "s*turned(A - O)/r", "cos(s)*(A - O)", "(A - O)*cos(s)"),
        *("abs(s)*(A - O)", "(r - s)*(A - O)*s", "s*(r*(A - O))", "0*s*A + A", "s*(2*O)"),
    ],
)
@pytest.mark.parametrize("count", [1, 2, 3])
def test_columns_of_numbers_come_to_what_they_do_one_by_one(text: str, count: int) -> None:
    """Numbers times vectors in either order, and vectors divided by them: in arrays of instances,
    in numbers on a pad, and for one instance after the other.
    """
    tree = read_expression(text)

    def work_out(arithmetic: Any, numbers: list[Any]) -> Vector:
        r, s, x, y = numbers
        values = {"r": r, "s": s, "O": Vector(0.5, 0.25), "A": Vector(x, y)}
        functions = make_elementary_functions(arithmetic) | make_constructions(arithmetic, {})
        result = evaluate(tree, values, functions, arithmetic)
        assert isinstance(result, Vector)
        return result

    columns = [np.array(column[:count]) for column in COLUMNS]
    singly = [work_out(Doubles(), list(row)) for row in zip(*columns, strict=True)]
    pad = Pad(4, count)
    noted = work_out(Noting(pad), [pad.write(column) for column in columns])
    for rank, coordinate in enumerate(zip(*singly, strict=True)):
        assert work_out(Floats(), columns)[rank] == pytest.approx(coordinate, rel=1e-14)
        assert noted[rank].value == pytest.approx(coordinate, rel=1e-14)


def test_the_tree_of_an_expression() -> None:
    assert read_expression("x") == Name("x")
    assert read_expression("2.50") == Number(fmpq(5, 2))
    assert read_expression("f(a, 1)") == Call("f", (Name("a"), Number(fmpq(1))))
    assert read_expression("f()") == Call("f", ())
    assert read_expression("(a, b)") == Call("", (Name("a"), Name("b")))
    assert read_expression("a - b - c") == Operation(
        "-", Operation("-", Name("a"), Name("b")), Name("c")
    )
    assert list(find_names(read_expression("a + f(b, (c, 1))*a"))) == ["a", "b", "c", "a"]
    assert read_expression("(" * MAX_DEPTH + "1" + ")" * MAX_DEPTH) == Number(fmpq(1))
    assert read_expression("1" + "+1" * ((MAX_LENGTH - 1) // 2))


@pytest.mark.parametrize(
    ("text", "degree"),
    [
        ("phi", 1),
        ("2*phi + pi", 1),
        ("pi/2", 1),
        ("180*phi/pi", 0),
        ("phi*phi", 2),
        ("1/phi", -1),
        ("r", 0),
        ("3", 0),
        ("-phi", 1),
        ("0 - pi", 1),
        ("atan(r)", 1),
        ("acos(1/2)/2", 1),
        ("sin(phi)", 0),
        ("abs(phi)", 1),
        ("abs(r)", 0),
        ("sqrt(phi)", 0),
        ("r**2", 0),
        ("abs()", 0),
        ("r*phi", 1),
    ],
)
def test_the_power_of_angle_in_an_expression(text: str, degree: int) -> None:
    assert find_angular_degree(read_expression(text), frozenset({"phi"})) == degree
    assert is_angle(read_expression(text), frozenset({"phi"})) == (degree == 1)


def test_decimals_are_read_as_exact_fractions() -> None:
    assert read_rational("0.1") == fmpq(1, 10)
    assert read_rational("1.25e1") == fmpq(25, 2)
    assert read_rational("3e-2") == fmpq(3, 100)
    assert read_rational(".5") == fmpq(1, 2)
    assert read_rational("7.") == 7


def test_messages_show_long_texts_whole_up_to_the_limit_only() -> None:
    with pytest.raises(ExpressionError) as refusal:
        read_expression("$" * MAX_LENGTH)
    assert len(str(refusal.value)) < MAX_LENGTH + 100
    assert re.search(r"character 1: found \"\$\"", str(refusal.value))
