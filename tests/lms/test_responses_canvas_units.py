"""A Canvas quiz that asks for another unit than the paper does is marked as its students answered
it.
"""

from __future__ import annotations

import html
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from kinegrade.exam.quiz.document import Language
from kinegrade.files.assumed_unit import in_unit
from kinegrade.language.html_text import write_unit_html
from kinegrade.lms.responses.asked_units import asked_unit, on_the_line
from kinegrade.students.rounding.kept_decimals import list_finer_units
from tests.lms.quiz.packages import bare, files_of
from tests.lms.quiz.test_canvas_class import SPEED, STUDENTS, right_answers, set_exam
from tests.lms.response_files import cells, csv_text, responses
from tests.said import said
from tests.small_class import kinegrade, table

TAG = re.compile(r"<[^>]*>")
BEFORE = ("name", "id", "sis_id", "submitted")
MOMENT = "2026-05-01 20:01:01 UTC"


def headers(package: Path) -> Iterator[str]:
    """How Canvas heads the columns of a quiz's questions: their texts without tags."""
    for text in files_of(package).values():
        for shown in bare(text).iter("mattext") if "<item " in text else ():
            yield TAG.sub("", html.unescape(shown.text or ""))


@pytest.mark.parametrize("language", ["en", "zh"])
def test_answers_in_the_unit_of_the_quiz_are_right_on_the_way_back(
    tmp_path: Path, language: Language
) -> None:
    exam = set_exam(tmp_path, SPEED, STUDENTS[0])
    put = kinegrade("quiz", exam, "--to", "qti12", "--lang", language, "-o", tmp_path / "quiz.zip")
    assert put.exit_code == 1, put.stderr
    right = right_answers(exam, "v_y")
    for student, value, header in zip(
        ("S1", "S2"), right, headers(tmp_path / "quiz.zip"), strict=True
    ):
        file = tmp_path / f"{student}.csv"
        asked = (*BEFORE, f"101: {header}", "1.0", "n correct", "n incorrect", "score")
        row = ("x", "7", student, MOMENT, f"{1000 * value:.4f}", "1.0", "1", "0", "1.0")
        test_row = ("Student, Test", "9", "", MOMENT, "1.0000", "0.0", "0", "1", "0.0")
        file.write_text(csv_text(asked, row, test_row), encoding="utf-8")
        marks = tmp_path / f"MARKS-{student}"
        marked = kinegrade("grade", exam, file, "-o", marks, "--from", "canvas")
        assert "q1.v_y is in mm/s there, and converted" in marked.stderr
        assert "Canvas's test student is skipped" in marked.stderr
        found = {line["student"]: line["total"] for line in table(marks / "grades.csv")}
        assert found[student] == "1"


def test_a_question_in_the_paper_s_own_unit_stays_as_it_is(tmp_path: Path) -> None:
    header = (*BEFORE, "101: v = ? m/s", "1.0", "102: omega", "1.0", "103: a", "2.0")
    row = ("x", "7", "0012345", MOMENT, "4.2500", "1.0", "5", "1.0", "6", "2.0")
    read = responses(tmp_path, csv_text(header, row))
    assert cells(read)[1] == ("0012345", "4.2500", "5", "6")


@pytest.mark.parametrize("name", ["Student, Test", "Test Student"])
def test_the_student_that_canvas_invents_is_passed_over_and_a_real_one_is_not(
    tmp_path: Path, name: str
) -> None:
    header = (*BEFORE, "101: v", "1.0", "102: omega", "1.0", "103: a", "2.0")
    answers = ("4", "1.0", "5", "1.0", "6", "2.0")
    rows = [(name, "9", "", MOMENT, *answers), (name, "7", "S9", MOMENT, *answers)]
    read = responses(tmp_path, csv_text(header, *rows))
    assert cells(read)[1:] == [("S9", "4", "5", "6")]
    assert not read.table.complaints
    assert said(read.assumed[-1]).endswith("Canvas's test student is skipped")


@pytest.mark.parametrize("unit", ["m", "km", "cm/s", "m/s^2", "km/s", "cm/s^2"])
def test_the_unit_is_found_in_the_text_with_or_without_tags(unit: str) -> None:
    for finer, factor in list_finer_units(unit):
        shown = f"Mind the unit: {write_unit_html(finer)} here, not {write_unit_html(unit)}."
        expected = finer if factor > 1 else ""
        assert asked_unit(f"101: speed {shown}", unit) == expected
        assert asked_unit(f"101:\nspeed {TAG.sub('', shown)}\n", unit) == expected
        assert on_the_line(finer) == TAG.sub("", write_unit_html(finer))


@pytest.mark.parametrize(
    ("typed", "read"),
    [
        ("4.25", "4.25 mm/s"),
        (" -4,25 ", " -4,25  mm/s"),
        ("1.2e-3", "1.2e-3 mm/s"),
        ("", ""),
        ("four", "four"),
        ("4 cm/s", "4 cm/s"),
    ],
)
def test_only_a_bare_number_takes_the_unit_of_its_question(typed: str, read: str) -> None:
    assert in_unit(typed, "mm/s") == read
    assert in_unit(typed, "") == typed
