"""Sakai: columns by position, points in brackets, comments behind a star, a byte-order mark or
names are garbled.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import TableError
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.systems.sakai import SAKAI
from tests.golden_files import Hold
from tests.lms.marked_folder import changed, filled, fresh

ITEM, COMMENT = "Kinematics quiz [10]", "* Kinematics quiz"
DOWNLOAD = (
    f"\ufeffStudent ID,Student Name,# Section,{ITEM},{COMMENT}\n"
    '0012345,"王, 伟",A,,\n0012346,"O\'Neil, Zoë",A,3,good\n0012348,"Blank, Some",A,,\n'
)


def test_the_golden_file_has_a_mark(tmp_path: Path, hold: Hold) -> None:
    text = fresh(tmp_path, SAKAI).text
    hold("lms/sakai.csv", text)
    assert text.encode().startswith(b"\xef\xbb\xbfStudent ID,")


def test_grades_and_comments_are_filled_in(tmp_path: Path) -> None:
    filled(tmp_path, SAKAI, DOWNLOAD)
    assert changed(tmp_path) == {
        (2, ITEM): "8.25",
        (2, COMMENT): "1: 7/7; 2: 1.25/3",
        (3, ITEM): "4",
        (3, COMMENT): "1: 4/7; 2: 0/3",
        (4, ITEM): "9.67",
        (4, COMMENT): "1: 6.6667/7; 2: 3/3",
    }


def test_a_file_of_semicolons_means_decimal_commas(tmp_path: Path) -> None:
    filled(
        tmp_path,
        SAKAI,
        DOWNLOAD.replace('"', "").replace(", ", " ").replace(",", ";").replace("[10]", "[10,0]"),
    )
    assert changed(tmp_path)[2, "Kinematics quiz [10,0]"] == "8,25"


@pytest.mark.parametrize("header", ["# Section", COMMENT, "Student Name"])
def test_other_columns_are_no_items(tmp_path: Path, header: str) -> None:
    with pytest.raises(TableError, match="is no column from which Sakai takes grades"):
        filled(tmp_path, SAKAI, DOWNLOAD, ExportOptions(columns={"": header}))


@pytest.mark.parametrize(
    ("title", "reason"),
    [
        ("Quiz [1]", "Sakai reads what follows \\[ as the points"),
        ("# quiz", "signs of other columns"),
        ("* quiz", "signs of other columns"),
    ],
)
def test_titles_that_sakai_reads_otherwise_are_refused(
    tmp_path: Path, title: str, reason: str
) -> None:
    with pytest.raises(TableError, match=reason):
        fresh(tmp_path, SAKAI, ExportOptions(title=title))
