"""Marks that were known and are changed: when, what, and why, kept through every later marking."""

from __future__ import annotations

from datetime import date
from pathlib import Path
from typing import Any

import pytest
from click.testing import Result

from kinegrade.lms.responses.class_files import ClassFiles, read_class
from kinegrade.public import marking
from tests.grading.marked_folder import RIGHT, mark_class
from tests.small_class import kinegrade, table

ANSWERS = {"007": ("1.75", "0", "-0.125"), "S9": RIGHT, "S8": ("1.732", "9", "-0.125")}
WIDER = '[questions.q1.asks.v_B]\ntolerance = { relative = "2 %" }\n'
KINDER = f'{WIDER}\n[questions.q1.asks.omega_AB]\naccept = [{{ value = "9", student = ["S8"] }}]\n'


@pytest.fixture
def marked(tmp_path: Path) -> Path:
    """A folder with EXAM and MARKS, wider.toml and kinder.toml."""
    mark_class(tmp_path, ANSWERS)
    (tmp_path / "wider.toml").write_text(WIDER, encoding="utf-8")
    (tmp_path / "kinder.toml").write_text(KINDER, encoding="utf-8")
    return tmp_path


def grade(folder: Path, marks: str, *options: str | Path) -> Result:
    """Mark the class again."""
    files = folder / "EXAM", folder / "answers.csv", "-o", folder / marks
    return kinegrade("grade", *files, *options)


def change(folder: Path, old: str, new: str, policy: str, reason: str) -> Result:
    """Mark the class again by a policy, for that reason."""
    since = "--since", folder / old, "--reason", reason
    return grade(folder, new, "--policy", folder / policy, *since)


def log(folder: Path, marks: str) -> list[tuple[str, ...]]:
    """Who, what, before, after and why."""
    columns = "student", "what", "before", "after", "reason"
    rows = table(folder / marks / "changes.csv")
    assert {row["date"] for row in rows} == {date.today().isoformat()}
    return [tuple(row[column] for column in columns) for row in rows]


def test_what_changes_is_logged_with_its_reason(marked: Path) -> None:
    done = change(marked, "MARKS", "MARKS2", "wider.toml", "hearing of 4 May")
    assert done.exit_code == 0, done.stderr
    assert "totals since the earlier marking: 1 up, 0 down, " in done.stderr
    assert log(marked, "MARKS2") == [
        ("007", "total", "5.5", "9.5", "hearing of 4 May"),
        ("007", "q1.v_B", "0", "4", "hearing of 4 May"),
    ]


def test_the_log_grows_and_is_kept(marked: Path) -> None:
    change(marked, "MARKS", "MARKS2", "wider.toml", "=hearing")
    change(marked, "MARKS2", "MARKS3", "kinder.toml", "S8, by letter")
    first = log(marked, "MARKS2")
    assert {row[-1] for row in first} == {"'=hearing"}
    assert log(marked, "MARKS3") == [
        *first,
        ("S8", "total", "6.5", "9.5", "S8, by letter"),
        ("S8", "q1.omega_AB", "0", "3", "S8, by letter"),
    ]
    kept = "--never-lower", marked / "MARKS3", "--policy", marked / "kinder.toml"
    assert grade(marked, "MARKS4", *kept).exit_code == 0
    assert log(marked, "MARKS4") == log(marked, "MARKS3")
    merged = kinegrade("merge", marked / "MARKS4", "-o", marked / "ALL")
    assert merged.exit_code == 0, merged.stderr
    assert log(marked, "ALL") == log(marked, "MARKS3")


def test_a_log_is_never_replaced_by_a_marking_without_it(marked: Path) -> None:
    change(marked, "MARKS", "MARKS2", "wider.toml", "hearing")
    before = log(marked, "MARKS2")
    done = grade(marked, "MARKS2", "--force")
    assert done.exit_code == 2
    assert "changes.csv: this log of changes would be lost - add --since" in done.stderr
    assert log(marked, "MARKS2") == before
    since = "--since", marked / "MARKS2", "--reason", "back again"
    assert grade(marked, "MARKS2", "--force", *since).exit_code == 0
    assert log(marked, "MARKS2")[: len(before)] == before
    assert log(marked, "MARKS2")[-1] == ("007", "q1.v_B", "4", "0", "back again")


@pytest.mark.parametrize(("since", "reason"), [("", "why"), ("MARKS", ""), ("MARKS", "  ")])
def test_a_change_has_an_earlier_marking_and_a_reason(
    marked: Path, since: str, reason: str
) -> None:
    earlier = ("--since", marked / since) if since else ()
    done = grade(marked, "MARKS2", "--reason", reason, *earlier)
    assert done.exit_code == 2
    assert "--since and --reason: changes are logged by both together" in done.stderr
    assert not (marked / "MARKS2").exists()


def test_an_explanation_tells_what_was_changed(marked: Path) -> None:
    change(marked, "MARKS", "MARKS2", "wider.toml", "hearing of 4 May")
    said = kinegrade("explain", marked / "EXAM", marked / "MARKS2", "007").output
    today = date.today().isoformat()
    assert f"Changed on {today}: total 5.5 -> 9.5, hearing of 4 May\n" in said
    changes = marked / "MARKS2" / "changes.csv"
    same = changes.read_text(encoding="utf-8").replace(",5.5,9.5,", ",9.5,9.5,")
    changes.write_text(same, encoding="utf-8")
    said = kinegrade("explain", marked / "EXAM", marked / "MARKS2", "007").output
    assert "total 9.5 -> 9.5" not in said
    assert f"Changed on {today}: q1.v_B 0 -> 4, " in said
    assert "Changed" not in kinegrade("explain", marked / "EXAM", marked / "MARKS2", "S9").output


def test_a_log_that_another_marking_wrote_meanwhile_stays(
    marked: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def read_late(*arguments: Any) -> ClassFiles:
        monkeypatch.undo()
        since = "--since", marked / "MARKS", "--reason", "hearing"
        done = grade(marked, "MARKS", "--policy", marked / "wider.toml", "--force", *since)
        assert done.exit_code == 0, done.stderr
        return read_class(*arguments)

    monkeypatch.setattr(marking, "read_class", read_late)
    done = grade(marked, "MARKS", "--force")
    assert done.exit_code == 2
    assert "MARKS: changed while this command ran, perhaps by another one; " in done.stderr
    assert [row[-1] for row in log(marked, "MARKS")] == ["hearing", "hearing"]
