"""What follows from an answer that a policy accepts has all points, and `grade` says so."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from tests.small_class import generate, key_lines, kinegrade, write_class

BANK = """title = "Midterm"
course = "Mechanics"
tolerance = { relative = "1 %" }
credit = { follow-through = "1/2", mistakes = { sense-reversed = "1/2" } }
[[questions]]
template = "slider-crank"
asks = { v_B = 3, omega_AB = 2 }
"""
ACCEPTED = '[questions.q1.asks.v_B]\naccept = [{{ value = "-v_B", credit = {}{} }}]\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """An exam, and the answers of one student with both signs reversed, of one with the second."""
    write_class(tmp_path)
    (tmp_path / "bank.toml").write_text(BANK, encoding="utf-8")
    assert generate(tmp_path, "EXAM", "--no-papers").exit_code == 0
    rows = ["student,q1.v_B,q1.omega_AB"]
    for line, v_sign in zip(key_lines(tmp_path / "EXAM")[:2], (-1, 1), strict=True):
        asks = line["questions"][0]["asks"]
        v_B, omega = asks["v_B"]["value"], asks["omega_AB"]["value"]
        rows.append(f"{line['student']},{v_sign * v_B:.6g},{-omega:.6g}")
    (tmp_path / "answers.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    return tmp_path


def grade(folder: Path, credit: str, more: str = "") -> tuple[list[str], dict[str, str]]:
    """What is said of accepted answers, and everybody's points for omega_AB."""
    (folder / "policy.toml").write_text(ACCEPTED.format(credit, more), encoding="utf-8")
    files = folder / "EXAM", folder / "answers.csv", "-o", folder / "MARKS"
    said = kinegrade("grade", *files, "--policy", folder / "policy.toml").stderr.splitlines()
    with (folder / "MARKS" / "marks.csv").open(encoding="utf-8-sig", newline="") as file:
        points = {
            row["student"]: row["points"]
            for row in csv.DictReader(file)
            if row["ask"] == "omega_AB" and row["response"]
        }
    return [line for line in said if line.startswith("q1.")], points


def test_it_is_said_who_has_all_points_for_what_follows(folder: Path) -> None:
    said, points = grade(folder, "1")
    first, second = points
    assert points == {first: "2", second: "1"}
    assert said == [
        'q1.v_B: accepted answer 1, "-v_B", counted for 1 student',
        "q1.omega_AB: follows from q1.v_B, where an answer of the policy was accepted, and has all "
        f"points for 1 student ({first})",
    ]


def test_nothing_is_said_where_the_accepted_answer_is_charged(folder: Path) -> None:
    said, points = grade(folder, "0.5")
    assert set(points.values()) == {"1"}
    assert said == ['q1.v_B: accepted answer 1, "-v_B", counted for 1 student']


@pytest.mark.parametrize("credit", ["1", "0.5"])
def test_an_accepted_answer_is_kept_from_leading_others(folder: Path, credit: str) -> None:
    """Both have half of the points: for the known mistake, not for what follows."""
    said, points = grade(folder, credit, ", leads = false")
    assert set(points.values()) == {"1"}
    assert said == ['q1.v_B: accepted answer 1, "-v_B", counted for 1 student']
    with (folder / "MARKS" / "marks.csv").open(encoding="utf-8-sig", newline="") as file:
        verdicts = [row["verdict"] for row in csv.DictReader(file) if row["response"]]
    assert "follow-through" not in verdicts


def test_it_leads_where_that_is_said_or_nothing(folder: Path) -> None:
    said, points = grade(folder, "1", ", leads = true")
    assert sorted(points.values()) == ["1", "2"]
    assert len(said) == 2


def test_whether_it_leads_is_yes_or_no(folder: Path) -> None:
    text = ACCEPTED.format("1", ', leads = "no"')
    (folder / "policy.toml").write_text(text, encoding="utf-8")
    files = folder / "EXAM", folder / "answers.csv", "-o", folder / "MARKS"
    result = kinegrade("grade", *files, "--policy", folder / "policy.toml")
    assert result.exit_code == 2
    assert "leads" in result.stderr
