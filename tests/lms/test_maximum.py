"""What an item counts: the exam's points, or grades are scaled because somebody asked for it."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.errors import TableError
from kinegrade.language import Language
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.systems.brightspace import BRIGHTSPACE
from kinegrade.lms.grades.systems.generic import GENERIC
from kinegrade.lms.grades.systems.sakai import SAKAI
from tests.lms.marked_folder import changed, filled, fresh, grades_of

ITEMS = "Student ID,Name,Midterm [20],Midterm q1 [7],Midterm q2 [3]\n0012345,x,,,\n"


def test_a_given_maximum_scales_and_is_stated(tmp_path: Path) -> None:
    text = fresh(tmp_path, BRIGHTSPACE, ExportOptions(maximum=Fraction(100))).text
    header, first, *_ = text.splitlines()
    assert "MaxPoints:100>" in header
    assert first == "#0012345,82.5,#"


def test_a_maximum_that_the_file_denies_is_refused(tmp_path: Path) -> None:
    with pytest.raises(
        TableError,
        match='"Midterm \\[20\\]": counts 20 there, --maximum says 50 - expected the same',
    ):
        filled(tmp_path, SAKAI, ITEMS, ExportOptions(columns={"": "Midterm"}, maximum=Fraction(50)))


def test_scaling_needs_a_maximum(tmp_path: Path) -> None:
    with pytest.raises(
        TableError, match='"成绩": states no maximum - expected one to scale to - give the item'
    ):
        fresh(tmp_path, GENERIC, ExportOptions(scale=True, language=Language("zh")))


def test_questions_go_to_the_items_of_their_titles(tmp_path: Path) -> None:
    filled(tmp_path, SAKAI, ITEMS, ExportOptions(title="Midterm", per_question=True))
    assert changed(tmp_path) == {(2, "Midterm q1 [7]"): "7", (2, "Midterm q2 [3]"): "1.25"}


def test_questions_go_to_the_items_that_are_named(tmp_path: Path) -> None:
    columns = {"q1": "Midterm q1 [7]", "q2": "Midterm q2"}
    filled(tmp_path, SAKAI, ITEMS, ExportOptions(columns=columns, per_question=True))
    assert changed(tmp_path) == {(2, "Midterm q1 [7]"): "7", (2, "Midterm q2 [3]"): "1.25"}


def test_all_faults_of_columns_are_told_at_once(tmp_path: Path) -> None:
    with pytest.raises(TableError) as caught:
        filled(tmp_path, SAKAI, ITEMS, ExportOptions(per_question=True))
    assert [problem.split(" - ")[0] for problem in caught.value.problems] == [
        "download.csv: no grade columns for question q1",
        "download.csv: no grade columns for question q2",
    ]
    with pytest.raises(TableError, match="is meant for several questions - expected one for each"):
        filled(
            tmp_path,
            SAKAI,
            ITEMS,
            ExportOptions(columns={"q1": "Midterm", "q2": "Midterm"}, per_question=True),
        )
    with pytest.raises(
        TableError, match='no column "Midtern" - expected one of the file - did you mean "Midterm'
    ):
        filled(tmp_path, SAKAI, ITEMS, ExportOptions(columns={"": "Midtern"}))
    with pytest.raises(
        TableError,
        match='2 columns are called "Midterm \\[20\\]" - expected one - rename the items',
    ):
        filled(
            tmp_path,
            SAKAI,
            ITEMS.replace("q1 [7]", "[20]").replace("Midterm [20]", "Midterm [20]"),
            ExportOptions(columns={"": "Midterm [20]"}),
        )


def test_a_header_can_state_one_maximum_only(tmp_path: Path) -> None:
    from dataclasses import replace

    import msgspec

    from kinegrade.lms.grades.from_scratch import new_file

    grades = grades_of(tmp_path)
    first, *others = grades.students
    less = msgspec.structs.replace(
        first, points={**first.points, "": Fraction(1)}, out_of={**first.out_of, "": Fraction(5)}
    )
    mixed = replace(grades, students=(less, *others))
    with pytest.raises(
        TableError,
        match="not all students could get the same points - expected one maximum - give it with",
    ):
        new_file(SAKAI, mixed, ExportOptions())
    lines = new_file(
        SAKAI, mixed, ExportOptions(maximum=Fraction(10), feedback=False)
    ).text.splitlines()
    assert lines[1] == "0012345,王伟,2"
