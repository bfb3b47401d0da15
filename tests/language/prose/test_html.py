"""Prose as HTML: nothing becomes a tag that was none."""

from __future__ import annotations

from xml.etree import ElementTree

from hypothesis import given
from hypothesis import strategies as st

from kinegrade.errors import TypesetError
from kinegrade.language.prose.html import write_line, write_prose


def element(html: str) -> ElementTree.Element:
    """HTML as XML, which it is too."""
    return ElementTree.fromstring(f"<div>{html}</div>")


@given(st.text())
def test_prose_is_well_formed_or_refused(text: str) -> None:
    try:
        tree = element(write_prose(text, "q1"))
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
    html = write_prose("One **bold** *leaning*\nline.\n\n3. three\n4. four\n\n- a  \n  b\n", "q1")
    assert html == (
        '<p>One <strong>bold</strong> <em>leaning</em> line.</p>\n<ol start="3">\n<li>three</li>\n'
        "<li>four</li>\n</ol>\n<ul>\n<li>a<br/>\nb</li>\n</ul>\n"
    )
    assert write_line("曲柄\n转动", "q1") == "曲柄转动"


def test_a_formula_on_its_own_line() -> None:
    assert write_prose("$$v = 1$$", "q1") == r"\[v = 1\]"
