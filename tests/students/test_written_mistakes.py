"""Mistakes of writing a right answer down: which asks give occasion, what they lead to, and that
marks name them.
"""

from __future__ import annotations

from math import pi
from pathlib import Path

import pytest

import kinegrade
from kinegrade.problem.template.library.library import load_template
from kinegrade.students.mistaking.written_mistakes import list_answer_factors
from tests.small_class import asks_of, table
from tests.small_class import kinegrade as run
from tests.spellings import type_answers

POWERS = {
    "power-of-ten-up": 10,
    "power-of-ten-down": 0.1,
    "two-powers-of-ten-up": 100,
    "two-powers-of-ten-down": 0.01,
    "three-powers-of-ten-up": 1000,
    "three-powers-of-ten-down": 0.001,
}


@pytest.mark.parametrize(
    ("ask", "factors"),
    [
        ("v_B", {"minus-in-magnitude": -1, **POWERS}),
        ("a_B", {"sense-reversed": -1, **POWERS}),
        (
            "omega_AB",
            {
                "sense-reversed": -1,
                "degrees-per-second": 180 / pi,
                "rpm-typed": 60 / (2 * pi),
                **POWERS,
            },
        ),
        ("alpha_AB", {"sense-reversed": -1, "degrees-per-second": 180 / pi, **POWERS}),
    ],
)
def test_what_is_written_wrongly_changes_the_right_answer(
    ask: str, factors: dict[str, float]
) -> None:
    answer = kinegrade.template("slider-crank").solve(phi=30)[ask]
    written = {
        name: value / answer.value for name, value in answer.mistakes.items() if name in factors
    }
    assert written == pytest.approx(factors)
    asked = list_answer_factors(load_template("slider-crank").asks[ask])
    assert asked.keys() == factors.keys()


def test_an_angle_that_turns_round_may_be_met_again_by_a_large_number() -> None:
    ask = load_template("triangle-pose-three-frames").asks["theta_2"]
    assert ask.cyclic
    names = list_answer_factors(ask)
    assert "two-powers-of-ten-up" not in names
    assert "two-powers-of-ten-down" in names


TYPED = {  # by column the mistake of each of the four students, with its factor
    "q1.v_B": [
        ("minus-in-magnitude", -1),
        ("two-powers-of-ten-up", 100),
        ("two-powers-of-ten-down", 0.01),
        ("three-powers-of-ten-down", 0.001),
    ],
    "q3.omega_AB": [
        ("degrees-per-second", 180 / pi),
        ("rpm-typed", 30 / pi),
        ("three-powers-of-ten-up", 1000),
        ("sense-reversed", -1),
    ],
    "q3.alpha_AB": [("degrees-per-second", 180 / pi)] * 4,
}


def test_marks_name_them_and_give_no_points(small_class: Path, tmp_path: Path) -> None:
    keys = asks_of(small_class / "EXAM")
    students = list(dict.fromkeys(student for student, _ in keys))

    def type_wrongly(student: str, column: str) -> str:
        right = float(keys[student, column]["decimal"])
        if column not in TYPED:
            return f"{right:.5g}"
        return f"{right * TYPED[column][students.index(student)][1]:.5g}"

    exam, answers = small_class / "EXAM", tmp_path / "answers.csv"
    type_answers(exam, answers, type_wrongly)
    result = run("grade", exam, answers, "-o", tmp_path / "MARKS")
    assert result.exit_code == 0, result.stderr
    found = {
        (mark["student"], f"{mark['question']}.{mark['ask']}"): mark
        for mark in table(tmp_path / "MARKS" / "marks.csv")
    }
    for column, mistakes in TYPED.items():
        for student, (name, _) in zip(students, mistakes, strict=True):
            mark = found[student, column]
            assert (mark["verdict"], mark["points"]) == ("mistake", "0"), (student, column)
            assert mark["mistakes"].split() == [name], (student, column)


def test_a_policy_may_give_points_for_a_minus(small_class: Path, tmp_path: Path) -> None:
    keys = asks_of(small_class / "EXAM")
    exam, answers, policy = small_class / "EXAM", tmp_path / "answers.csv", tmp_path / "p.toml"
    type_answers(exam, answers, lambda *place: f"-{keys[place]['decimal'].lstrip('-')[:12]}")
    policy.write_text('credit.mistakes = { minus-in-magnitude = "1/3" }', encoding="utf-8")
    result = run("grade", exam, answers, "-o", tmp_path / "MARKS", "--policy", policy)
    assert result.exit_code == 0, result.stderr
    marks = table(tmp_path / "MARKS" / "marks.csv")
    assert {mark["points"] for mark in marks if mark["ask"] == "v_B"} == {"1"}
