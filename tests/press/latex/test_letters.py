"""Names in the letters of other scripts, set by LaTeX."""

from __future__ import annotations

from dataclasses import replace
from io import BytesIO

from pypdf import PdfReader

from kinegrade.exam.roster.complaints import find_unprintable
from kinegrade.exam.roster.students import Student
from kinegrade.press.latex.press import LatexPress
from tests.press.papers import ENGLISH
from tests.said import all_said


def test_names_of_greek_and_cyrillic_letters_keep_their_spaces() -> None:
    """Those of xeCJK's class of Chinese characters lose plain ones."""
    name = "Пётр Ильич Чайковский Γιωργος Ομηρος"
    made = LatexPress().papers({"s": replace(ENGLISH, name=name)})["s"]
    assert name in PdfReader(BytesIO(made.pdf)).pages[0].extract_text()


def test_characters_that_the_usual_typesetter_prints_are_said_to_be_so() -> None:
    students = [Student("1", "Γιώργος", "", "1"), Student("2", "Bo 😀", "", "2")]
    found = all_said(find_unprintable(students, "roster.csv", LatexPress()))
    assert ["--engine typst" in line for line in found] == [True, False]
