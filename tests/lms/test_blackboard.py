"""Blackboard: columns known by the id behind the bar, downloads separated by commas or tabs, in
UTF-8 or UTF-16.
"""

from __future__ import annotations

import codecs
from pathlib import Path

import pytest

from kinegrade.errors import TableError
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.systems.blackboard import BLACKBOARD
from tests.golden_files import Hold
from tests.lms.marked_folder import changed, filled, fresh

QUIZ = "Kinematics quiz [Total Pts: 10 Score] |664617"
HEADER = (
    "Last Name",
    "First Name",
    "Username",
    "Student ID",
    "Last Access",
    "Availability",
    QUIZ,
    "Total [Total Pts: up to 110 Score] |664600",
    "Letter [Total Pts: 0 Text] |664601",
)
ROWS = (
    ("王", "伟", "wangwei", "0012345", "", "Yes", "", "", ""),
    ("O'Neil", "Zoë", "zoneil", "0012346", "", "Yes", "3", "", ""),
    ("Nobody", "", "nobody", "0012347", "", "Yes", "5", "", ""),
    ("Blank", "Some", "sblank", "0012348", "", "Yes", "", "", ""),
)


def table(separator: str, quote: str, end: str) -> str:
    return "".join(
        separator.join(f"{quote}{cell}{quote}" for cell in line) + end for line in (HEADER, *ROWS)
    )


@pytest.mark.parametrize(
    ("content", "beginning"),
    [
        (table(",", '"', "\n").encode("utf-8-sig"), b'\xef\xbb\xbf"Last'),
        (table("\t", '"', "\r\n").encode("utf-16"), codecs.BOM_UTF16_LE + b'"\0'),
        (
            codecs.BOM_UTF16_BE + table("\t", "", "\n").encode("utf-16-be"),
            codecs.BOM_UTF16_BE + b"\0L",
        ),
        (table("\t", "", "\r\n").encode(), b"Last Name\t"),
    ],
)
def test_every_variant_comes_back_as_it_was(
    tmp_path: Path, content: bytes, beginning: bytes
) -> None:
    result = filled(tmp_path, BLACKBOARD, content)
    assert changed(tmp_path) == {(2, QUIZ): "8.25", (3, QUIZ): "4", (5, QUIZ): "9.6667"}
    assert result.content.startswith(beginning)
    assert result.complaints == ()


def test_the_golden_file(tmp_path: Path, hold: Hold) -> None:
    hold("lms/blackboard.csv", fresh(tmp_path, BLACKBOARD, ExportOptions(columns={"": QUIZ})).text)


@pytest.mark.parametrize(
    "header", ["Kinematics quiz", "Kinematics quiz [Total Pts: 10 Score]", HEADER[8]]
)
def test_a_column_without_an_id_would_become_a_text_column_of_no_points(
    tmp_path: Path, header: str
) -> None:
    with pytest.raises(
        TableError, match="is no header of a grade column there - expected it with the id that"
    ):
        fresh(tmp_path, BLACKBOARD, ExportOptions(columns={"": header}))


def test_a_column_that_nobody_named_is_asked_for(tmp_path: Path) -> None:
    with pytest.raises(
        TableError,
        match="Blackboard: the column for the total is not named - expected its header, with the "
        "id that",
    ):
        fresh(tmp_path, BLACKBOARD)


def test_a_header_states_the_maximum(tmp_path: Path) -> None:
    other = QUIZ.replace("10", "100")
    with pytest.raises(TableError, match="counts 100 there, 10 in the exam"):
        fresh(tmp_path, BLACKBOARD, ExportOptions(columns={"": other}))
    scaled = fresh(
        tmp_path, BLACKBOARD, ExportOptions(columns={"": other}, scale=True, feedback=False)
    ).text
    assert scaled.splitlines()[:2] == [f'"Username","{other}"', '"0012345","82.5"']


def test_a_file_of_one_column_takes_feedback_and_its_format(tmp_path: Path) -> None:
    comments = '"Grading Notes","Notes Format","Feedback to Learner","Feedback Format"'
    filled(
        tmp_path,
        BLACKBOARD,
        f'"Username","{QUIZ}",{comments}\n"0012345","","mine","SMART_TEXT","",""\n',
    )
    assert changed(tmp_path) == {
        (2, QUIZ): "8.25",
        (2, "Feedback to Learner"): "1: 7/7; 2: 1.25/3",
        (2, "Feedback Format"): "PLAIN_TEXT",
    }
