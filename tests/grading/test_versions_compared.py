"""Versions that are out of different points are compared by shares; through the command line."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

from tests.small_class import key_lines, kinegrade, table

BANK = """title = "Versions"
course = "Mechanics"
versions = 2
[[questions]]
template = "slider-crank"
asks = { v_B = 3 }
[[questions]]
any = ["four-bar-by-lengths", "toggle-press"]
asks = "velocity"
points = 7
"""
DROPPED = '[questions.q2a]\nvoid = "drop"\n'
STUDENTS = [f"{place:03}" for place in range(1, 37)]


@pytest.fixture
def marked(tmp_path: Path) -> Path:
    """Marks of a class in which every fifth student of each version knows nothing, the others all;
    by a policy that takes a question away from one of the versions.
    """
    (tmp_path / "bank.toml").write_text(BANK, encoding="utf-8")
    roster = "student,name\n" + "".join(f"{each},Student {each}\n" for each in STUDENTS)
    (tmp_path / "roster.csv").write_text(roster, encoding="utf-8")
    (tmp_path / "policy.toml").write_text(DROPPED, encoding="utf-8")
    exam, marks = tmp_path / "EXAM", tmp_path / "MARKS"
    files = tmp_path / "bank.toml", tmp_path / "roster.csv"
    made = kinegrade("generate", *files, "-o", exam, "--reproducible", "v", "--no-papers")
    assert made.exit_code == 0, made.stderr
    seen = {"A": 0, "B": 0}
    rows = table(exam / "answers.csv")
    for row, line in zip(rows, key_lines(exam), strict=True):
        seen[line["version"]] += 1
        for question in line["questions"]:
            for name, ask in question["asks"].items():
                knows = seen[line["version"]] % 5
                row[f"{question['question']}.{name}"] = ask["decimal"] if knows else "77777"
    with (tmp_path / "answers.csv").open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    done = kinegrade(
        *("grade", exam, tmp_path / "answers.csv", "-o", marks),
        *("--policy", tmp_path / "policy.toml"),
    )
    assert done.exit_code == 0, done.stderr
    assert {row["out_of"] for row in table(marks / "grades.csv")} == {"3", "10"}
    return marks


def test_versions_out_of_different_points_are_compared_by_shares(marked: Path) -> None:
    page = marked.with_name("report.html")
    done = kinegrade("report", marked.with_name("EXAM"), marked, "-o", page)
    assert done.exit_code == 0, done.stderr
    text = page.read_text(encoding="utf-8")
    assert "H = 0.00" in text
    assert "The versions differ by more than chance" not in text
    assert "of 3 … 10 points" in text
    assert "<dt>reliability (α)</dt><dd>–</dd>" in text  # papers weigh differently
