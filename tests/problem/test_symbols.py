"""Symbols as authors write them: what every back end can set, and what none may meet."""

from __future__ import annotations

import pytest

from kinegrade.problem.symbols import find_symbol_fault


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
