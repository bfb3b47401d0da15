"""A long equation is broken only where a reader expects it."""

from __future__ import annotations

import pytest
from hypothesis import given

from kinegrade.language.math.equation_line import split_equation_line
from kinegrade.language.math.latex import TEX, write_latex_row
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Mark, Row
from tests.language.math.formulas import TREES


@pytest.mark.parametrize(
    ("latex", "left", "pieces"),
    [
        ("a &= b + c - d", "a", ["= b", "+c", "-d"]),
        ("a = b", "", ["a", "= b"]),
        ("&= -3 + 4", "", ["= -3", "+4"]),
        (r"x &= \sqrt{a + b = c} + 1", "x", [r"= \sqrt{a + b = c}", "+1"]),
        (r"x &= \left(a + b\right)\cdot(c - d)", "x", [r"= \left(a + b\right) \cdot (c - d)"]),
        (r"x &= \left[a + (b - 1)\right] - 2", "x", [r"= \left[a + (b - 1)\right]", "-2"]),
        ("x &= (a + b)^2 - (c - d)_{1} + e", "x", ["= (a + b)^{2}", "-(c - d)_{1}", "+e"]),
        (r"x_+ &= 2\cdot -1", "x_{+}", [r"= 2 \cdot -1"]),
        (r"x &= 2\,+ 1 \pm +3", "x", [r"= 2\,", r"+1 \pm +3"]),
        (r"x &\approx 2 \Rightarrow y", "x", [r"\approx 2", r"\Rightarrow y"]),
        (
            r"\begin{aligned} a &= b \end{aligned} + 1",
            "",
            [r"\begin{aligned} a &= b \end{aligned}", "+1"],
        ),
        ("", "", []),
    ],
)
def test_breaks_stand_before_relations_and_signs(latex: str, left: str, pieces: list[str]) -> None:
    line = split_equation_line(read_math(latex, "line"))
    assert write_latex_row(line.left, TEX) == left
    assert [write_latex_row(piece, TEX) for piece in line.pieces] == pieces


@given(TREES)
def test_nothing_is_lost_but_the_mark(row: Row) -> None:
    line = split_equation_line(row)
    mark = (Mark(),) if Mark() in row else ()
    assert (*line.left, *mark, *(node for piece in line.pieces for node in piece)) == row
    assert [piece for piece in line.pieces if not piece] == []
