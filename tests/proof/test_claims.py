"""`check` says where the statement contradicts the mechanism: a length, a midpoint, a sense."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.library.starter import write_starter_text
from kinegrade.problem.template.template import Template
from kinegrade.proof.checking import check
from kinegrade.proof.claims import find_false_claims, note_other_kinds
from tests.problem.turning_crank import CRANK
from tests.said import all_said


def crank(statement: str) -> Template:
    """The crank OA of length r with the point M at 0.5 m, and N in the middle."""
    text = CRANK.replace('en = "{{ r }} ', f"en = '''{statement} ").replace(
        '{{ omega }}", zh = "{{ r }}', "{{ omega }}''', zh = \"{{ r }}", 1
    )
    given = 'half = { unit = "m", draw = ["1/2"], means = { en = "a", zh = "a" } }'
    text = text.replace("[parameters]", f"[parameters]\n{given}").replace('half = "r/2"\n', "")
    text = text.replace("[bodies]", 'N = "midpoint(O, A)"\n[bodies]')
    return read_template("crank", text.replace('"O A M"', '"O A M N"'))


def find(statement: str, **values: str) -> list[str]:
    """What is contradicted at r = 1 and phi = 60, or at other values."""
    template = crank(statement)
    solution = solve_template(template, {"r": "1", **values}, ())
    return all_said(find_false_claims(template, [solution]))


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
    ("statement", "right"),
    [
        ("The crank turns clockwise at the rate {{ omega }}", False),
        ("The crank turns counter-clockwise at {{ omega }}", True),
        ("Die Kurbel dreht sich im Uhrzeigersinn mit {{ omega }}", False),
        ("曲柄以 {{ omega }} 顺时针转动", False),
        ("The wheel turns clockwise. The rate is {{ omega }}", True),
    ],
)
def test_a_sense_that_no_instance_has_is_a_fault(statement: str, right: bool) -> None:
    said = (
        "statement: it says clockwise beside omega, which turns counter-clockwise in all instances"
    )
    assert find(statement) == [said] * (not right)


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
        "statement: it says counter-clockwise beside omega, which turns clockwise in all instances"
    ]


def test_it_is_a_fault_of_the_check() -> None:
    faults = all_said(check(crank("The crank $OA$ of length {{ half }}"), sample=4).faults)
    assert any("it says that OA is half" in fault for fault in faults)


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


@pytest.mark.parametrize("name", find_template_names())
def test_no_template_that_is_shipped_makes_such_a_claim(name: str) -> None:
    template = load_template(name)
    assert all_said(find_false_claims(template, [solve_template(template, {}, ())])) == []
    assert all_said(note_other_kinds(template)) == []
