"""A question on screen: the texts of its sheet are texts, whatever they hold."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from xml.etree import ElementTree

from kinegrade.description.said import Description
from kinegrade.language import ENGLISH
from kinegrade.press.html.question import write_description, write_row, write_statement
from kinegrade.press.sheet import AnswerRow
from kinegrade.worked.document import Prose
from tests.press.papers import ENGLISH_QUESTION
from tests.press.solutions import polygon_scene


def test_the_figure_is_described_in_any_characters() -> None:
    described = Description('"Crank" & <more>', (Prose("$r < 1$, *long*"), Prose("B & C")))
    sheet = replace(ENGLISH_QUESTION, figure=polygon_scene(), described=described)
    html = write_statement(sheet, 'a"b.svg')
    (picture,) = ElementTree.fromstring(f"<div>{html}</div>").iter("img")
    assert picture.attrib["src"] == 'a"b.svg'
    assert picture.attrib["alt"] == '"Crank" & <more>'
    assert picture.attrib["width"] == "280"


def test_the_long_text_unfolds_below_its_heading() -> None:
    described = Description("short", (Prose("$r < 1$, *long*"), Prose("B & C")))
    sheet = replace(ENGLISH_QUESTION, described=described)
    assert write_description(sheet, ENGLISH) == (
        "<details><summary>The figure in words</summary>\n"
        "<p>\\(r &lt; 1\\), <em>long</em></p>\n<p>B &amp; C</p>\n</details>\n"
    )
    assert write_description(ENGLISH_QUESTION, ENGLISH) == ""


def test_a_question_without_a_figure_is_its_statement() -> None:
    assert "<img" not in write_statement(ENGLISH_QUESTION, "a.svg")


def test_points_are_written_as_on_paper() -> None:
    row = AnswerRow("v_B", "speed of $B$", "m/s^2", "to the right", Fraction(1, 3))
    assert write_row(row, "q1", ENGLISH, "[ ]") == (
        "<p>Speed of \\(B\\) (to the right): \\(v_{B} =\\) [ ] m/s<sup>2</sup> (1/3 points)</p>\n"
    )
