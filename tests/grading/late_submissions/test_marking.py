"""Late submissions of a class, marked: grace, extensions, tries, the best of several."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.grading.late_submissions.late_exam import DUE, LATE, WRONG, Rows, grade, totals
from tests.grading.marked_folder import RIGHT
from tests.small_class import table


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
