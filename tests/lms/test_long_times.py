"""Answers one below the other with a column of times: what one student handed in at one time is one
attempt.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.lms.test_responses_long import right
from tests.small_class import generate, kinegrade, table, write_class

LATE = '[late]\ndue = "2026-11-04 18:00"\npenalty = "10 %"\n'
HEAD = "student,ask,answer,submitted"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class with its exam; not to be changed."""
    made = write_class(tmp_path_factory.mktemp("long"))
    assert generate(made).exit_code == 0
    return made


def mark(folder: Path, place: Path, policy: str, *lines: str) -> str:
    """What is said of a table with times, marked under a policy."""
    file, rules = place / "long.csv", place / "policy.toml"
    file.write_text("\n".join([HEAD, *lines]) + "\n", encoding="utf-8")
    rules.write_text(policy, encoding="utf-8")
    exam, marks = folder / "EXAM", place / "MARKS"
    return kinegrade("grade", exam, file, "-o", marks, "--policy", rules, "--own-papers").stderr


def find_total(place: Path) -> str:
    rows = table(place / "MARKS" / "grades.csv")
    return next(row["total"] for row in rows if row["student"] == "007")


def test_the_times_of_answers_count_for_the_deadline(folder: Path, tmp_path: Path) -> None:
    value = right(folder, "007", "q1.v_B")
    said = mark(folder, tmp_path, LATE, f"007,q1.v_B,{value},2026-11-05 17:00")
    assert "it is not known when" not in said
    assert [row["student"] for row in table(tmp_path / "MARKS" / "subtracted.csv")] == ["007"]


def test_answers_at_two_times_are_attempts(folder: Path, tmp_path: Path) -> None:
    one, other = (right(folder, "007", ask) for ask in ("q1.v_B", "q1.a_B"))
    rows = (
        f"007,q1.v_B,{one},2026-11-03 17:00",
        "007,q1.a_B,999,2026-11-03 17:00",
        "007,q1.v_B,999,2026-11-03 17:30",
        f"007,q1.a_B,{other},2026-11-03 17:30",
    )
    totals = []
    for attempts in ("first", "last", "best"):
        place = tmp_path / attempts
        place.mkdir()
        mark(folder, place, f'attempts = "{attempts}"\n', *rows)
        totals.append(find_total(place))
    first, last, best = map(float, totals)
    assert first != last
    assert best == max(first, last)


def test_different_answers_at_two_times_are_one_attempt_that_was_handed_in_last(
    folder: Path, tmp_path: Path
) -> None:
    one, other = (right(folder, "007", ask) for ask in ("q1.v_B", "q1.a_B"))
    rows = f"007,q1.v_B,{one},2026-11-05 17:00", f"007,q1.a_B,{other},2026-11-03 17:00"
    said = mark(folder, tmp_path, LATE, *rows)
    assert (
        'long.csv:3: submitted: is "2026-11-03 17:00" here and "2026-11-05 17:00" at long.csv:2, '
        "but no ask is answered twice - taken for one attempt, handed in at 2026-11-05 17:00; "
        "write one time into all rows of an attempt" in said
    )
    (row,) = table(tmp_path / "MARKS" / "subtracted.csv")
    assert (row["student"], row["submitted"]) == ("007", "2026-11-05 17:00")


def test_rows_without_a_time_belong_to_the_attempt_of_the_others(
    folder: Path, tmp_path: Path
) -> None:
    one, other = (right(folder, "007", ask) for ask in ("q1.v_B", "q1.a_B"))
    said = mark(
        folder, tmp_path, LATE, f"007,q1.v_B,{one},", f"007,q1.a_B,{other},2026-11-05 17:00"
    )
    assert "it is not known when" not in said
    (row,) = table(tmp_path / "MARKS" / "subtracted.csv")
    assert row["submitted"] == "2026-11-05 17:00"
