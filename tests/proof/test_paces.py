"""`check` tells a sense without a verb, a pace that the signs of an input contradict, and a motion
that is said to be relative to another body.
"""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.claims.claims import find_false_claims
from tests.problem.turning_crank import CRANK
from tests.said import all_said

GIVEN = '[parameters]\neps = { unit = "rad/s^2", draw = [DRAW], means = { en = "e", zh = "e" } }'


def find(said: str, acceleration: str = "eps", draw: str = "3") -> list[str]:
    """What is contradicted in a statement of the crank, which turns counter-clockwise and gets
    faster; the last instance has the last of the values drawn.
    """
    text = CRANK.replace('en = "{{ r }} ', f'en = "{said}; {{{{ r }}}} ')
    text = text.replace(
        'velocity = "omega"', f'velocity = "omega", acceleration = "{acceleration}"'
    )
    template = read_template("crank", text.replace("[parameters]", GIVEN.replace("DRAW", draw)))
    values = ({"eps": each} for each in draw.split(", "))
    solved = [solve_template(template, each, ()) for each in values]
    return all_said(find_false_claims(template, solved))


@pytest.mark.parametrize(
    ("said", "right", "wrong"),
    [
        ("the wheel $W$ %s with the speed {{ omega }}", "counter-clockwise", "clockwise"),
        (
            "das Rad $W$ %s mit der Drehzahl {{ omega }}",
            "gegen den Uhrzeigersinn",
            "im Uhrzeigersinn",
        ),
        ("轮 $W$ %s，以角速度 {{ omega }}", "逆时针", "顺时针"),
        ("the angular acceleration {{ eps }} %s", "counter-clockwise", "clockwise"),
        ("die Winkelbeschleunigung {{ eps }} %s", "gegen den Uhrzeigersinn", "im Uhrzeigersinn"),
        ("角加速度为 {{ eps }}（%s）", "逆时针", "顺时针"),
    ],
)
def test_a_sense_is_read_without_a_verb(said: str, right: str, wrong: str) -> None:
    assert find(said % right) == []
    assert [each.count("go the other way") for each in find(said % wrong)] == [1]


@pytest.mark.parametrize(
    ("said", "right", "wrong"),
    [
        ("{{ omega }}, which %s with the angular acceleration {{ eps }}", "increases", "decreases"),
        ("{{ omega }}, die mit der Winkelbeschleunigung {{ eps }} %s", "zunimmt", "abnimmt"),
        ("角速度为 {{ omega }}，角加速度为 {{ eps }}（与角速度%s）", "同向", "反向"),
        ("以角加速度 {{ eps }} %s转动", "加速", "减速"),
        ("{{ omega }} and {{ eps }} in the %s sense", "same", "opposite"),
        ("{{ omega }}, and it is %s, namely by {{ eps }}", "speeding up", "slowing down"),
        ("its %s, and that by {{ eps }}", "speed is growing", "speed is falling"),
        ("sie wird %s, und zwar um {{ eps }}", "schneller", "gebremst"),
    ],
)
def test_a_pace_that_the_signs_contradict_is_a_fault(said: str, right: str, wrong: str) -> None:
    assert find(said % right) == find(said % wrong, "-eps") == []
    (fault,) = find(said % wrong)
    assert fault.endswith(
        "and the signs of the velocity and the acceleration in the input say the contrary: correct "
        "the word, or the sign"
    )


def test_a_pace_that_some_values_contradict_is_a_fault() -> None:
    assert find("which increases with {{ eps }}", draw="3, -3") == [
        'statement: it says "increases with {{ eps }}", and the velocity and the acceleration of the '
        "input have other signs in some instances: the slot of the input, as {{ OA.turning }}, says "
        "it at each value"
    ]


@pytest.mark.parametrize(
    "said",
    [
        "the length increases with the angle; {{ eps }}",
        "slowing down or speeding up, as the case may be, by {{ eps }}",
        "slowing down, it turns at {{ omega }}",
        "which decreases with the radius {{ r }}",
        "{{ omega }}, und {{ eps }} nimmt ab",
        "以角加速度 {{ eps }} 转动",
    ],
)
def test_what_says_nothing_of_an_input_is_no_pace(said: str) -> None:
    assert find(said) == []


@pytest.mark.parametrize(
    "said",
    [
        "turns relative to $OM$ with {{ omega }}",
        "dreht sich relativ zu $OM$ mit {{ omega }}",
        "相对于 $OM$ 以角速度 {{ omega }} 转动",
    ],
)
def test_a_motion_that_is_said_to_be_relative_and_is_not_is_a_fault(said: str) -> None:
    (fault,) = find(said)
    assert fault.endswith(
        'and the input drives it relative to the ground: write "relative to BODY" in the input, or '
        "leave the words out"
    )
