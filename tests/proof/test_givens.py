"""`check` holds the words of givens against their values: teeth, inner and outer, radians."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.claims.claims import find_false_claims
from kinegrade.proof.claims.givens import note_angles_in_radians
from tests.problem.turning_crank import CRANK
from tests.said import all_said


def find(*givens: str) -> list[str]:
    """What is wrong with givens that are added to the crank, one after another."""
    added = "\n".join(["[parameters]", *givens])
    named = "".join(f"{{{{ {each.split()[0]} }}}} " for each in givens)
    text = CRANK.replace("[parameters]", added).replace(
        'en = "{{ r }} ', f'en = "{named}{{{{ r }}}} '
    )
    template = read_template("crank", text)
    faults = find_false_claims(template, [solve_template(template, {}, ())])
    return all_said([*faults, *note_angles_in_radians(template)])


def given(name: str, unit: str, draw: str, means: str) -> str:
    """A given in a template."""
    return f'{name} = {{ unit = "{unit}", draw = {draw}, means = {{ en = "{means}", zh = "{means}" }} }}'


@pytest.mark.parametrize(
    "means", ["number of teeth of the sun", "Zähnezahl des Rads", "太阳轮的齿数"]
)
def test_half_a_tooth_is_a_fault(means: str) -> None:
    assert find(given("z", "1", "[20, 20.5]", means)) == [
        "parameters.z.draw: z counts teeth, and 20.5 is no whole number: draw whole numbers"
    ]
    assert find(given("z", "1", "[20, 21]", means)) == []


def test_a_ratio_of_tooth_counts_may_be_broken() -> None:
    assert find(given("z", "1", "[2.5]", "ratio of the numbers of teeth of the gears")) == []


@pytest.mark.parametrize(
    ("inner", "outer"),
    [
        ("inner radius", "outer radius"),
        ("Radius der inneren Trommel", "Radius des äußeren Randes"),
        ("内轮半径", "外轮半径"),
    ],
)
def test_an_outer_radius_less_than_the_inner_one_is_a_fault(inner: str, outer: str) -> None:
    assert find(given("s", "cm", "[20]", inner), given("t", "m", "[0.1]", outer)) == [
        "parameters.t: t is called outer, and s, which is called inner, is larger in 1 of 1 "
        "instances: add the condition t > s, or other domains"
    ]
    assert find(given("s", "cm", "[20]", inner), given("t", "m", "[1]", outer)) == []


def test_an_angle_in_radians_with_the_numbers_of_degrees_is_noted() -> None:
    assert find(given("psi", "rad", "[30, 60]", "angle")) == [
        'psi, in rad, is more than a full turn at all its values: unit = "deg" where degrees are '
        "meant"
    ]
    assert find(given("psi", "rad", "[0.5, 30]", "angle")) == []
