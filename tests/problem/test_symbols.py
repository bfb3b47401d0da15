"""Symbols as authors write them: what every back end can set, and what none may meet."""

from __future__ import annotations

import pytest

from kinegrade.errors import TypesetError
from kinegrade.figure.back_ends.required_symbol import require_symbol
from kinegrade.problem.template.notation import write_symbol
from kinegrade.problem.template.symbols import find_symbol_fault


@pytest.mark.parametrize(
    "symbol",
    [
        "{a_1 b}_2",
        "l",
        "k r",
        r"\omega_{AB}",
        r"\varphi",
        "O_1'",
        r"\mathrm{II}",
        r"\sqrt{3} r",
        r"\frac{l}{2}",
        r"\left|x_B\right|",
        r"\omega_{BC}/\omega_{AB}",
        r"a_{B,\perp BO}",
        r"\angle(v_{A}, v_{B})",
    ],
)
def test_what_statements_use_is_a_symbol(symbol: str) -> None:
    assert find_symbol_fault(symbol) is None


@pytest.mark.parametrize(
    "symbol",
    [
        "",
        "$r$",
        '"x"',
        "#x",
        r"\\",
        r"\text{a}",
        "{",
        "}{",
        "_1",
        "a^",
        r"\sqrt",
        r"x\frac{a}",
        "a_1_2",
        r"\vec",
        "é",
    ],
)
def test_what_could_lead_a_typesetter_astray_is_none(symbol: str) -> None:
    assert find_symbol_fault(symbol) is not None


@pytest.mark.parametrize(
    ("symbol", "message"),
    [
        (
            " ",
            r"a blank symbol - write LaTeX math without dollar signs, such as '\omega_{AB}'",
        ),
        (
            "$r$",
            '"$r$" has characters no symbol needs - use letters, digits, _ ^ { } \' and LaTeX '
            "commands",
        ),
        (r"\omgea", r"unknown LaTeX command \omgea - did you mean "),
        (r"\text{a}", r"unknown LaTeX command \text{a} - "),
        (
            "a^",
            '"a^" is incomplete - close every brace, give every _ and ^ one thing',
        ),
    ],
)
def test_what_is_no_symbol_is_refused_by_its_fault(symbol: str, message: str) -> None:
    with pytest.raises(TypesetError) as refusal:
        require_symbol(symbol)
    assert message in str(refusal.value)


@pytest.mark.parametrize(
    ("name", "symbol"),
    [
        ("xO6", "x_{O_{6}}"),
        ("lAB", "l_{AB}"),
        ("omegaOA", r"\omega_{OA}"),
        ("sigma", r"\sigma"),
        ("lambda", r"\lambda"),
        ("epsilon_2", r"\varepsilon_{2}"),
        ("Delta", r"\Delta"),
        ("k_BC", "k_{BC}"),
        ("OA", "OA"),
    ],
)
def test_a_name_is_printed_as_a_symbol_with_its_subscript(name: str, symbol: str) -> None:
    assert write_symbol(name) == symbol
    assert find_symbol_fault(symbol) is None
