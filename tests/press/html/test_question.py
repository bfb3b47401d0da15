"""A question on screen: the texts of its sheet are texts, whatever they hold."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from xml.etree import ElementTree

from kinegrade.language import ENGLISH
from kinegrade.press.html.question import write_row, write_statement
from kinegrade.press.sheet import AnswerRow
from tests.press.papers import ENGLISH_QUESTION
from tests.press.solutions import polygon_scene


def test_the_figure_is_described_in_any_characters() -> None:
    sheet = replace(ENGLISH_QUESTION, title='"Crank" & <more>', figure=polygon_scene())
    html = write_statement(sheet, 'a"b.svg', ENGLISH)
    (picture,) = ElementTree.fromstring(f"<div>{html}</div>").iter("img")
    assert picture.attrib["src"] == 'a"b.svg'
    assert picture.attrib["alt"] == 'Figure to scale: "Crank" & <more>'
    assert picture.attrib["width"] == "280"


def test_a_question_without_a_figure_is_its_statement() -> None:
    assert "<img" not in write_statement(ENGLISH_QUESTION, "a.svg", ENGLISH)


def test_points_are_written_as_on_paper() -> None:
    row = AnswerRow("v_B", "speed of $B$", "m/s^2", "to the right", Fraction(1, 3))
    assert write_row(row, "q1", ENGLISH, "[ ]") == (
        "<p>Speed of \\(B\\) (to the right): \\(v_{B} =\\) [ ] m/s<sup>2</sup> (1/3 points)</p>\n"
    )
