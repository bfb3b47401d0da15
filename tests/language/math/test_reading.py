r"""A formula that cannot be read to its end is refused with what is missing."""

from __future__ import annotations

import pytest

from kinegrade.errors import TypesetError
from kinegrade.language.math.reading import read_math

_TOO_DEEP = "is nested too deeply - expected at most 40 levels - write it flatter"


@pytest.mark.parametrize(
    ("latex", "message"),
    [
        (
            "{" * 40 + "}" * 40,
            "is nested too deeply - expected at most 40 levels - write it flatter",
        ),
        (r"\left(a", r"\left without \right - expected a \right for it - add it"),
        (r"a\right)", r"\right without \left - expected a \left for it - add it"),
        (r"\sqrt[3{a}", r"\sqrt[ without ] - expected a ] for it - add it"),
        (
            r"\left a \right)",
            r"\left without a bracket - expected a bracket, or a point for none - write \left( or "
            r"\left.",
        ),
        (
            r"\left( a \right b",
            r"\right without a bracket - expected a bracket, or a point for none - write \right( "
            r"or \right.",
        ),
        ("a_", "_ with nothing after it - expected what it acts on - write _{...}"),
        (
            r"\frac{1}",
            r"\frac with nothing after it - expected what it acts on - write \frac{...}",
        ),
        (r"\begin{cases} a", "cannot be read - expected whole LaTeX math - fix it"),
    ],
)
def test_what_is_missing_is_named(latex: str, message: str) -> None:
    with pytest.raises(TypesetError) as refusal:
        read_math(latex, "q1")
    [problem] = refusal.value.problems
    assert problem.startswith("q1: formula $")
    assert problem.endswith(f"$: {message}")


@pytest.mark.parametrize("latex", ["{" * 39 + "}" * 39, r"\sqrt " * 39 + "a", "a" + "_1" * 40])
def test_a_formula_may_have_as_many_levels_as_a_refusal_says(latex: str) -> None:
    assert read_math(latex, "q1")
