"""`check` says where a point lies beyond the ends of the bar on whose line it slides."""

from __future__ import annotations

import re

import pytest

from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.library.starter import write_starter_text
from kinegrade.problem.template.template import Template
from kinegrade.proof.checking import check
from kinegrade.proof.ends import note_points_beyond_ends
from tests.said import all_said


def rocker(length: str) -> Template:
    """The starter, a crank whose block slides in the slot CB, with another length CB."""
    text = write_starter_text()
    assert 'l = "3/2*(b + r)"' in text
    return read_template("rocker", text.replace('l = "3/2*(b + r)"', f'l = "{length}"'))


def note(template: Template, *angles: str) -> list[str]:
    solutions = [solve_template(template, {"phi": angle}, ()) for angle in angles]
    words = open_catalogue(ENGLISH)
    return [words.write(each) for each in note_points_beyond_ends(template, solutions)]


def test_a_block_beyond_the_end_of_its_slot_is_noted_with_what_keeps_it_inside() -> None:
    (remark,) = note(rocker("b"), "-30", "30", "60")
    assert remark == (
        "A lies beyond the ends of CB, the line of the body CB, in 2 of 3 instances: a condition "
        "such as distance(C, A) < distance(C, B) keeps it between them"
    )


def test_no_condition_is_named_that_would_leave_no_draw() -> None:
    (remark,) = note(rocker("b"), "30", "60")
    assert remark == (
        "A lies beyond the ends of CB, the line of the body CB, in all 2 instances: a longer bar or "
        "other domains bring it between them; where the bar goes on there, give CB a point beyond A"
    )


def test_a_slot_on_the_other_side_of_its_pivot_than_the_arm_is_meant() -> None:
    """The quick-return of Whitworth: the arm CB is in line with the slot, away from it."""
    text = rocker("b").file.text
    placed = re.sub(r"^B = .*$", 'B = "toward(C, A, -l)"', text, flags=re.MULTILINE)
    assert placed != text
    assert note(read_template("rocker", placed), "30", "60") == []


def test_the_condition_that_is_named_keeps_the_block_inside() -> None:
    text = write_starter_text().replace('l = "3/2*(b + r)"', 'l = "b"')
    kept = re.sub(r"conditions = \[.*\]", 'conditions = ["distance(C, A) < distance(C, B)"]', text)
    report = check(read_template("rocker", kept), sample=40)
    assert [each for each in all_said(report.remarks) if "lies beyond" in each] == []
    assert report.refused["condition"] > 0


@pytest.mark.parametrize("length", ["3/2*(b + r)", "b + r"])
def test_a_block_that_stays_inside_or_reaches_the_end_is_not_noted(length: str) -> None:
    assert note(rocker(length), "-30", "30", "60", "210") == []


def test_a_slot_by_the_angle_of_a_given_has_no_ends() -> None:
    text = write_starter_text().replace("line(C, B) of CB", "line(C, phi) of CB")
    assert note(read_template("rocker", text), "90") == []


def test_check_remarks_it() -> None:
    remarks = all_said(check(rocker("b"), sample=12).remarks)
    assert any("A lies beyond the ends of CB" in remark for remark in remarks), remarks


@pytest.mark.parametrize("name", find_template_names())
def test_no_template_that_is_shipped_has_such_a_point_at_its_own_values(name: str) -> None:
    template = load_template(name)
    solution = solve_template(template, {}, ())
    assert list(note_points_beyond_ends(template, [solution])) == []


@pytest.mark.parametrize("line", ["line(C, A)", "line(A, C)", "line(A, B)", "line(B, C)"])
def test_it_is_noted_however_the_line_of_the_slot_is_spelled(line: str) -> None:
    text = rocker("b").file.text
    assert text.count("line(C, B)") == 1
    spelled = read_template("rocker", text.replace("line(C, B)", line))
    assert note(spelled, "-30", "30", "60") == note(rocker("b"), "-30", "30", "60")


def crank_with_mark(place: str, points: str) -> Template:
    """The starter with a point M of its crank."""
    text = write_starter_text()
    assert 'OA = "O A"' in text
    placed = text.replace("[bodies]", f'M = "{place}"\n[bodies]')
    return read_template("rocker", placed.replace('OA = "O A"', f'OA = "{points}"'))


@pytest.mark.parametrize(
    ("place", "points", "noted"),
    [
        ("toward(O, A, 2*r)", "O M A", True),
        ("toward(A, O, -r)", "O M A", True),
        ("toward(O, A, r/2)", "O M A", False),
        ("toward(O, A, 2*r)", "O A M", False),  # said to lie beyond
    ],
)
def test_a_point_placed_beyond_the_end_of_its_bar_is_noted(
    place: str, points: str, noted: bool
) -> None:
    remarks = note(crank_with_mark(place, points), "30", "60")
    said = "M lies beyond the ends of OA, the line of the body OA, in all 2 instances"
    assert [each.split(":")[0] for each in remarks] == [said] * noted


def test_a_point_that_is_beyond_the_end_at_some_values_alone_is_noted() -> None:
    template = crank_with_mark("toward(O, A, r*phi)", "O A M")
    assert "in 1 of 2 instances" in "".join(note(template, "30", "60"))


@pytest.mark.parametrize(("rod", "noted"), [("l_OA", True), ("2*l_OA", False)])
@pytest.mark.parametrize("points", ["A B C", "A C"])
def test_a_sleeve_beyond_the_end_of_the_rod_that_passes_it_is_noted(
    rod: str, noted: bool, points: str
) -> None:
    """AB is 50 cm and l_OA 30 cm."""
    text = load_template("crank-bar-through-sleeve-with-arm").file.text
    placed = text.replace("[bodies]", f'C = "toward(A, B, {rod})"\n[bodies]')
    own = placed.replace('AC = "A B"', f'AC = "{points}"')
    template = read_template("sleeve", re.sub(r"v_Bp.*|a_Bp.*|\[\[published(.|\n)*", "", own))
    solution = solve_template(template, {}, ())
    said = [each.split(",")[0] for each in all_said(note_points_beyond_ends(template, [solution]))]
    assert said == ["B lies beyond the ends of AC"] * noted
