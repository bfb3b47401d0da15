"""Brightspace: "#" before ids and at the end of lines, long headers that state the maximum."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import TableError
from kinegrade.lms.grades.dialect import ExportOptions
from kinegrade.lms.grades.systems.brightspace import BRIGHTSPACE
from tests.golden_files import Hold
from tests.lms.marked_folder import changed, filled, fresh

LONG = (
    "Kinematics quiz Points Grade <Numeric MaxPoints:10 Weight:1 Category:Lecture "
    "CategoryWeight:50>"
)
DOWNLOAD = (
    f"OrgDefinedId,Username,{LONG},Letter Grade Symbol,Adjusted Final Grade Numerator,End-of-Line "
    "Indicator\r\n"
    "#0012345,#wangwei,,A,1,#\r\n#0012346,#zoneil,3,,,#\r\n#0012347,#nobody,,,,#\r\n#12348,#x,,,,#\r\n"
)


def test_the_golden_file(tmp_path: Path, hold: Hold) -> None:
    text = fresh(tmp_path, BRIGHTSPACE).text
    hold("lms/brightspace.csv", text)
    lines = text.splitlines()
    assert lines[0].endswith("Points Grade <Numeric MaxPoints:10>,End-of-Line Indicator")
    assert [line for line in lines[1:] if not (line.startswith("#") and line.endswith(",#"))] == []


def test_the_marks_around_ids_are_not_part_of_them(tmp_path: Path) -> None:
    result = filled(tmp_path, BRIGHTSPACE, DOWNLOAD)
    assert changed(tmp_path) == {(2, LONG): "8.25", (3, LONG): "4"}
    assert [str(each).split(" - ")[0] for each in result.complaints] == [
        'download.csv: no row for student "0012348" by OrgDefinedId or Username',
        'download.csv:5: no student of the marked class has OrgDefinedId "#12348", Username "#x"',
    ]
    assert 'line 5 has OrgDefinedId "#12348", probably the same' in str(result.complaints[0])


@pytest.mark.parametrize(
    ("header", "maximum"),
    [
        ("Quiz Points Grade", None),
        ("Quiz Points Grade <Numeric MaxPoints:12>", "12"),
        ("Quiz Points Grade <Numeric MaxPoints:10.5 Weight:1>", "10.5"),
        ("Quiz Points Grade <Numeric MaxPoints:10,5 Weight:1>", "10,5"),
    ],
)
def test_short_and_long_headers(tmp_path: Path, header: str, maximum: str | None) -> None:
    found = BRIGHTSPACE.downloads[0].item.fullmatch(header)
    assert found is not None
    assert (found["title"], found["maximum"]) == ("Quiz", maximum)


def test_logins_get_their_mark_too(tmp_path: Path) -> None:
    assert (
        fresh(tmp_path, BRIGHTSPACE, ExportOptions(by=("login",))).text.splitlines()[1]
        == "#0012345,8.25,#"
    )


def test_a_title_with_settings_in_it_is_refused(tmp_path: Path) -> None:
    with pytest.raises(
        TableError, match="does not fit: Brightspace reads what stands between < and > as settings"
    ):
        fresh(tmp_path, BRIGHTSPACE, ExportOptions(title="a <b>"))


def test_another_encoding_is_refused(tmp_path: Path) -> None:
    with pytest.raises(
        TableError, match="is UTF-16-LE - expected UTF-8, or Brightspace refuses it"
    ):
        filled(tmp_path, BRIGHTSPACE, DOWNLOAD.encode("utf-16"))


def test_a_maximum_with_a_comma_is_no_whole_number(tmp_path: Path) -> None:
    header = '"Quiz Points Grade <Numeric MaxPoints:20,5 Weight:1>"'
    file = f"OrgDefinedId,{header},End-of-Line Indicator\r\n#0012345,,#\r\n"
    with pytest.raises(TableError, match=r"counts 20\.5 there, 10 in the exam"):
        filled(tmp_path, BRIGHTSPACE, file)
