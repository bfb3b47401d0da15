"""The total of a term, exact: weights, the best of some, who is excused."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from time import process_time

from kinegrade.grade_scale.scale import Scale, Step
from kinegrade.marks_folder.rows import ClassTotals
from kinegrade.reports.term.plan import Part, Plan, plan_evenly
from kinegrade.reports.term.split_students import find_split_students
from tests.grading.marked_folder import RIGHT, mark_class
from tests.grading.term.marked_exams import SCALE, WRONG, exams, results, total
from tests.said import all_said
from tests.small_class import kinegrade


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


def test_a_part_without_another_exam_that_lists_the_excused_does_not_count() -> None:
    plan = Plan(
        (
            Part("homework", ("H1", "F2"), Fraction(1, 4), 1),
            Part("FINAL", ("FINAL",), Fraction(3, 4), 1),
        ),
        excused={"H1": frozenset("12")},
    )
    final = {"1": "5", "2": "5", "3": "5"}
    found = results(exams(H1={"1": None, "3": "8"}, F2={"2": None}, FINAL=final), plan)
    assert (found["1"].total, found["1"].parts["homework"]) == (Fraction(1, 2), None)
    assert found["2"].total == Fraction(1, 2) * 3 / 4  # missed F2, where the name is on the list
    assert found["3"].total == Fraction(8, 10) / 4 + Fraction(1, 2) * 3 / 4


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
