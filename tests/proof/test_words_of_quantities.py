"""The words and letters of asks and givens say of which kind they are."""

from __future__ import annotations

from dataclasses import replace

import pytest
from msgspec import structs

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.hints import Rimmed
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.library.starter import write_starter_text
from kinegrade.proof.claims.circles import note_radii_of_bars
from kinegrade.proof.claims.claims import find_false_claims
from kinegrade.proof.claims.kinds import note_other_kinds
from tests.problem.turning_crank import CRANK, changed
from tests.proof.claims import crank, find
from tests.said import all_said


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("angular acceleration of the rocker", "angular velocity of the rocker"),
        ("angular acceleration of the rocker", "acceleration of the rocker"),
    ],
)
def test_words_of_an_ask_that_name_another_kind_of_rate_are_noted(before: str, after: str) -> None:
    text = write_starter_text()
    assert list(note_other_kinds(read_template("rocker", text))) == []
    changed = text.replace(before, after).replace("摇杆 $CB$ 的角加速度", "摇杆")
    assert all_said(note_other_kinds(read_template("rocker", changed))) == [
        "what alpha_CB means names another kind of quantity than one in rad/s²"
    ]


def test_a_radius_that_is_the_length_of_a_bar_is_noted() -> None:
    def note(means: str) -> list[str]:
        template = read_template("crank", changed(('en = "length"', f'en = "{means}"')))
        return all_said(note_radii_of_bars(template, [solve_template(template, {}, ())]))

    assert note("radius of the wheel") == [
        "r is called a radius, and no circle of the mechanism has it: it is the length OA"
    ]
    assert note("radius of the crank") == note("length of the bar") == []


def test_a_bar_that_is_called_a_diameter_is_a_fault() -> None:
    fault = (
        'statement: it says "diameter {{ r }}", and no circle of the mechanism has that diameter: '
        "r is the length OA"
    )
    assert find("The crank $OA$ of diameter {{ r }}") == [fault]
    meant = ('en = "length"', 'en = "diameter of the disc"')
    disc = read_template("crank", changed(meant, ('en = "{{ r }} ', 'en = "diameter {{ r }} ')))
    assert all_said(find_false_claims(disc, [solve_template(disc, {}, ())])) == []


def test_a_given_that_means_a_diameter_and_is_a_radius_is_a_fault() -> None:
    template = crank("")
    figure = replace(template.figure, circles=(Rimmed("OA", "O", "A"),))
    text = changed(('zh = "长"', 'zh = "圆轮直径"'))
    named = structs.replace(read_template("crank", text), figure=figure)
    assert all_said(find_false_claims(named, [solve_template(named, {}, ())])) == [
        'parameters.r.means: it says "圆轮直径", and r is the radius of a circle of the mechanism, '
        "not the diameter"
    ]


def test_words_of_a_given_that_name_another_kind_of_rate_are_noted() -> None:
    template = read_template("crank", changed(('en = "rate"', 'en = "speed of A"')))
    assert all_said(note_other_kinds(template)) == [
        "what omega means names another kind of quantity than one in rad/s"
    ]


def test_a_speed_in_turns_is_no_other_kind() -> None:
    def note(means: str) -> int:
        given = f'en = "{means}"'
        text = changed(('en = "rate"', given)).replace('unit = "rad/s", draw', 'unit = "rpm", draw')
        return len([*note_other_kinds(read_template("crank", text))])

    assert [note("speed of the crank"), note("acceleration of the crank")] == [0, 1]


@pytest.mark.parametrize(
    ("quantity", "said", "sign"),
    [
        ("omega(OA)", "positive clockwise", "ccw"),
        ("omega(OA)", "positiv im Uhrzeigersinn", "ccw"),
        ("omega(OA)", "顺时针为正", "ccw"),
        ("-omega(OA)", "positive anticlockwise", "cw"),
        ("omega(OA)", "positive counter-clockwise", ""),
        ("omega(OA)", "positive counter-clockwise, negative clockwise", ""),
    ],
)
def test_a_sign_in_words_that_is_the_other_way_is_a_fault(
    quantity: str, said: str, sign: str
) -> None:
    text = changed(
        ("magnitude(velocity(A))", quantity),
        ('"m/s", means', f'"rad/s", sign = {{ en = "{said}", zh = "{said}" }}, means'),
    )
    template = read_template("crank", text.split("[[published]]")[0])
    fault = f'asks.v_A.sign: "{said}", and the quantity is positive the other way: write "{sign}", '
    assert all_said(find_false_claims(template, [])) == [
        f"{fault}or a minus before the quantity"
    ] * bool(sign)


@pytest.mark.parametrize(
    ("mark", "name"),
    [
        ('lengths = [{ symbol = "omega", from = "O", to = "A" }]', "omega, in rad/s"),
        ('angles = [{ symbol = "r", at = "O", from = "right", to = "A" }]', "r, in m"),
        ('arrows = [{ symbol = "r", turns = "OA" }]', "r, in m"),
        ('lengths = [{ symbol = "r", from = "O", to = "A" }]', ""),
    ],
)
def test_a_mark_with_the_letter_of_another_kind_of_quantity_is_a_fault(
    mark: str, name: str
) -> None:
    text = CRANK.replace('{ unit = "rad/s",', '{ symbol = "omega", unit = "rad/s",')
    template = read_template("crank", f"{text}\n[figure]\n{mark}\n")
    fault = f"figure: {name}, stands at a mark that shows another kind of quantity - mark the "
    assert all_said(find_false_claims(template, [])) == [
        f"{fault}points that it measures, or give the mark another letter"
    ] * bool(name)
