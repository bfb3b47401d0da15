"""`check` holds the words for kinds of things in statements and asks: the sort of belt, the
component, the kind of rate, which one of two.
"""

from __future__ import annotations

import pytest
from msgspec.structs import replace

from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.translated import Translated
from kinegrade.proof.claims.claims import find_false_claims
from kinegrade.proof.claims.kinds import name_kinds, note_kinds_said
from kinegrade.proof.claims.swaps import find_swapped_givens
from tests.problem.turning_crank import CRANK, changed
from tests.said import all_said


def say(template: Template, said: str) -> Template:
    """A template with another statement."""
    return replace(template, words=replace(template.words, statement=Translated(plain=said)))


@pytest.mark.parametrize(
    ("said", "wrong"),
    [
        ("An open belt runs about both", "open belt"),
        ("Ein offener Riemen läuft um beide", "offener Riemen"),
        ("两轮由开口带连接", "开口带"),
        ("A crossed belt runs about both, not an open belt", ""),
        ("Ein gekreuzter Riemen läuft um beide", ""),
    ],
)
def test_a_belt_that_is_said_to_be_otherwise_is_a_fault(said: str, wrong: str) -> None:
    fault = (
        f'statement: it says "{wrong}", and no belt of the mechanism is: correct the words, or the '
    )
    template = say(load_template("crossed-belt-drive"), said)
    found = [each for each in all_said(find_false_claims(template, [])) if "belt" in each]
    assert found == [f"{fault}joint"] * bool(wrong)


@pytest.mark.parametrize("said", ["An open (uncrossed) belt", "Ein nicht gekreuzter Riemen"])
def test_a_belt_that_is_not_crossed_is_open(said: str) -> None:
    faults = all_said(find_false_claims(say(load_template("two-stage-belt-drive"), said), []))
    assert not [each for each in faults if "belt" in each]


@pytest.mark.parametrize(
    ("means", "wrong"),
    [
        ("vertical component of the velocity of $A$", "vertical component"),
        ("senkrechte Komponente der Geschwindigkeit von $A$", "senkrechte Komponente"),
        ("$A$ 的速度的竖直分量", "竖直分量"),
        ("horizontal component of the velocity of $A$", ""),
    ],
)
def test_the_other_component_is_a_fault(means: str, wrong: str) -> None:
    text = changed(
        ("magnitude(velocity(A))", "x(velocity(A))"),
        ('means = { en = "speed"', f'means = {{ en = "{means}"'),
    )
    template = read_template("crank", text.split("[[published]]")[0])
    fault = f'asks.v_A.means: it says "{wrong}", and the quantity is the component along x: correct the '
    assert all_said(find_false_claims(template, [])) == [f"{fault}words, or the quantity"] * bool(
        wrong
    )


@pytest.mark.parametrize(
    ("said", "wrong"),
    [
        ("with the constant acceleration {{ omega }}", "acceleration {{ omega }}"),
        ("with the constant angular velocity {{ omega }}", ""),
        ("mit der Umfangsgeschwindigkeit {{ omega }}", "Umfangsgeschwindigkeit {{ omega }}"),
        ("以角加速度 {{ omega }} 转动", "角加速度 {{ omega }}"),
        ("以角速度 {{ omega }} 转动", ""),
    ],
)
def test_a_given_behind_the_word_for_another_kind_is_noted(said: str, wrong: str) -> None:
    found = all_said(note_kinds_said(say(read_template("crank", CRANK), said)))
    assert found == [
        f'the statement says "{wrong}", which is another kind of quantity than one in rad/s'
    ] * bool(wrong)


@pytest.mark.parametrize(
    ("means", "kinds"),
    [
        ("rate of change of the angular velocity of the crank", {"angular-acceleration"}),
        ("rate of decrease of the speed of $A$", {"acceleration"}),
        ("time derivative of the rotational speed", {"angular-acceleration"}),
        ("rate at which the slider loses speed", {"acceleration", "velocity"}),
        ("zeitliche Änderung der Winkelgeschwindigkeit", {"angular-acceleration"}),
        ("Änderungsgeschwindigkeit der Drehzahl", {"angular-acceleration"}),
        ("角速度的变化率", {"angular-acceleration"}),
        ("角速度每秒的增加量", {"angular-acceleration", "angular-velocity"}),
        ("speed at which the rod comes out", {"velocity"}),
    ],
)
def test_the_rate_at_which_a_speed_changes_is_an_acceleration(means: str, kinds: set[str]) -> None:
    assert {*name_kinds(means)} == kinds


def test_the_rate_of_change_of_a_speed_before_its_given_is_no_other_kind() -> None:
    given = 'alpha = { unit = "rad/s^2", draw = [1], means = { en = "a", zh = "a" } }'
    template = read_template("crank", CRANK.replace("[parameters]", f"[parameters]\n{given}"))
    said = "with a rate of change of the angular velocity {{ %s }}"
    assert [len([*note_kinds_said(say(template, said % each))]) for each in ("omega", "alpha")] == [
        1,
        0,
    ]


@pytest.mark.parametrize(
    ("said", "swapped"),
    [
        ("The upper rack moves at {{ u }}, the lower one at {{ w }}", False),
        ("The lower rack moves at {{ u }}, the upper one at {{ w }}", True),
    ],
)
def test_givens_of_the_upper_and_the_lower_part_that_have_changed_places_are_a_fault(
    said: str, swapped: bool
) -> None:
    given = '{ unit = "m/s", draw = [1], means = { en = "speed of the %s rack", zh = "速" } }'
    added = f"[parameters]\nu = {given % 'upper'}\nw = {given % 'lower'}"
    template = read_template(
        "crank",
        CRANK.replace("[parameters]", added)
        .replace('en = "{{ r }} ', f'en = "{said}. {{{{ r }}}} ')
        .replace('zh = "{{ r }} ', 'zh = "{{ u }} {{ w }} {{ r }} '),
    )
    assert len(all_said(find_swapped_givens(template))) == swapped
