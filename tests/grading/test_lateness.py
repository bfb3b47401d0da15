"""What being late and trying again costs by a policy: subtracted from totals exactly, kept apart,
shown to students and in comparisons; times that are not certain are refused.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Sequence
from datetime import timedelta
from fractions import Fraction
from pathlib import Path

import pytest
from click.testing import Result

from kinegrade.deadlines.duration import read_duration, write_duration
from kinegrade.deadlines.moment import read_moment
from kinegrade.errors import FieldError
from kinegrade.grading.lateness.rule import LateRule, Penalties, TryRule
from kinegrade.marks_folder.folder import open_marks
from kinegrade.marks_folder.rows import Submission
from tests.grading.marked_folder import COLUMNS, RIGHT, Page, mark_class
from tests.small_class import contents, kinegrade, table

DUE = "2026-12-01 18:00"
LATE = '[late]\npenalty = "10 %"\n'
WRONG = ("9", "9", "9")
DAY = timedelta(days=1)


@pytest.mark.parametrize(
    ("late_by", "share"),
    [(0, 0), (1, 1), (24 * 60, 1), (24 * 60 + 1, 2), (5 * 24 * 60, 5), (400 * 24 * 60, 10)],
)
def test_each_begun_day_costs_its_share_and_never_more_than_all(late_by: int, share: int) -> None:
    rule = LateRule(read_moment(DUE), Fraction(1, 10))
    assert rule.find_share(timedelta(minutes=late_by)) == Fraction(share, 10)


@pytest.mark.parametrize(("per", "units"), [("hour", 49), ("day", 3), ("week", 1), ("once", 1)])
def test_time_is_counted_by_its_unit(per: str, units: int) -> None:
    rule = LateRule(read_moment(DUE), Fraction(1, 100), per)  # type: ignore[arg-type]
    assert rule.count_units(2 * DAY + timedelta(seconds=1)) == units


def test_a_penalty_is_of_the_maximum_or_of_what_was_reached_and_takes_no_more_than_that() -> None:
    late = LateRule(read_moment(DUE), Fraction(1, 2), most=Fraction(3, 4))
    submission = Submission(late_by=DAY)
    assert Penalties(late).subtract(submission, Fraction(4), Fraction(10)) == 4
    assert Penalties(late).subtract(submission, Fraction(8), Fraction(10)) == 5
    assert Penalties(late, base="total").subtract(submission, Fraction(8), Fraction(10)) == 4
    assert late.find_share(3 * DAY) == Fraction(3, 4)


def test_tries_and_lateness_add_up_to_all_at_most() -> None:
    penalties = Penalties(
        LateRule(read_moment(DUE), Fraction(1, 2)), TryRule(Fraction(1, 5), Fraction(2, 5))
    )
    assert penalties.find_share(Submission(before=1)) == Fraction(1, 5)
    assert penalties.find_share(Submission(before=9)) == Fraction(2, 5)
    assert penalties.find_share(Submission(late_by=DAY, before=1)) == Fraction(7, 10)
    assert penalties.find_share(Submission(late_by=2 * DAY, before=1)) == 1


@pytest.fixture
def exam(tmp_path: Path) -> Path:
    """An exam of 9.5 points, due on the first of December at six."""
    folder, _ = mark_class(tmp_path / "class", {"7": RIGHT, "8": RIGHT, "9": RIGHT, "10": ()})
    head = json.loads((folder / "exam.json").read_text(encoding="utf-8"))
    (folder / "exam.json").write_text(json.dumps({**head, "due": DUE}), encoding="utf-8")
    return folder


Rows = Sequence[tuple[str, str, Sequence[str]]]  # student, time, answers
IN_TIME: Rows = [
    ("7", "2026-12-01 18:00", RIGHT),
    ("8", "2026-12-01 18:10", RIGHT),
    ("9", "2026-12-02 18:10:01", RIGHT),
]


def grade(exam: Path, policy: str, rows: Rows = IN_TIME, name: str = "LATE", *more: str) -> Result:
    """The class marked by a policy, from a sheet that says when each row was handed in."""
    sheet, file = exam.parent / "typed.csv", exam.parent / "policy.toml"
    with sheet.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow(["student", "submitted", *COLUMNS])
        writer.writerows([student, time, *cells] for student, time, cells in rows)
    file.write_text(policy, encoding="utf-8")
    wishes = "-o", exam.parent / name, "--policy", file, *more
    return kinegrade("grade", exam, sheet, *wishes)


def totals(exam: Path, name: str = "LATE") -> dict[str, tuple[str, str]]:
    """What each student has, and what was subtracted."""
    rows = table(exam.parent / name / "grades.csv")
    return {row["student"]: (row["total"], row["subtracted"]) for row in rows}


def test_what_is_late_costs_points_that_are_kept_apart(exam: Path) -> None:
    done = grade(exam, f'{LATE}grace = "15 min"\n')
    assert done.exit_code < 2, done.stderr
    assert totals(exam) == {
        "7": ("9.5", "0"), "8": ("9.5", "0"), "9": ("7.6", "1.9"), "10": ("0", "0"),
    }  # fmt: skip
    (line,) = table(exam.parent / "LATE" / "subtracted.csv")
    assert line == {
        "student": "9", "name": "Student 9", "submitted": "2026-12-02 18:10:01", "due": DUE,
        "late_by": "24:11", "late_percent": "20", "tries_before": "0", "tries_percent": "0",
        "points": "1.9",
        "reason": "handed in 24:11 hours late: 20 %",
    }  # fmt: skip
    assert "subtracted.csv: 1.9 points are subtracted from 1 total" in done.stderr


def test_without_grace_a_minute_is_late(exam: Path) -> None:
    grade(exam, LATE)
    assert totals(exam)["8"] == ("8.55", "0.95")


@pytest.mark.parametrize("more", ['"2 days"', '"2026-12-03 18:00"', "2026-12-03T18:00:00"])
def test_an_extension_is_more_time_for_one_student(exam: Path, more: str) -> None:
    done = grade(exam, f"{LATE}extensions = {{ 9 = {more} }}\n")
    assert done.exit_code < 2, done.stderr
    assert (totals(exam)["9"], totals(exam)["8"]) == (("9.5", "0"), ("8.55", "0.95"))


def test_a_date_in_the_policy_is_used_in_place_of_the_banks(exam: Path) -> None:
    grade(exam, f'{LATE}due = "2026-12-02 12:00"\n')
    assert totals(exam)["9"] == ("8.55", "0.95")
    assert totals(exam)["8"] == ("9.5", "0")


TRIES: Rows = [
    ("7", "2026-12-01 10:00", WRONG),
    ("7", "2026-12-01 11:00", RIGHT),
    ("8", "2026-12-01 17:00", ("1.732", "0", "9")),
    ("8", "2026-12-03 18:00", RIGHT),
]


@pytest.mark.parametrize(
    ("attempts", "seven", "eight"),
    [
        ("last", ("7.6", "1.9"), ("5.7", "3.8")),
        ("first", ("0", "0"), ("7", "0")),
        ("best", ("7.6", "1.9"), ("7", "0")),
    ],
)
def test_the_best_of_several_is_best_after_what_it_costs(
    exam: Path, attempts: str, seven: tuple[str, str], eight: tuple[str, str]
) -> None:
    policy = f'attempts = "{attempts}"\n{LATE}[tries]\npenalty = "20 %"\n'
    done = grade(exam, policy, TRIES)
    assert done.exit_code < 2, done.stderr
    assert (totals(exam)["7"], totals(exam)["8"]) == (seven, eight)


def test_a_try_alone_needs_no_times(exam: Path) -> None:
    rows = [(student, "", cells) for student, _, cells in TRIES]
    done = grade(exam, '[tries]\npenalty = "20 %"\n', rows)
    assert totals(exam)["7"] == ("7.6", "1.9")
    assert "not known when" not in done.stderr


@pytest.mark.parametrize(
    ("times", "tried"),
    [
        (("2026-12-01 10:00", "2026-12-01 10:00"), False),
        (("2026-12-01 10:00", "2026-12-01 10:00:00"), False),  # the same, written otherwise
        (("", ""), False),
        (("2026-12-01 10:00", ""), False),
        (("2026-12-01 10:00", "2026-12-01 11:00"), True),
    ],
)
@pytest.mark.parametrize("attempts", ["last", "best"])
def test_a_row_that_stands_twice_is_no_other_submission_unless_at_another_time(
    exam: Path, attempts: str, times: tuple[str, str], *, tried: bool
) -> None:
    rows = [("7", time, RIGHT) for time in times]
    done = grade(exam, f'attempts = "{attempts}"\n[tries]\npenalty = "20 %"\n', rows)
    costs = tried and attempts == "last"
    assert totals(exam)["7"] == (("7.6", "1.9") if costs else ("9.5", "0"))
    assert ("ignored, the answers are the same" in done.stderr) is not tried


def test_the_same_answers_after_others_are_a_try_after_those_alone(exam: Path) -> None:
    rows = [("7", "", cells) for cells in (RIGHT, WRONG, RIGHT)]
    grade(exam, '[tries]\npenalty = "20 %"\n', rows)
    assert totals(exam)["7"] == ("7.6", "1.9")


def test_tries_may_take_shares_of_the_total_without_a_date(exam: Path) -> None:
    rows = [("7", "", ("1.732", "0", "9")), ("7", "", ("1.732", "0", "8"))]
    stated = 'penalty = "20 %"\nof = "total"\n'
    done = grade(exam, f"[tries]\n{stated}", rows)
    assert done.exit_code < 2, done.stderr
    assert totals(exam)["7"] == ("5.6", "1.4")
    grade(exam, f"{LATE}[tries]\n{stated}", rows, "BOTH")
    assert totals(exam, "BOTH")["7"] == ("5.6", "1.4")
    other = grade(exam, f'{LATE}of = "maximum"\n[tries]\n{stated}', rows, "OTHER")
    assert other.exit_code == 2
    assert 'tries.of: is "total", that of [late] "maximum" - leave one of the two' in other.stderr


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


def test_grades_are_of_what_is_left(exam: Path) -> None:
    policy = f'{LATE}due = "2026-11-27 18:00"\n[scale]\nkind = "german"\n'
    assert grade(exam, policy).exit_code < 2
    rows = table(exam.parent / "LATE" / "grades.csv")
    assert [(row["student"], row["total"], row["grade"]) for row in rows] == [
        ("7", "5.7", "3.3"), ("8", "4.75", "4.0"), ("9", "3.8", "5.0"), ("10", "0", ""),
    ]  # fmt: skip


@pytest.mark.parametrize("form", ["md", "html"])
def test_students_read_what_was_subtracted(exam: Path, form: str) -> None:
    grade(exam, LATE)
    sheets = exam.parent / "F"
    wishes = "-o", sheets, "--format", form
    assert kinegrade("feedback", exam, exam.parent / "LATE", *wishes).exit_code == 0
    late, in_time = (
        Page((sheets / "sheets" / f"{student}.{form}").read_text(encoding="utf-8")).text
        for student in ("9", "7")
    )
    assert "7.6 / 9.5" in late
    assert "Subtracted from the total: 1.9 (handed in 24:11 hours late: 20 %)" in late
    assert "Subtracted" not in in_time


def test_a_comparison_shows_what_is_subtracted(exam: Path) -> None:
    grade(exam, "attempts = 'last'", name="PLAIN")
    grade(exam, LATE)
    output = exam.parent / "diff.csv"
    shown = kinegrade("diff", exam.parent / "PLAIN", exam.parent / "LATE", "-o", output).stdout
    rows = [row for row in table(output) if row["what"] == "subtracted"]
    assert [(row["student"], row["before"], row["after"]) for row in rows] == [
        ("8", "", "0.95"), ("9", "", "1.9"),
    ]  # fmt: skip
    assert "subtracted" in shown


def test_a_system_is_told_what_is_missing_from_the_sum(exam: Path) -> None:
    grade(exam, LATE)
    assert "1: 7/7; 2: 2.5/2.5; -1.9" in (exam.parent / "LATE" / "moodle.csv").read_text("utf-8")
    wishes = "--to", "generic", "-o", exam.parent / "sheet.csv", "--per-question"
    done = kinegrade("export", exam.parent / "LATE", *wishes)
    assert done.exit_code == 1
    assert "points are subtracted from 2 totals, and questions do not show it" in done.stderr


def test_a_system_is_told_that_an_earlier_total_stands(exam: Path) -> None:
    grade(exam, "attempts = 'last'", name="FIRST")
    grade(exam, LATE, IN_TIME, "STANDS", "--never-lower", str(exam.parent / "FIRST"))
    moodle = (exam.parent / "STANDS" / "moodle.csv").read_text("utf-8")
    assert "1: 7/7; 2: 2.5/2.5; -1.9; an earlier total stands" in moodle
    wishes = "--to", "generic", "-o", exam.parent / "sheet.csv", "--per-question"
    done = kinegrade("export", exam.parent / "STANDS", *wishes)
    assert done.exit_code == 1
    said = 'earlier totals stand for 2 students ("8", "9"), and questions do not show it - export'
    assert said in done.stderr


def test_the_report_says_from_how_many_points_are_subtracted(exam: Path) -> None:
    grade(exam, LATE)
    page = exam.parent / "report.html"
    assert kinegrade("report", exam, exam.parent / "LATE", "-o", page).exit_code == 0
    assert "Points are subtracted from 2 totals" in page.read_text(encoding="utf-8")


def test_marking_again_gives_the_same_bytes(exam: Path) -> None:
    grade(exam, LATE)
    grade(exam, LATE, name="AGAIN")
    assert contents(exam.parent / "LATE") == contents(exam.parent / "AGAIN")


def test_a_total_that_stands_is_not_lowered_by_lateness(exam: Path) -> None:
    grade(exam, "attempts = 'last'", IN_TIME, "PLAIN")
    grade(exam, LATE, IN_TIME, "LATE", "--never-lower", str(exam.parent / "PLAIN"))
    assert totals(exam)["9"][0] == "9.5"
    wishes = "-o", exam.parent / "F", "--format", "md"
    assert kinegrade("feedback", exam, exam.parent / "LATE", *wishes).exit_code == 0
    sheet = (exam.parent / "F" / "sheets" / "9.md").read_text(encoding="utf-8")
    assert "Subtracted" not in sheet


def test_a_blank_amount_is_nothing_as_where_folders_were_put_together(exam: Path) -> None:
    grade(exam, LATE)
    path = exam.parent / "LATE" / "grades.csv"
    text = path.read_text(encoding="utf-8")
    assert ",100,marked,0\n" in text
    path.write_text(text.replace(",100,marked,0\n", ",100,marked,\n"), encoding="utf-8")
    totals = open_marks(exam.parent / "LATE").totals.by_student
    assert (totals["7"].subtracted, totals["9"].subtracted) == (0, Fraction("1.9"))


def test_a_lateness_that_was_changed_by_hand_is_refused(exam: Path) -> None:
    grade(exam, LATE)
    path = exam.parent / "LATE" / "subtracted.csv"
    path.write_text(path.read_text(encoding="utf-8").replace("24:11", "a day"), encoding="utf-8")
    wishes = "-o", exam.parent / "F", "--format", "md"
    done = kinegrade("feedback", exam, exam.parent / "LATE", *wishes)
    assert done.exit_code == 2
    assert 'late_by is "a day" - expected hours and minutes like 25:00' in done.stderr


def test_an_amount_that_was_changed_by_hand_is_refused(exam: Path) -> None:
    grade(exam, LATE)
    path = exam.parent / "LATE" / "grades.csv"
    text = path.read_text(encoding="utf-8")
    assert text.count(",1.9") == 1
    path.write_text(text.replace(",1.9", ",0.9"), encoding="utf-8")
    done = kinegrade("export", exam.parent / "LATE", "--to", "xlsx", "-o", exam.parent / "x.xlsx")
    assert done.exit_code == 2
    assert "total is 7.6, 8.6 by marks.csv" in done.stderr


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
