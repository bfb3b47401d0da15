"""A long equation is broken only where a reader expects it."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.press.equation_line import EquationLine, split_equation_line


@pytest.mark.parametrize(
    ("latex", "left", "pieces"),
    [
        ("a &= b + c - d", "a", ("= b", "+ c", "- d")),
        ("a = b", "", ("a", "= b")),
        ("&= -3 + 4", "", ("= -3", "+ 4")),
        (r"x &= \sqrt{a + b = c} + 1", "x", (r"= \sqrt{a + b = c}", "+ 1")),
        (r"x &= \left(a + b\right)\cdot(c - d)", "x", (r"= \left(a + b\right)\cdot(c - d)",)),
        (r"x &= \left[a + (b - 1)\right] - 2", "x", (r"= \left[a + (b - 1)\right]", "- 2")),
        (r"x_+ &= 2\cdot -1", "x_+", (r"= 2\cdot -1",)),
        (r"x &\approx 2 \Rightarrow y", "x", (r"\approx 2", r"\Rightarrow y")),
        (
            r"\begin{aligned} a &= b \end{aligned} + 1",
            "",
            (r"\begin{aligned} a &= b \end{aligned}", "+ 1"),
        ),
        ("", "", ()),
    ],
)
def test_breaks_stand_before_relations_and_signs(
    latex: str, left: str, pieces: tuple[str, ...]
) -> None:
    assert split_equation_line(latex) == EquationLine(left, pieces)


@given(st.text(alphabet=r"ab=+-&{}()\ 1", max_size=40))
def test_nothing_is_lost(latex: str) -> None:
    line = split_equation_line(latex)
    kept = "".join((line.left, *line.pieces)).replace(" ", "").replace("&", "")
    assert kept == latex.replace(" ", "").replace("&", "")
