"""Formulas and units as HTML: such as MathJax sets, and nothing becomes a tag that was none."""

from __future__ import annotations

from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import TypesetError
from kinegrade.language.html_text import (
    write_display_html,
    write_math_html,
    write_plain_html,
    write_unit_html,
)
from kinegrade.language.math.reading import read_math


def element(html: str) -> ElementTree.Element:
    """HTML as XML, which it is too."""
    return ElementTree.fromstring(f"<div>{html}</div>")


@given(st.text())
def test_a_plain_text_is_itself(text: str) -> None:
    shown = "".join(element(write_plain_html(text)).itertext())
    assert len(shown) == len(text)
    assert [
        (new, old)
        for new, old in zip(shown, text.replace("\r", " "), strict=True)
        if new not in (old, " ")
    ] == []


@pytest.mark.parametrize(
    ("latex", "written"),
    [
        (r"r = 0.25\,\unit{m}", r"\(r = 0.25\,\mathrm{m}\)"),
        (r"\unit{rad/s^2}", r"\(\mathrm{rad/s^{2}}\)"),
        (r"a = 3\,\unit{m*s^-2}", r"\(a = 3\,\mathrm{m{\cdot}s^{-2}}\)"),
        (r"\varphi = 30\,\unit{deg}", r"\(\varphi = 30\,{}^{\circ}\)"),
        (r"\text{顺时针 m/s^2}", r"\(\text{顺时针 m/s²}\)"),
        (r"\bm{v} + \boldsymbol{a}", r"\(\boldsymbol{v} + \boldsymbol{a}\)"),
        ("1{,}5", "\\(1{,}5\\)"),
        ("a < b", r"\(a &lt; b\)"),
    ],
)
def test_formulas_are_such_as_mathjax_sets(latex: str, written: str) -> None:
    assert write_math_html(latex) == written


def test_a_formula_on_its_own_line() -> None:
    assert write_display_html(read_math("v", "q1")) == r"\[v\]"


@pytest.mark.parametrize("latex", [r"\input{x}", r"\href{javascript:1}", "<#b>", r"\frac{1}{2"])
def test_what_is_no_math_is_refused(latex: str) -> None:
    with pytest.raises(TypesetError, match=r"^q1: formula "):
        write_math_html(latex, "q1")


def test_units_have_raised_exponents() -> None:
    assert write_unit_html("m/s^2") == "m/s<sup>2</sup>"
    assert write_unit_html("m*s^-2") == "m·s<sup>−2</sup>"
    assert [write_unit_html(unit) for unit in ("1", "deg")] == ["", "°"]
    assert write_unit_html("<b>") == "&lt;b&gt;"
