"""`check` tells a sense in words that no instance has, wherever the sentence says it."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.claims.claims import find_false_claims
from tests.problem.turning_crank import CRANK
from tests.said import all_said

TURNS = [
    ("turns about the fixed pin $O$ %s with the constant rate {{ omega }}", "clockwise"),
    ("turns about $O$ with the constant angular velocity {{ omega }} %s", "clockwise"),
    ("turns %s about $O$. Its angular velocity is {{ omega }}", "clockwise"),
    ("turns about $O$ at a %s angular velocity of {{ omega }}", "clockwise"),
    ("is driven at {{ omega }}, %s", "clockwise"),
    ("dreht sich mit der Winkelgeschwindigkeit {{ omega }} %s um $O$", "im Uhrzeigersinn"),
    ("die sich %s mit {{ omega }} dreht", "im Uhrzeigersinn"),
    ("dreht sich %s um $O$. Ihre Winkelgeschwindigkeit ist {{ omega }}", "im Uhrzeigersinn"),
    ("以角速度 {{ omega }} 绕 $O$ %s转动", "顺时针"),
    ("%s以角速度 {{ omega }} 绕 $O$ 转动", "顺时针"),
    ("绕 $O$ %s转动，角速度为 {{ omega }}", "顺时针"),
]
OTHERS = {
    "clockwise": "counter-clockwise",
    "im Uhrzeigersinn": "gegen den Uhrzeigersinn",
    "顺时针": "逆时针",
}


SLIDER = """family = "slider"
source = "worked out by hand"
language = "en"
title = "T"
statement = "SAID ({{ r }})"
joints = ["B of B slides on line(O, 0)", "B translates"]
inputs = [{ motion = "B of B moves along +x", velocity = "v" }]
[parameters]
r = { unit = "m", draw = [1], means = "distance" }
v = { unit = "m/s", draw = [2], means = "speed" }
[points]
O = "(0, 0)"
B = "(r, 0)"
[bodies]
B = "B"
[asks]
v_B = { quantity = "x(velocity(B))", unit = "m/s", sign = "+x", points = 1, means = "velocity" }
"""


def find(said: str) -> list[str]:
    """What is contradicted in the statement of the crank."""
    return read(CRANK.replace('en = "{{ r }} ', f'en = "{said}; {{{{ r }}}} '))


def read(text: str) -> list[str]:
    """What the statement of a template says and is not so."""
    template = read_template("crank", text)
    return all_said(find_false_claims(template, [solve_template(template, {}, ())]))


@pytest.mark.parametrize(("sentence", "wrong"), TURNS)
def test_a_sense_of_rotation_is_read_wherever_it_stands(sentence: str, wrong: str) -> None:
    assert [each.count("all instances go the other way") for each in find(sentence % wrong)] == [1]
    assert find(sentence % OTHERS[wrong]) == []


@pytest.mark.parametrize(
    "sentence",
    [
        "turns with {{ omega }} and the angle is counted clockwise",
        "turns counter-clockwise; $OM$ lies clockwise of $OA$. It has {{ omega }}",
        "dreht sich mit {{ omega }}, der Winkel wird im Uhrzeigersinn gezählt",
        "以角速度 {{ omega }} 转动，由 $OA$ 顺时针量取的角",
    ],
)
def test_the_sense_of_an_angle_is_none_of_a_rotation(sentence: str) -> None:
    assert find(sentence) == []


@pytest.mark.parametrize(
    ("sentence", "right", "wrong"),
    [
        ("The block slides on the line %s with {{ v }}", "to the right", "to the left"),
        ("The block moves in its guide with the speed {{ v }} %s", "to the right", "to the left"),
        ("Der Klotz bewegt sich mit {{ v }} in der Führung %s", "nach rechts", "nach links"),
        ("滑块以速度 {{ v }} 沿导路%s运动", "向右", "向左"),
    ],
)
def test_a_sense_of_translation_is_read_too(sentence: str, right: str, wrong: str) -> None:
    assert len(read(SLIDER.replace("SAID", sentence % wrong))) == 1
    assert read(SLIDER.replace("SAID", sentence % right)) == []


def test_a_place_to_the_left_of_a_point_is_no_sense() -> None:
    said = "The block moves on the line to the left of $O$ with {{ v }}"
    assert read(SLIDER.replace("SAID", said)) == []
