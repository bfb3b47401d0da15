"""Weights and plans that do not fit a term are refused, all faults at once."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.grading.term.marked_exams import PLAN, run
from tests.small_class import kinegrade, table


def test_weights_may_stand_on_the_command_line(marked: Path, tmp_path: Path) -> None:
    output = tmp_path / "term.csv"
    weights = "HW1=30 %", "HW2=0.2", "FINAL=1/2"
    wishes = [word for each in weights for word in ("--weight", each)]
    assert run(marked, output, *wishes).exit_code == 0
    assert [row["total"] for row in table(output)] == ["80", "30", "", "50"]
    assert "grade" not in table(output)[0]


def test_without_weights_every_exam_counts_the_same_and_that_is_said(
    marked: Path, tmp_path: Path
) -> None:
    done = run(marked, tmp_path / "term.csv")
    assert "no weights are given: all 3 count the same" in done.stderr
    assert [row["total"] for row in table(tmp_path / "term.csv")] == ["66.67", "33.33", "", "33.33"]


@pytest.mark.parametrize(
    ("weights", "said"),
    [
        (["HW1=30 %", "HW2=30 %", "FINAL=30 %"], ["the weights add up to 90 %, not to 100 %"]),
        (["HW1=30 %", "FINAL=70 %"], ["no weight for HW2"]),
        (["HW1=much", "HW2"], ['"much"', '"HW2"']),
        (
            ["HW1=20 %", "HW1=20 %", "HW2=30 %", "FINLA=20 %"],
            ['"HW1" counts twice', 'no marks "FINLA"', "FINAL", "add up to 90 %"],
        ),
    ],
)
def test_weights_that_do_not_fit_are_all_told(
    marked: Path, tmp_path: Path, weights: Sequence[str], said: Sequence[str]
) -> None:
    wishes = [word for each in weights for word in ("--weight", each)]
    done = run(marked, tmp_path / "term.csv", *wishes)
    assert done.exit_code == 2
    assert not (tmp_path / "term.csv").exists()
    assert [each for each in said if each not in done.stderr] == []


@pytest.mark.parametrize(
    ("plan", "said"),
    [
        ("", ["parts: missing"]),
        ("[parts.FINAL]\nwait = 1", ["parts.FINAL.wait: unknown key"]),
        ("[parts.FINAL]\nmarks = []\nweight = 1", ["no marks"]),
        (PLAN.replace("best = 1", "best = 3"), ["the best 3 of 2"]),
        (PLAN.replace('"60 %"', '"50 %"').replace('"HW2"', '"HWII"'),
         ['no marks "HWII"', "no weight for HW2", "add up to 90 %"]),
        (PLAN.replace('"german"', '"french"'), ["scale.kind"]),
    ],
)  # fmt: skip
def test_a_plan_that_does_not_fit_is_refused(
    marked: Path, tmp_path: Path, plan: str, said: Sequence[str]
) -> None:
    done = run(marked, tmp_path / "term.csv", plan=plan)
    assert done.exit_code == 2
    assert [each for each in said if each not in done.stderr] == []
    assert "plan.toml" in done.stderr


def test_a_plan_and_weights_contradict_each_other(marked: Path, tmp_path: Path) -> None:
    done = run(marked, tmp_path / "term.csv", "--weight", "HW1=1", plan=PLAN)
    assert done.exit_code == 2
    assert "--plan and --weight" in done.stderr


def test_a_file_of_another_kind_is_refused(marked: Path, tmp_path: Path) -> None:
    done = run(marked, tmp_path / "term.ods", plan=PLAN)
    assert done.exit_code == 2
    assert ".xlsx or .csv" in done.stderr


def test_marks_are_given_once(marked: Path, tmp_path: Path) -> None:
    marks = marked / "HW1" / "MARKS"
    done = kinegrade("term", marks, marks, "-o", tmp_path / "term.csv")
    assert done.exit_code == 2
    assert f"{marks}: given twice" in done.stderr


def test_an_exam_in_place_of_marks_is_named(marked: Path, tmp_path: Path) -> None:
    done = kinegrade("term", marked / "HW1" / "EXAM", "-o", tmp_path / "term.csv")
    assert done.exit_code == 2
    assert "MARKS" in done.stderr
