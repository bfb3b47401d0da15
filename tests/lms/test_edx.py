"""Open edX: its own two exports filled in, nothing from scratch."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import TableError
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.systems.edx import EDX
from tests.golden_files import Hold
from tests.lms.marked_folder import changed, filled, fresh

POINTS = (
    "user_id,username,full_name,student_uid,enrolled,track,cohort,block_id,title,date_last_graded,"
    "who_last_graded,Previous Points,New Points\n"
    "11,wangwei,王伟,0012345,True,,,b1,Quiz,,,3,\n12,zoneil,Zoë,0012346,True,,,b1,Quiz,,,,\n"
    "13,nobody,N,0012347,True,,,b1,Quiz,,,2,\n14,sblank,S,0012348,True,,,b1,Quiz,,,,\n"
)
OVERRIDES = (
    "user_id,username,student_key,course_id,track,cohort,name-1a2b3c4d,grade-1a2b3c4d,original_grade-1a2b3c4d,"
    "previous_override-1a2b3c4d,new_override-1a2b3c4d,new_override-99999999\n"
    "11,wangwei,0012345,c,,,Quiz,,,,,\n"
)


def test_new_points_are_filled_in(tmp_path: Path, hold: Hold) -> None:
    result = filled(tmp_path, EDX, POINTS)
    assert changed(tmp_path) == {
        (2, "New Points"): "8.25",
        (3, "New Points"): "4",
        (5, "New Points"): "9.6667",
    }
    hold("lms/edx.csv", result.content.decode())


def test_an_override_is_filled_in_where_it_is_named(tmp_path: Path) -> None:
    with pytest.raises(
        TableError,
        match=r"2 grade columns to fill in .*\"new_override-1a2b3c4d\", \"new_override-9",
    ):
        filled(tmp_path, EDX, OVERRIDES)
    filled(tmp_path, EDX, OVERRIDES, ExportOptions(columns={"": "new_override-1a2b3c4d"}))
    assert changed(tmp_path) == {(2, "new_override-1a2b3c4d"): "8.25"}


def test_what_was_there_before_is_no_column_to_be_filled(tmp_path: Path) -> None:
    with pytest.raises(
        TableError, match='"Previous Points" is no column from which Open edX takes grades'
    ):
        filled(tmp_path, EDX, POINTS, ExportOptions(columns={"": "Previous Points"}))


def test_its_keys_are_its_own(tmp_path: Path) -> None:
    with pytest.raises(
        TableError,
        match="Open edX: its rows are identified by numbers that only it assigns - expected",
    ):
        fresh(tmp_path, EDX)
    with pytest.raises(
        TableError, match="download.csv: is not a file of Open edX - expected the columns user_id"
    ):
        filled(tmp_path, EDX, "username,Score\nwangwei,1\n")


def test_edx_takes_four_mebibytes(tmp_path: Path) -> None:
    long = POINTS + f"15,{'x' * 5_000_000},,,,,,,,,,,\n"
    with pytest.raises(
        TableError,
        match="bytes - expected at most 4194304, or Open edX refuses it - split the file",
    ):
        filled(tmp_path, EDX, long)
