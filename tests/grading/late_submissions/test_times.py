"""Times of submissions: those that lack, are not certain or have a zone, and rules that do not fit."""

from __future__ import annotations

import json
from datetime import timedelta
from pathlib import Path

import pytest

from kinegrade.deadlines.duration import read_duration, write_duration
from kinegrade.errors import FieldError
from tests.grading.late_submissions.late_exam import DUE, IN_TIME, LATE, WRONG, Rows, grade, totals
from tests.grading.marked_folder import COLUMNS, RIGHT
from tests.small_class import kinegrade


def test_rows_without_a_time_are_told_of_and_cost_nothing(exam: Path) -> None:
    done = grade(exam, LATE, [("7", "", RIGHT), ("9", "2026-12-02 18:10", RIGHT)])
    assert done.exit_code == 1
    assert '1 student, first "7": it is not known when it was handed in' in done.stderr
    assert totals(exam)["7"] == ("9.5", "0")


def test_two_files_with_different_times_of_a_student_are_told_of(exam: Path) -> None:
    again = exam.parent / "again.csv"
    again.write_text(
        f"student,submitted,{COLUMNS[0]}\n7,2026-12-03 18:00,\n8,2026-12-01 18:10:00,\n9,,\n",
        encoding="utf-8",
    )
    assert "handed in at" not in grade(exam, LATE).stderr
    sheet, policy = exam.parent / "typed.csv", exam.parent / "policy.toml"
    done = kinegrade("grade", exam, sheet, again, "--policy", policy, "-o", exam.parent / "TWO")
    assert done.exit_code == 1
    assert [line for line in done.stderr.splitlines() if "handed in at" in line] == [
        'complaint: again.csv:2: student "7" handed in at "2026-12-03 18:00" by this file and at'
        f' "{IN_TIME[0][1]}" by typed.csv - the time in typed.csv counts; correct one of the files'
        " and grade again"
    ]


@pytest.mark.parametrize("time", ["12/1/26 18:30", "1.12.2026 18:30", "2026-13-01 18:30", "late"])
def test_a_time_that_is_not_certain_is_refused(exam: Path, time: str) -> None:
    done = grade(exam, LATE, [("7", time, RIGHT)])
    assert done.exit_code == 2
    assert f'typed.csv:2: handed in "{time}": what day and hour this is, is not certain' in (
        done.stderr
    )
    assert not (exam.parent / "LATE").exists()


def test_times_of_a_zone_need_a_due_date_that_has_one(exam: Path) -> None:
    rows = [("7", "2026-12-01 17:30:00 UTC", RIGHT)]
    done = grade(exam, LATE, rows)
    assert done.exit_code == 2
    assert "state it under [late]" in done.stderr
    assert grade(exam, f'{LATE}due = "{DUE} +01:00"\n', rows).exit_code < 2
    assert totals(exam)["7"] == ("8.55", "0.95")


def test_times_without_a_zone_are_in_that_of_the_due_date(exam: Path) -> None:
    assert grade(exam, f'{LATE}due = "{DUE} +01:00"\n').exit_code < 2
    assert totals(exam)["7"] == ("9.5", "0")
    assert totals(exam)["8"] == ("8.55", "0.95")


@pytest.mark.parametrize(
    ("policy", "said"),
    [
        ("[late]\n", "late.penalty: missing"),
        (f"{LATE}per = 'month'", '"month"'),
        (f"{LATE}grace = 15", "late.grace: 15 - expected a length of time"),
        (f"{LATE}grace = '15 parsecs'", '"15 parsecs"'),
        (f"{LATE}at-most = '150 %'", '"150 %"'),
        (f"{LATE}of = 'points'", '"points"'),
        (f"{LATE}due = 'noon'", "expected a date with a time"),
        (f"{LATE}cost = 1", "late.cost: unknown key"),
        (f"{LATE}extensions = {{ 99 = '1 day' }}", "late.extensions.99: no student of this exam"),
        (f"{LATE}extensions = {{ 9 = 'more' }}", "expected more time like"),
        (f"{LATE}extensions = {{ 9 = '2026-12-03 18:00Z' }}", "if the due date does"),
        ("[tries]\n", "tries.penalty: missing"),
        ("[tries]\npenalty = 0.1\nper = 'day'", "tries.per: unknown key"),
    ],
)
def test_a_rule_that_does_not_fit_is_refused(exam: Path, policy: str, said: str) -> None:
    done = grade(exam, policy)
    assert done.exit_code == 2
    assert said in done.stderr


def test_a_rule_needs_a_date(exam: Path) -> None:
    head = json.loads((exam / "exam.json").read_text(encoding="utf-8"))
    (exam / "exam.json").write_text(json.dumps({**head, "due": ""}), encoding="utf-8")
    done = grade(exam, LATE)
    assert "late.due: missing - expected a date with a time here" in done.stderr


@pytest.mark.parametrize(
    ("text", "minutes"), [("15 min", 15), ("2 h", 120), ("1 day", 1440), ("2 weeks", 20160)]
)
def test_a_length_of_time_is_read(text: str, minutes: int) -> None:
    assert read_duration(text) == timedelta(minutes=minutes)
    assert write_duration(timedelta(minutes=minutes)) == f"{minutes // 60}:{minutes % 60:02d}"


@pytest.mark.parametrize("text", ["15", "two days", "1 d", "-1 day", "", "1.5 h"])
def test_what_is_no_length_of_time_is_refused(text: str) -> None:
    with pytest.raises(FieldError, match="a length of time"):
        read_duration(text)


def test_attempts_are_ordered_by_their_times(exam: Path) -> None:
    rows: Rows = [
        ("7", "2026-12-01 11:00", RIGHT), ("7", "2026-12-01 10:00", WRONG),
        ("8", "2026-12-01 10:00", RIGHT), ("8", "", WRONG),
        ("9", "2026-12-01 10:00", WRONG), ("9", "2026-12-01 10:00", RIGHT),
    ]  # fmt: skip
    done = grade(exam, '[tries]\npenalty = "5 %"\n', rows)
    assert {student: total for student, (total, _) in totals(exam).items()} == {
        "7": "9.025", "8": "0", "9": "9.025", "10": "0",
    }  # fmt: skip
    told = [line for line in done.stderr.splitlines() if "which was first" in line]
    assert [line.split("student ")[1] for line in told] == [
        f'"{student}" do not all have times that say which was first - taken in the order of the '
        "rows"
        for student in ("8", "9")
    ]
