"""`check` says where the statement contradicts the mechanism: a length, a midpoint, a sense."""

from __future__ import annotations

from dataclasses import replace

import pytest
from msgspec import structs

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.hints import Rimmed
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.checking import check
from kinegrade.proof.claims.circles import note_radii_of_bars
from kinegrade.proof.claims.claims import find_false_claims
from kinegrade.proof.claims.kinds import note_other_kinds
from tests.problem.turning_crank import CRANK
from tests.proof.claims import crank, find
from tests.said import all_said


@pytest.mark.parametrize(
    "statement",
    [
        "The crank $OA$ of length {{ half }}",
        "The crank $OA$, of length {{ half }}",
        "$OA$ = {{ half.value }}",
        "Die Kurbel $OA$ der Länge {{ half }}",
        "曲柄 $OA$ 长 {{ half }}",
    ],
)
def test_a_length_beside_two_points_at_another_distance_is_a_fault(statement: str) -> None:
    assert find(statement) == [
        "statement: it says that OA is half, and OA is 1 m where half is 0.5 m"
    ]
    assert find(statement.replace("half", "r")) == []


@pytest.mark.parametrize(
    "statement",
    [
        "The crank $OA$ of length {{ phi }}",  # no length
        "The crank $OX$ of length {{ half }}",  # no such point
        "$A$ at the distance {{ half }}",
        "The end of the crank $OA$. A rod of length {{ half }}",
    ],
)
def test_what_says_nothing_of_two_points_is_no_claim(statement: str) -> None:
    assert find(statement) == []


@pytest.mark.parametrize(
    "statement",
    [
        "the midpoint $%s$ of $OA$",
        "the midpoint $%s$ of the crank $OA$",
        "$%s$ is the midpoint of $OA$",
        "der Mittelpunkt $%s$ von $OA$",
        "$OA$ 的中点 $%s$",
    ],
)
def test_a_midpoint_that_is_none_is_a_fault(statement: str) -> None:
    said = "statement: it says that M is the midpoint of OA, and it lies elsewhere"
    assert find(statement % "M", half="3/4") == [said]
    assert find(statement % "N", half="3/4") == []


@pytest.mark.parametrize(
    ("statement", "said"),
    [
        ("The crank turns clockwise at the rate {{ omega }}", "turns clockwise at the rate"),
        ("The crank turns counter-clockwise at {{ omega }}", ""),
        ("Die Kurbel dreht sich im Uhrzeigersinn mit {{ omega }}", "dreht sich im Uhrzeigersinn"),
        ("曲柄以 {{ omega }} 顺时针转动", "以 {{ omega }} 顺时针转动"),
        ("The wheel turns clockwise. The rate is {{ omega }}", ""),
        ("The crank $OA$ turns clockwise.", "$OA$ turns clockwise"),
        ("Die Kurbel $OA$ dreht sich im Uhrzeigersinn.", "$OA$ dreht sich im Uhrzeigersinn"),
        ("曲柄 $OA$ 顺时针转动.", "$OA$ 顺时针转动"),
        ("The crank $OA$ turns anticlockwise.", ""),
    ],
)
def test_a_sense_that_no_instance_has_is_a_fault(statement: str, said: str) -> None:
    (*found,) = find(statement)
    assert [each.split('"')[1].startswith(said) for each in found] == [True] * bool(said)
    assert [
        each for each in found if not each.endswith(", and all instances go the other way")
    ] == []


@pytest.mark.parametrize(
    "said",
    [
        "turns counter-clockwise with {{ omega }}",
        "dreht sich mit {{ omega }} gegen den Uhrzeigersinn",
        "以 {{ omega }} 逆时针转动",
    ],
)
def test_a_sense_that_some_drawn_values_do_not_have_is_a_fault(said: str) -> None:
    template = read_template(
        "crank",
        CRANK.replace("draw = [2]", "draw = [2, -2]").replace(
            'en = "{{ r }} {{ phi }} {{ omega }}', f'en = "{{{{ r }}}} {{{{ phi }}}} It {said}'
        ),
    )
    solution = solve_template(template, {}, ())
    assert all_said(find_false_claims(template, [solution])) == [
        f'statement: it says "{said}", and omega = -2 goes the other way: {{{{ OA.turning }}}} says '
        "the sense at each value"
    ]


def test_a_body_that_turns_the_other_way_in_some_instances_is_a_fault() -> None:
    template = crank("$OA$ turns counter-clockwise.")
    there, back = (solve_template(template, {"omega": omega}, ()) for omega in ("2", "-2"))
    assert all_said(find_false_claims(template, [there, back])) == [
        'statement: it says "$OA$ turns counter-clockwise", and some instances go the other way: '
        "leave the sense out"
    ]


@pytest.mark.parametrize(
    ("statement", "fault"),
    [
        ("The pin $A$ is at rest", "$A$ is at rest"),
        ("the fixed pin $A$", "the fixed pin $A$"),
        ("$OA$ stands still", "$OA$ stands still"),
        ("Der Punkt $A$ ruht", "$A$ ruht"),
        ("um den festen Punkt $A$", "festen Punkt $A$"),
        ("$A$ 静止", "$A$ 静止"),
        ("绕固定点 $A$", "固定点 $A$"),
        ("the fixed pin $O$", ""),
        ("$O$ is at rest", ""),
        ("$A$ is fixed to the disc", ""),
    ],
)
def test_what_moves_and_is_said_to_be_at_rest_is_a_fault(statement: str, fault: str) -> None:
    said = f'statement: it says "{fault}", and that moves'
    assert find(statement) == [said] * bool(fault)


@pytest.mark.parametrize(
    "said",
    [
        "constant angular velocity {{ omega }}",
        "uniformly with {{ omega }}",
        "konstanten Winkelgeschwindigkeit {{ omega }}",
        "以 {{ omega }} 匀速",
        "匀角速度 {{ omega }}",
    ],
)
def test_a_rate_said_to_be_constant_whose_input_has_an_acceleration_is_a_fault(said: str) -> None:
    assert find(f"It turns {said}") == []
    text = CRANK.replace(
        'velocity = "omega"', 'velocity = "omega", acceleration = "3/r*omega**2*r"'
    )
    template = read_template("crank", text.replace('en = "{{ r }}', f'en = "{{{{ r }}}} {said}'))
    assert all_said(find_false_claims(template, [solve_template(template, {}, ())])) == [
        f'statement: it says "{said}", and the input has an acceleration: leave the word out, or '
        "the acceleration"
    ]


@pytest.mark.parametrize(
    ("said", "size", "kind"),
    [
        ("diameter {{ rim }}", "r/2", "radius"),
        ("Durchmesser von {{ rim }}", "r/2", "radius"),
        ("直径为 {{ rim }}", "r/2", "radius"),
        ("radius {{ rim }}", "r", "diameter"),
        ("Radius {{ rim }}", "r", "diameter"),
        ("半径 {{ rim }}", "r", "diameter"),
        ("diameter {{ rim }}", "r", ""),
        ("radius {{ rim }}", "r/2", ""),
    ],
)
def test_a_radius_that_is_called_a_diameter_is_a_fault(said: str, size: str, kind: str) -> None:
    """The crank has a rim through M about O; rim is 0.5 m."""
    template = crank(f"A disc of {said}".replace("rim", "half" if size == "r/2" else "r"))
    template = structs.replace(
        template, figure=replace(template.figure, circles=(Rimmed("OA", "O", "M"),))
    )
    found = all_said(find_false_claims(template, [solve_template(template, {"r": "1"}, ())]))
    name = "half" if size == "r/2" else "r"
    other = "diameter" if kind == "radius" else "radius"
    assert found == [
        f'statement: it says "{said.replace("rim", name)}", and {name} is the {kind} of a circle of '
        f"the mechanism, not the {other}"
    ] * bool(kind)


@pytest.mark.parametrize(
    ("said", "wrong"),
    [
        ("$OA$ makes an angle {{ phi }} with the $x$ axis, measured clockwise", True),
        ("$OA$ makes an angle {{ phi }} with the $x$ axis, measured counter-clockwise", False),
        ("$OA$ makes an angle {{ phi }} with $OB$, measured clockwise", False),
        ("$OA$ bildet mit der $x$-Achse den Winkel {{ phi }}, im Uhrzeigersinn", True),
        ("$OA$ bildet mit der $x$-Achse den Winkel {{ phi }}, gegen den Uhrzeigersinn", False),
        ("由 $x$ 轴顺时针转到 $OA$ 的角为 {{ phi }}", True),
        ("$OA$ makes an angle {{ phi }} with the $x$ axis and the wheel turns clockwise", False),
        ("$OA$ bildet mit der $x$-Achse den Winkel {{ phi }}, sie dreht sich im Uhrzeigersinn", 0),
        ("$OA$ 与 $x$ 轴的夹角为 {{ phi }}，顺时针转动", False),
        ("$OA$ 与 $x$ 轴的夹角为 {{ phi }}，顺时针量取", True),
        ("由 $x$ 轴逆时针转到 $OA$ 的角为 {{ phi }}", False),
    ],
)
def test_an_angle_that_is_counted_the_other_way_round_is_a_fault(said: str, wrong: bool) -> None:
    fault = f'statement: it says "{said}", and phi is counted the other way round'
    assert find(said) == [fault] * wrong


@pytest.mark.parametrize(
    ("statement", "said"),
    [
        ("the pin $A$, vertically above $O$", "A is vertically above O, where it is elsewhere"),
        ("$O$ is vertically below $A$", "O is vertically below A, where it is elsewhere"),
        ("$A$ lies to the left of $O$", "A is to the left of O, where it is not"),
        ("$O$ liegt rechts von $A$", "O is to the right of A, where it is not"),
        ("$A$ 在 $O$ 正下方", "A is vertically below O, where it is elsewhere"),
        ("Lager $A$, senkrecht über $O$", "A is vertically above O, where it is elsewhere"),
        ("$A$ lies to the right of $O$", ""),
        ("$A$ lying to the left of $O$", "A is to the left of O, where it is not"),
        ("$A$, which lies to the left of $O$", "A is to the left of O, where it is not"),
        ("$A$ is on the left of the fixed pin $O$", "A is to the left of O, where it is not"),
        ("$A$ liegt links vom festen Gelenk $O$", "A is to the left of O, where it is not"),
        ("$A$ 在固定铰链 $O$ 的左侧", "A is to the left of O, where it is not"),
        (
            "the slider $A$ slides on a rail, to the left of $O$",
            "A is to the left of O, where it is not",
        ),
        (
            "$A$ turns about the pin $M$, to the left of $O$",
            "M is to the left of O, where it is not",
        ),
        (
            "$A$ liegt senkrecht über dem festen Drehpunkt $O$",
            "A is vertically above O, where it is elsewhere",
        ),
        ("the rope runs from $A$ to the left of the pulley with the centre $O$", ""),
        ("das Seil läuft von $O$ über $A$", ""),
        ("a line through $A$, to the left of $O$", ""),
    ],
)
def test_a_side_on_which_a_point_does_not_lie_is_a_fault(statement: str, said: str) -> None:
    assert find(statement) == [f"statement: it says that {said}"] * bool(said)


def test_a_point_is_vertically_above_another_in_all_instances() -> None:
    assert find("$A$, vertically above $O$", phi="90") == []


@pytest.mark.parametrize(
    "statement",
    ["$A$, at the distance {{ half }} from $O$", "$A$ 到 $O$ 的距离为 {{ half }}"],
)
def test_a_distance_of_two_points_that_is_another_is_a_fault(statement: str) -> None:
    said = "statement: it says that AO is half, and AO is 1 m where half is 0.5 m"
    assert find(statement) == [said]
    assert find(statement.replace("half", "r")) == []
    assert find("$M$, to the right of $A$ at the distance {{ half }} from $O$")[1:] == []


def test_a_sense_behind_the_words_that_say_it_is_a_fault() -> None:
    assert find("It {{ OA.turning }}, clockwise") == [
        'statement: "clockwise" stands behind {{ OA.turning }}, which says the sense at each value: '
        "leave it out"
    ]
    assert find("It {{ OA.turning }}, and a wheel turns clockwise") == []


def test_the_other_sense() -> None:
    template = read_template(
        "crank",
        CRANK.replace('velocity = "omega"', 'velocity = "-omega"').replace(
            'en = "{{ r }}', 'en = "It turns counterclockwise with {{ omega }}, {{ r }}'
        ),
    )
    assert all_said(find_false_claims(template, [solve_template(template, {}, ())])) == [
        'statement: it says "turns counterclockwise with {{ omega }}", and all instances go the '
        "other way"
    ]


def test_it_is_a_fault_of_the_check() -> None:
    faults = all_said(check(crank("The crank $OA$ of length {{ half }}"), sample=4).faults)
    assert any("it says that OA is half" in fault for fault in faults), faults


@pytest.mark.parametrize("name", find_template_names())
def test_no_template_that_is_shipped_makes_such_a_claim(name: str) -> None:
    template = load_template(name)
    solution = solve_template(template, {}, ())
    assert all_said(find_false_claims(template, [solution])) == []
    assert all_said(note_other_kinds(template)) == []
    assert all_said(note_radii_of_bars(template, [solution])) == []
