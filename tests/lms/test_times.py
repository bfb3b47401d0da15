"""When students handed in, as downloads say it: read where it is certain, by which late penalties
are given; refused where it is not.
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from datetime import date
from pathlib import Path

import pytest
from openpyxl import Workbook

from kinegrade.files.tables import read_table
from kinegrade.lms.responses.moodle_columns import moodle_columns
from kinegrade.lms.responses.times import read_time, read_times
from tests.grading.marked_folder import RIGHT, mark_class
from tests.small_class import kinegrade, table

SAMPLES = Path(__file__).parent / "samples" / "moodle"
DUE = "2026-12-01 18:00"


@pytest.mark.parametrize(
    ("column", "read"),
    [
        (["20.10.2026 18:10", "1.12.2026 9:05"], ["2026-10-20 18:10", "2026-12-01 09:05"]),
        (["1/2/2026 6:10 PM", "2/13/2026 6:10 PM"], ["2026-01-02 18:10", "2026-02-13 18:10"]),
        (["20.10.2026 18:10", "10.20.2026 18:10"], ["20.10.2026 18:10", "10.20.2026 18:10"]),
        (["20.10.2026 18:10", "1/2/2026 9:05"], ["2026-10-20 18:10", "1/2/2026 9:05"]),
        (["31.1.2026 8:10", "1/31/2026 9:05"], ["2026-01-31 08:10", "2026-01-31 09:05"]),
        (["20.10/2026 18:10"], ["20.10/2026 18:10"]),
        (["1.12.2026 9:05"], ["1.12.2026 9:05"]),
        (["31.2.2026 9:05", "late"], ["31.2.2026 9:05", "late"]),
    ],
)
def test_one_certain_time_says_for_its_column_which_number_is_the_day(
    column: list[str], read: list[str]
) -> None:
    assert read_times(column)[0] == read


@pytest.mark.parametrize(
    ("written", "read"),
    [
        ("Sunday, 27 September 2026, 3:04 PM", "2026-09-27 15:04"),
        ("21 November 2026  2:10 AM", "2026-11-21 02:10"),
        ("21 November 2026 12:10 AM", "2026-11-21 00:10"),
        ("21 Nov 2026 12:10 PM", "2026-11-21 12:10"),
        ("Sonntag, 27. September 2026, 15:04", "2026-09-27 15:04"),
        ("1. März 2026  02:10 Uhr", "2026-03-01 02:10"),
        ("2026年11月21日 02:10", "2026-11-21 02:10"),
        ("2026年11月21日 星期六 下午3:04", "2026-11-21 15:04"),
        ("2021-07-12 20:01:01 UTC", "2021-07-12 20:01:01 +00:00"),
        ("2026/09/27 3:00:00 PM GMT+3", "2026-09-27 15:00 +03:00"),
        ("2026-10-10 16:32:40", "2026-10-10 16:32:40"),
        ("2026-12-01 18:00:03.500000", "2026-12-01 18:00:03"),
        ("2026/9/27 9:05", "2026-09-27 09:05"),
    ],
)
def test_a_time_that_is_certain_is_read(written: str, read: str) -> None:
    assert read_time(written) == read


@pytest.mark.parametrize(
    "written",
    ["10/4/2026 10:15:00", "4.10.2026 10:15", "27 septembre 2026 15:04", "27 May 2026 13:04 PM",
     "31 February 2026 10:00", "2026-10-10", "21 November 2026 25:10", "-", ""],
)  # fmt: skip
def test_a_time_that_is_not_certain_stays_as_it_is(written: str) -> None:
    assert read_time(written) == written


@pytest.mark.parametrize("language", ["de", "en", "zh_cn"])
def test_the_end_of_an_attempt_is_found_in_what_moodle_wrote(language: str) -> None:
    download = read_table(SAMPLES / f"{language}-responses.csv")
    place = moodle_columns(download).grade - 2
    assert read_time(download.rows[1].cell(place)) == "2026-11-21 02:10"


def mark_download(
    folder: Path, rows: Sequence[Sequence[object]], due: str = DUE
) -> tuple[int, str]:
    """A class marked by a download and a late rule: exit status and what was said."""
    exam, _ = mark_class(folder / "class", {"7": RIGHT, "8": RIGHT})
    download, policy = folder / "download.csv", folder / "policy.toml"
    with download.open("w", encoding="utf-8", newline="") as stream:
        csv.writer(stream).writerows(rows)
    policy.write_text(f'[late]\ndue = "{due}"\npenalty = "10 %"\n', encoding="utf-8")
    done = kinegrade("grade", exam, download, "-o", folder / "MARKS", "--policy", policy)
    return done.exit_code, done.stderr


def subtracted(folder: Path) -> list[str]:
    return [row["subtracted"] for row in table(folder / "MARKS" / "grades.csv")]


MOODLE = [
    "Last name", "First name", "ID number", "Status", "Started", "Completed", "Duration",
    "Grade/9.50", "Response 1", "Response 2", "Response 3",
]  # fmt: skip


def attempt(student: str, completed: str) -> list[str]:
    began = "1 December 2026  5:00 PM"
    return ["A", "B", student, "Finished", began, completed, "1 hour", "9.50", *RIGHT]


def test_moodle_says_when_an_attempt_was_completed(tmp_path: Path) -> None:
    rows = [attempt("7", "1 December 2026  6:00 PM"), attempt("8", "2 December 2026  5:59 PM")]
    status, said = mark_download(tmp_path, [MOODLE, *rows])
    assert status == 0, said
    assert subtracted(tmp_path) == ["0", "0.95"]


def test_moodle_in_a_language_that_is_not_known_is_refused_by_its_first_time(
    tmp_path: Path,
) -> None:
    rows = [attempt("7", "mardi 1 décembre 2026, 18:00")]
    status, said = mark_download(tmp_path, [MOODLE, *rows])
    assert status == 2
    assert 'download.csv:2: handed in "mardi 1 décembre 2026, 18:00"' in said
    assert "download the file in English" in said


def sheet(student: str, submitted: object) -> list[object]:
    return [student, submitted, *RIGHT]


SHEET: list[object] = ["student", "submitted", "q1.v_B", "q1.omega_AB", "q2.a_B"]


def test_the_row_that_decides_on_the_order_of_times_is_named(tmp_path: Path) -> None:
    for first, order in ("30/11/2026 17:00", "day"), ("11/30/2026 17:00", "month"):
        folder = tmp_path / order
        folder.mkdir()
        status, said = mark_download(
            folder, [SHEET, sheet("7", first), sheet("8", "1/1/2026 9:05")]
        )
        assert status == 0, said
        assert (
            f'download.csv:2: "{first}" can be read only with the {order} first; so the times of the '
            "file with this separator are read"
        ) in said


def test_a_day_without_an_hour_is_refused_in_a_workbook_too(tmp_path: Path) -> None:
    exam, _ = mark_class(tmp_path / "class", {"7": RIGHT})
    policy, book = tmp_path / "policy.toml", Workbook()
    policy.write_text(f'[late]\ndue = "{DUE}"\npenalty = "10 %"\n', encoding="utf-8")
    for row in SHEET, sheet("7", date(2026, 12, 2)):
        book.worksheets[0].append(row)
    book.save(tmp_path / "answers.xlsx")
    marks = "-o", tmp_path / "MARKS", "--policy", policy
    refused = kinegrade("grade", exam, tmp_path / "answers.xlsx", *marks)
    assert refused.exit_code == 2
    assert 'answers.xlsx:2: handed in "2026-12-02": what day and hour' in refused.stderr


CANVAS = [
    "name", "id", "sis_id", "section", "section_id", "section_sis_id", "submitted",
    "1: q1.v_B", "4", "2: q1.omega_AB", "3", "3: q2.a_B", "2.5", "n correct", "n incorrect", "score",
]  # fmt: skip


def submission(student: str, submitted: str) -> list[str]:
    first, second, third = RIGHT
    cells = [first, "4", second, "3", third, "2.5", "3", "0", "9.5"]
    return [f"Student {student}", "1", student, "A", "2", "3", submitted, *cells]


def test_canvas_says_the_moment_in_utc(tmp_path: Path) -> None:
    rows = [submission("7", "2026-12-01 17:00:00 UTC"), submission("8", "2026-12-01 17:00:01 UTC")]
    status, said = mark_download(tmp_path, [CANVAS, *rows], f"{DUE} +01:00")
    assert status == 0, said
    assert subtracted(tmp_path) == ["0", "0.95"]


def test_canvas_needs_a_due_date_with_its_difference_from_utc(tmp_path: Path) -> None:
    status, said = mark_download(tmp_path, [CANVAS, submission("7", "2026-12-01 17:00:00 UTC")])
    assert status == 2
    assert 'under [late], like due = "2026-12-01 18:00 +01:00"' in said


@pytest.mark.parametrize(
    "head",
    [
        ["Timestamp", "student"],
        ["ID", "Start time", "Completion time", "Email", "Name", "student"],
        ["序号", "提交答卷时间", "1、学号"],
    ],
)
def test_forms_say_when_they_were_sent(tmp_path: Path, head: list[str]) -> None:
    asks = ["q1.v_B", "q1.omega_AB", "q2.a_B"]
    numbered = [f"{number}、{ask}" for number, ask in enumerate(asks, 2)]
    header = [*head, *(numbered if head[0] == "序号" else asks)]
    time = "2026-12-01 18:00:01"
    values = {"学号": "7", "student": "7", "Email": "anonymous", "序号": "1", "ID": "1"}
    cells = [values.get(name.split("、")[-1], time if "ime" in name or "时间" in name else "x")
             for name in head]  # fmt: skip
    status, said = mark_download(tmp_path, [header, [*cells, *RIGHT]])
    assert status < 2, said
    assert subtracted(tmp_path)[0] == "0.95"
