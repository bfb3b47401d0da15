"""`kinegrade term`: several exams put together by weights, with the best of some, absent students
told apart, and the grade of the sum.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from time import process_time

import pytest
from click.testing import Result
from openpyxl import load_workbook

from kinegrade.errors import PolicyError
from kinegrade.grade_scale.scale import Scale, Step
from kinegrade.marks_folder.rows import ClassTotals, StudentTotal
from kinegrade.reports.term.excuses import find_present_ids, require_excusable
from kinegrade.reports.term.plan import Part, Plan, plan_evenly
from kinegrade.reports.term.results import TermResult, work_out_results
from kinegrade.reports.term.split_students import find_split_students
from tests.grading.marked_folder import RIGHT, mark_class
from tests.said import all_said
from tests.small_class import kinegrade, table

SCALE = Scale((Step("pass", Fraction(1, 2), passes=True), Step("fail", Fraction(0), passes=False)))
WRONG = ("9", "9", "9")


def total(student: str, points: str | None, out_of: int = 10) -> StudentTotal:
    """A student's total; None for one who was absent."""
    status = "absent" if points is None else "marked"
    got = Fraction(points or 0)
    return StudentTotal(2, student, f"N{student}", {}, got, Fraction(out_of), None, status, None)


def exams(**points: Mapping[str, str | None]) -> Mapping[str, ClassTotals]:
    """Exams of 10 points by name, each with the points by student."""
    return {
        name: ClassTotals((), tuple(total(student, got) for student, got in each.items()))
        for name, each in points.items()
    }


def results(
    sat: Mapping[str, ClassTotals], plan: Plan, scale: Scale = SCALE
) -> Mapping[str, TermResult]:
    return {each.student: each for each in work_out_results(sat, plan, scale)}


def test_weights_are_exact() -> None:
    plan = Plan((Part("A", ("A",), Fraction(3, 10), 1), Part("B", ("B",), Fraction(7, 10), 1)))
    found = results(exams(A={"1": "5"}, B={"1": "5"}), plan)["1"]
    assert (found.total, found.grade) == (Fraction(1, 2), "pass")
    found = results(exams(A={"1": "5"}, B={"1": "4.9999"}), plan)["1"]
    assert found.grade == "fail"


def test_the_best_of_some_count_and_a_missed_one_counts_as_nothing() -> None:
    plan = Plan((Part("homework", ("A", "B", "C"), Fraction(1), 2),))
    sat = exams(A={"1": "10", "2": "8"}, B={"1": "0", "2": None}, C={"1": "6"})
    found = results(sat, plan)
    assert found["1"].total == Fraction(8, 10)
    assert found["2"].total == Fraction(4, 10)
    assert (set(found["2"].sat), set(found["2"].listed)) == ({"A"}, {"A", "B"})


def test_what_a_student_is_excused_from_does_not_count() -> None:
    plan = Plan(
        (
            Part("homework", ("A", "B", "C"), Fraction(1, 4), 2),
            Part("FINAL", ("FINAL",), Fraction(3, 4), 1),
        ),
        excused={"B": frozenset("12"), "C": frozenset("1"), "FINAL": frozenset("2")},
    )
    sat = exams(
        A={"1": "8", "2": "6", "3": "6"}, B={"3": "6", "1": None}, C={"2": "2"},
        FINAL={"1": "4", "2": None, "3": "10"},
    )  # fmt: skip
    found = results(sat, plan)
    assert found["1"].total == Fraction(8, 10) / 4 + Fraction(4, 10) * 3 / 4
    assert found["2"].total == Fraction(4, 10)  # the homework alone
    assert (found["2"].parts["homework"], found["2"].parts["FINAL"]) == (Fraction(4, 10), None)
    assert found["3"].total == Fraction(6, 10) / 4 + Fraction(3, 4)


def test_thirds_of_points_reach_their_bound_where_a_part_does_not_count() -> None:
    third = Scale((Step("A", Fraction(1, 3), passes=True), Step("B", Fraction(0), passes=False)))
    written = {"A": ClassTotals((), (total("1", "0.3333", 1),)), "B": ClassTotals((), ())}
    plan = replace(plan_evenly(("A", "B")), excused={"B": frozenset("1")})
    assert results(written, plan, third)["1"].grade == "A"


def test_whoever_is_excused_from_everything_is_absent() -> None:
    plan = replace(plan_evenly(("A",)), excused={"A": frozenset("1")})
    found = results(exams(A={"1": None}), plan, Scale(SCALE.steps, "NE"))["1"]
    assert (found.total, found.grade) == (0, "NE")


def test_exams_of_other_maxima_count_by_their_share() -> None:
    sat = {
        "A": ClassTotals((), (total("1", "15", 20),)),
        "B": ClassTotals((), (total("1", "1", 4),)),
    }
    assert results(sat, plan_evenly(("A", "B")))["1"].total == Fraction(1, 2)


def test_whoever_sat_nothing_has_the_word_for_absent() -> None:
    scale = Scale(SCALE.steps, "NE")
    found = results(exams(A={"1": None}, B={"1": None, "2": "0"}), plan_evenly(("A", "B")), scale)
    assert (found["1"].grade, found["2"].grade) == ("NE", "fail")


def test_thirds_of_points_reach_the_bound_that_they_reach() -> None:
    """1/3 of a point is written 0.3333, which is below a third."""
    third = Scale((Step("A", Fraction(1, 3), passes=True), Step("B", Fraction(0), passes=False)))
    written = {"A": ClassTotals((), (total("1", "0.3333", 1),))}
    assert results(written, plan_evenly(("A",)), third)["1"].grade == "A"
    less = {"A": ClassTotals((), (total("1", "0.3332", 1),))}
    assert results(less, plan_evenly(("A",)), third)["1"].grade == "B"


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """HW1, HW2 and FINAL, each with MARKS; 7 sat all, 8 missed HW2, =9 is in the FINAL alone, 10
    was nowhere.
    """
    folder = tmp_path_factory.mktemp("term")
    mark_class(folder / "HW1", {"7": RIGHT, "8": RIGHT, "10": ()})
    mark_class(folder / "HW2", {"7": WRONG, "8": (), "10": ()})
    mark_class(folder / "FINAL", {"7": RIGHT, "8": WRONG, "10": (), "=9": RIGHT})
    return folder


PLAN = """[parts.homework]
marks = ["HW1", "HW2"]
best = 1
weight = "40 %"

[parts.FINAL]
weight = "60 %"

[scale]
kind = "german"
absent = "n.e."
"""


def run(folder: Path, output: Path, *options: str | Path, plan: str | None = None) -> Result:
    """`kinegrade term` for the three exams."""
    wishes = list(options)
    if plan is not None:
        file = output.parent / "plan.toml"
        file.write_text(plan, encoding="utf-8")
        wishes += ["--plan", file]
    marks = [folder / name / "MARKS" for name in ("HW1", "HW2", "FINAL")]
    return kinegrade("term", *marks, "-o", output, *wishes)


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
        "=9": ("excused", "-", "100", "0", "60", "3.3", "partly"),
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


def test_two_hundred_students_take_under_two_seconds(tmp_path: Path) -> None:
    students = {f"{number:05d}": RIGHT if number % 3 else WRONG for number in range(200)}
    folders = [mark_class(tmp_path / name, students)[1] for name in ("A", "B")]
    begin = process_time()
    assert kinegrade("term", *folders, "-o", tmp_path / "term.xlsx").exit_code == 0
    assert process_time() - begin < 2


def test_an_id_without_its_zeros_in_another_exam_is_named() -> None:
    lost = exams(HW1={"0031": "5", "0032": "4"}, HW2={"31": "5", "0032": "4"}, HW3={"0031": "1"})
    (found,) = all_said(find_split_students(lost))
    assert found == (
        '0031: "0031" (in HW1, HW3) and "31" (in HW2) differ by zeros in front alone, which '
        "spreadsheets drop - each has a line; if they are one person, neither line has all of the "
        "exams"
    )
    both = exams(HW1={"0031": "5", "31": "4"}, HW2={"31": "5"})
    assert not list(find_split_students(both))
