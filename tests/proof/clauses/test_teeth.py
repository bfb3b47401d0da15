"""`check` finds tooth counts that stand at another gear in the joints than in words."""

from __future__ import annotations

import pytest

from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.clauses.teeth import find_misplaced_teeth
from tests.said import all_said

GEARS = """family = "gears"
source = "worked out by hand"
language = "en"
title = "T"
statement = "{{ k }} {{ l }} {{ m }} {{ n }}"
joints = [
  "pin A: ground one",
  "pin B: ground two",
  "circle(A, m*K/2) of one meshes with circle(B, m*L/2) of two on ground",
]
inputs = [{ motion = "one turns", velocity = "n" }]
[parameters]
m = { unit = "mm", draw = [4], means = "module" }
k = { unit = "1", draw = [20], means = "number of teeth of gear 1" }
l = { unit = "1", draw = [30], means = "MEANS" }
n = { unit = "rpm", draw = [10], means = "speed" }
[points]
A = "(0, 0)"
B = "(m*(k + l)/2, 0)"
[bodies]
one = "A"
two = "B"
[asks]
found = { quantity = "omega(two)", unit = "rpm", points = 1, means = "a" }
[figure]
labels = { one = "1", two = "2" }
"""


@pytest.mark.parametrize("means", ["number of teeth of gear 2", "teeth of wheel $B$"])
def test_a_tooth_count_at_another_gear_is_a_fault(means: str) -> None:
    def find(*counts: str) -> list[str]:
        text = GEARS.replace("K", counts[0]).replace("L", counts[1]).replace("MEANS", means)
        return all_said(find_misplaced_teeth(read_template("gears", text)))

    assert find("k", "l") == []
    assert find("l", "k") == [
        f"{name} is said to be of {meant}, and the joints have it as a radius of {actual} alone: "
        "exchange the letters in the joint, or the words"
        for name, meant, actual in (("k", "one", "two"), ("l", "two", "one"))
    ]


def test_teeth_of_no_gear_in_particular_may_stand_anywhere() -> None:
    text = GEARS.replace("K", "l").replace("L", "k").replace("gear 1", "a gear")
    text = text.replace("MEANS", "number of teeth of the other one")
    assert all_said(find_misplaced_teeth(read_template("gears", text))) == []
