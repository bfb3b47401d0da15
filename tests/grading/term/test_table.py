"""`kinegrade term`: one table of marks, with those who are excused."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest
from openpyxl import load_workbook

from kinegrade.errors import PolicyError
from kinegrade.marks_folder.rows import ClassTotals
from kinegrade.reports.term.excuses import find_present_ids, require_excusable
from tests.grading.term.marked_exams import PLAN, run
from tests.small_class import table


def test_a_term_is_one_table(marked: Path, tmp_path: Path) -> None:
    output = tmp_path / "term.csv"
    done = run(marked, output, plan=PLAN)
    assert done.exit_code == 0, done.stderr
    rows = [tuple(row.values()) for row in table(output)]
    assert list(table(output)[0]) == [
        "student", "name", "HW1", "HW2", "FINAL", "homework", "total", "grade", "status",
    ]  # fmt: skip
    assert rows == [
        ("7", "Student 7", "100", "0", "100", "100", "100", "1.0", "marked"),
        ("8", "Student 8", "100", "absent", "0", "100", "40", "5.0", "partly"),
        ("10", "Student 10", "absent", "absent", "absent", "", "", "n.e.", "absent"),
        ("=9", "Student =9", "-", "-", "100", "0", "60", "3.3", "partly"),
    ]
    assert done.stderr.splitlines() == [
        "HW1: 2 students were there, 1 absent, 1 not listed",
        "HW2: 1 student was there, 2 absent, 1 not listed",
        "FINAL: 3 students were there, 1 absent, 0 not listed",
        "4 students: 1 sat all, 2 some, 1 none",
        "grades: 2 of 3 passed",
    ]


def test_a_workbook_has_numbers_and_texts_that_run_as_no_formula(
    marked: Path, tmp_path: Path
) -> None:
    output = tmp_path / "term.xlsx"
    assert run(marked, output, "--ranks", plan=PLAN).exit_code == 0
    sheet = load_workbook(output)["term"]
    rows = [[cell.value for cell in row] for row in sheet.iter_rows()]
    assert rows[0][-3:] == ["grade", "rank", "status"]
    assert rows[1] == ["7", "Student 7", 100, 0, 100, 100, 100, "1.0", 1, "marked"]
    assert rows[2][-3:] == ["5.0", 3, "partly"]
    assert rows[3][-3:] == ["n.e.", None, "absent"]
    assert sheet["A5"].value == "=9"
    assert sheet["A5"].data_type == "s"


EXCUSED = """
[excused]
HW2 = ["8"]
HW1 = ["=9"]
"""


def test_a_plan_says_who_is_excused_from_what(marked: Path, tmp_path: Path) -> None:
    output = tmp_path / "term.csv"
    done = run(marked, output, plan=PLAN.replace("best = 1", "best = 2") + EXCUSED)
    assert done.exit_code == 0, done.stderr
    rows = {row["student"]: tuple(row.values())[2:] for row in table(output)}
    assert rows == {
        "7": ("100", "0", "100", "50", "80", "2.0", "marked"),
        "8": ("100", "excused", "0", "100", "40", "5.0", "marked"),
        "10": ("absent", "absent", "absent", "", "", "n.e.", "absent"),
        "=9": ("excused", "-", "100", "", "100", "1.0", "partly"),
    }
    assert done.stderr.splitlines()[:6] == [
        "HW1: 2 students were there, 1 absent, 0 not listed",
        "HW1: 1 student is excused",
        "HW2: 1 student was there, 1 absent, 1 not listed",
        "HW2: 1 student is excused",
        "FINAL: 3 students were there, 1 absent, 0 not listed",
        "4 students: 2 sat all, 1 some, 1 none",
    ]


def test_an_old_id_in_a_plan_is_that_of_the_student_whom_the_marks_know(tmp_path: Path) -> None:
    now = {"A": {"old": "mid"}, "B": {"old": "new", "mid": "new", "x": "p"}, "C": {"x": "q"}}
    exams = {name: ClassTotals((), ()) for name in "ABCD"}
    assert find_present_ids({"A": frozenset({"old"})}, exams, now) == {"A": frozenset({"mid"})}
    assert find_present_ids({"D": frozenset({"mid"})}, exams, now) == {"D": frozenset({"new"})}
    either = find_present_ids({"D": frozenset({"x"})}, exams, now)
    assert either == {"D": frozenset({"x"})}
    with pytest.raises(PolicyError) as refused:
        require_excusable(tmp_path / "plan.toml", either, {}, exams, now)
    assert '"x" is "p" or "q" now' in str(refused.value)


def test_a_part_from_which_a_student_is_excused_is_empty(marked: Path, tmp_path: Path) -> None:
    output = tmp_path / "term.csv"
    excused = '[excused]\nHW1 = ["=9"]\nHW2 = ["=9", "8"]\n'
    assert run(marked, output, plan=PLAN + excused).exit_code == 0
    (row,) = (row for row in table(output) if row["student"] == "=9")
    assert tuple(row.values())[2:] == ("excused", "excused", "100", "", "100", "1.0", "marked")


@pytest.mark.parametrize(
    ("excused", "said"),
    [
        ('HWII = ["8"]', ['excused.HWII: no marks "HWII"']),
        ("HW2 = 8", ["excused.HW2: 8"]),
        ("HW2 = [8]", ["excused.HW2[1]: 8"]),
        ('HW2 = ["88", "7"]\nFINAL = ["8"]', [
            'excused.HW2: no student "88" in any of the marks',
            'excused.HW2: "7" has sat HW2 - expected students who have not - leave this one out, so '
            "that the points count, or set the exam aside for this student under [set-aside]",
            'excused.FINAL: "8" has sat FINAL',
        ]),
    ],
)  # fmt: skip
def test_excuses_that_do_not_fit_are_all_told(
    marked: Path, tmp_path: Path, excused: str, said: Sequence[str]
) -> None:
    done = run(marked, tmp_path / "term.csv", plan=f"{PLAN}\n[excused]\n{excused}\n")
    assert done.exit_code == 2
    assert [each for each in said if each not in done.stderr] == []
    assert [line for line in done.stderr.splitlines() if "plan.toml" not in line] == []
    assert not (tmp_path / "term.csv").exists()


def test_an_exam_that_a_student_sat_may_be_set_aside(marked: Path, tmp_path: Path) -> None:
    output = tmp_path / "term.csv"
    stated = '[excused]\nHW2 = ["8"]\n\n[set-aside]\nHW2 = ["7"]\n'
    done = run(marked, output, plan=PLAN.replace("best = 1", "best = 2") + stated)
    assert done.exit_code == 0, done.stderr
    rows = {row["student"]: tuple(row.values())[2:] for row in table(output)}
    assert rows["7"] == ("100", "excused", "100", "100", "100", "1.0", "marked")
    assert rows["8"][:2] == ("100", "excused")
    assert "HW2: 2 students are excused" in done.stderr


def test_an_exam_is_set_aside_for_known_students_alone(marked: Path, tmp_path: Path) -> None:
    stated = '[set-aside]\nHWII = ["7"]\nHW2 = ["88"]\n'
    done = run(marked, tmp_path / "term.csv", plan=PLAN + stated)
    assert done.exit_code == 2
    assert 'set-aside.HWII: no marks "HWII"' in done.stderr
    done = run(marked, tmp_path / "term.csv", plan=PLAN + '[set-aside]\nHW2 = ["88"]\n')
    assert done.exit_code == 2
    assert 'set-aside.HW2: no student "88" in any of the marks' in done.stderr


def test_the_same_marks_give_the_same_bytes(marked: Path, tmp_path: Path) -> None:
    run(marked, tmp_path / "a.xlsx", plan=PLAN)
    run(marked, tmp_path / "b.xlsx", plan=PLAN)
    assert (tmp_path / "a.xlsx").read_bytes() == (tmp_path / "b.xlsx").read_bytes()
