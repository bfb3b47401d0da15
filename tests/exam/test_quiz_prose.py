"""Prose as HTML: nothing becomes a tag that was none, formulas are such as MathJax sets."""

from __future__ import annotations

from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import TypesetError
from kinegrade.exam.quiz_prose import (
    write_math_html,
    write_plain_html,
    write_prose_html,
    write_unit_html,
)


def element(html: str) -> ElementTree.Element:
    """HTML as XML, which it is too."""
    return ElementTree.fromstring(f"<div>{html}</div>")


@given(st.text())
def test_a_plain_text_is_itself(text: str) -> None:
    shown = "".join(element(write_plain_html(text)).itertext())
    assert len(shown) == len(text)
    assert all(new in (old, " ") for new, old in zip(shown, text.replace("\r", " "), strict=True))


@given(st.text())
def test_prose_is_well_formed_or_refused(text: str) -> None:
    try:
        tree = element(write_prose_html(text))
    except TypesetError:
        return
    assert {part.tag for part in tree.iter()} <= {
        "div",
        "p",
        "strong",
        "em",
        "ul",
        "ol",
        "li",
        "br",
    }


def test_paragraphs_lists_and_emphasis() -> None:
    html = write_prose_html("One **bold** *leaning*\nline.\n\n3. three\n4. four\n\n- a  \n  b\n")
    assert html == (
        '<p>One <strong>bold</strong> <em>leaning</em> line.</p>\n<ol start="3">\n<li>three</li>\n'
        "<li>four</li>\n</ol>\n<ul>\n<li>a<br/>\nb</li>\n</ul>\n"
    )
    assert write_prose_html("曲柄\n转动", inline=True) == "曲柄转动"


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
    assert write_prose_html("$$v = 1$$") == r"\[v = 1\]"
    assert write_math_html("v", display=True) == r"\[v\]"


@pytest.mark.parametrize("latex", [r"\input{x}", r"\href{javascript:1}", "<#b>", r"\frac{1}{2"])
def test_what_is_no_math_is_refused(latex: str) -> None:
    with pytest.raises(TypesetError, match=r"^q1: formula "):
        write_math_html(latex, "q1")


def test_what_no_press_prints_is_refused_here_too() -> None:
    with pytest.raises(TypesetError, match="^q1: raw HTML .* cannot be printed"):
        write_prose_html("<script>alert(1)</script>", "q1")


def test_units_have_raised_exponents() -> None:
    assert write_unit_html("m/s^2") == "m/s<sup>2</sup>"
    assert write_unit_html("m*s^-2") == "m·s<sup>−2</sup>"
    assert [write_unit_html(unit) for unit in ("1", "deg")] == ["", "°"]
    assert write_unit_html("<b>") == "&lt;b&gt;"
