"""`check` holds the words of asks against their quantities: another point, body or sense."""

from __future__ import annotations

import pytest

from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.library.starter import write_starter_text
from kinegrade.proof.claims.claims import find_false_claims
from tests.problem.turning_crank import changed
from tests.said import all_said


def find(means: str, quantity: str = "magnitude(velocity(A))", unit: str = "m/s") -> list[str]:
    """What is wrong with the words of an ask of the crank OA, on which M is."""
    text = changed(
        ("magnitude(velocity(A))", quantity),
        ('"m/s", means = { en = "speed", zh = "速度"', f'"{unit}", means = {{ en = "{means}"'),
    )
    return all_said(find_false_claims(read_template("crank", text.split("[[published]]")[0]), []))


@pytest.mark.parametrize(
    ("means", "said"),
    [
        ("velocity of $M$", "of $M$"),
        ("speed of the pin $M$", "of the pin $M$"),
        ("Geschwindigkeit von $M$", "von $M$"),
        ("Geschwindigkeit des Punktes $M$", "des Punktes $M$"),
        ("点 $M$ 的速度", "$M$ 的"),
        ("velocity of $A$", ""),
        ("speed of the point $A$ of the crank $OA$", ""),
        ("velocity of the end on the line through $M$", ""),
        ("端点到 $M$ 的距离", ""),
    ],
)
def test_words_that_name_another_point_than_the_quantity_are_a_fault(means: str, said: str) -> None:
    fault = f'asks.v_A.means: it says "{said}", and the quantity is of A: write the one that is '
    assert find(means) == [f"{fault}meant in both places"] * bool(said)


@pytest.mark.parametrize(
    ("velocity", "draw", "means", "said"),
    [
        ("omega", "[2]", "rate, clockwise", "clockwise"),
        ("-omega", "[2]", "rate, counter-clockwise", "counter-clockwise"),
        ("-omega", "[2]", "Winkelgeschwindigkeit, im Gegenuhrzeigersinn", "im Gegenuhrzeigersinn"),
        ("omega", "[2]", "角速度，顺时针", "顺时针"),
        ("-omega", "[2]", "rate, clockwise", ""),
        ("omega", "[2]", "rate, counter-clockwise", ""),
        ("omega", "[-2, 2]", "rate, clockwise", ""),
        ("omega", "[2]", "rate", ""),
    ],
)
def test_a_given_whose_words_name_another_sense_than_it_drives_is_a_fault(
    velocity: str, draw: str, means: str, said: str
) -> None:
    text = changed(
        ('velocity = "omega"', f'velocity = "{velocity}"'),
        ('draw = [2], means = { en = "rate"', f'draw = {draw}, means = {{ en = "{means}"'),
    )
    found = all_said(find_false_claims(read_template("crank", text), []))
    fault = f'parameters.omega.means: "{said}", and its input drives the other way: change the '
    assert found == [f"{fault}words, or the minus in the input"] * bool(said)


def test_words_that_name_another_body_than_the_quantity_are_a_fault() -> None:
    text = write_starter_text()
    named = "angular velocity of the rocker $CB$"
    assert named in text
    wrong = read_template("rocker", text.replace(named, named.replace("CB", "OA")))
    assert [each.split(":")[1] for each in all_said(find_false_claims(wrong, []))] == [
        ' it says "of the rocker $OA$", and the quantity is of CB'
    ]
    block = read_template("rocker", text.replace(named, named.replace("CB", "CA")))
    assert all_said(find_false_claims(block, [])) == []


@pytest.mark.parametrize(
    ("quantity", "means", "sign"),
    [
        ("y(velocity(A))", "velocity of $A$, downwards", "+y"),
        ("x(velocity(A))", "velocity of $A$, to the left", "+x"),
        ("y(velocity(A))", "Geschwindigkeit von $A$, nach unten", "+y"),
        ("-y(velocity(A))", "$A$ 的速度，向上", "-y"),
        ("y(velocity(A))", "downward velocity of $A$", "+y"),
        ("y(velocity(A))", "velocity of $A$, upwards", ""),
        ("x(velocity(A))", "velocity of the end to the left of $O$", ""),
    ],
)
def test_words_that_name_the_other_sense_are_a_fault(quantity: str, means: str, sign: str) -> None:
    assert [each.split(": ", 2)[2] for each in find(means, quantity)] == [
        f'write "{sign}", or a minus before the quantity'
    ] * bool(sign)


@pytest.mark.parametrize(
    "means",
    [
        "velocity component of $A$ to the left",
        "velocity component along $x$",
        "the velocity component in the direction of the guide",
        "horizontal velocity component of $A$",
        "component of the velocity of $A$ along the horizontal",
        "x component of the velocity of $A$",
        "rightward velocity component of the pin $A$",
        "the velocity component parallel to the ground",
        "Geschwindigkeitskomponente von $A$ nach links",
        "waagerechte Komponente der Geschwindigkeit von $A$",
        "$A$ 的水平分速度",
        "点 $A$ 速度沿 $x$ 轴的分量",
    ],
)
def test_no_axis_is_read_within_another_word(means: str) -> None:
    assert find(means, "x(velocity(A))") == []


@pytest.mark.parametrize(
    ("means", "said"),
    [
        ("y component of the velocity", "y component"),
        ("the vertical component", "vertical component"),
        ("senkrechte Komponente", "senkrechte Komponente"),
        ("竖直分速度", "竖直分速度"),
    ],
)
def test_the_other_axis_is_a_fault(means: str, said: str) -> None:
    [fault] = find(means, "x(velocity(A))")
    assert f'it says "{said}", and the quantity is the component along x' in fault
