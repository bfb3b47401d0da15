"""The plan: the order of steps that textbooks have."""

from __future__ import annotations

import pytest

from kinegrade.language import ENGLISH
from kinegrade.language.catalogue import open_catalogue
from kinegrade.mechanics import plan
from kinegrade.mechanics.frames import build_frames
from kinegrade.mechanics.joints import GROUND, Pin, Roll, Slide
from kinegrade.mechanics.motion import Motion, solve_motion
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.numbers.elimination import Singular
from tests.mechanics.writing import Paper, X


def order(motion: Motion) -> list[tuple[Rate, ...]]:
    """What each step gives, surplus checks left out."""
    return [step.unknowns for step in motion.plan.steps if step.unknowns]


def origins(motion: Motion) -> list[list[str]]:
    """Which relations each step solves."""
    english = open_catalogue(ENGLISH)
    return [
        [english.write(motion.frames.relations[index].origin) for index in step.relations]
        for step in motion.plan.steps
    ]


def slider_crank() -> Motion:
    p = Paper()
    return p.motion(
        {"O": (0, 0), "A": (0, 3), "B": (4, 0)},
        {"OA": "O A", "AB": "A B"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("A", ("OA", "AB")),
            Slide("B", "AB", p.line(0, 0, X), GROUND),
        ],
        [p.turns("OA", 2)],
    )


def test_slider_crank_first_the_crank_then_the_base_point_equation_of_the_rod() -> None:
    motion = slider_crank()
    assert origins(motion) == [["the given rotation of OA"], ["B of AB on the line of ground"]]
    assert order(motion) == [
        (make_turning("OA"),),
        (make_turning("AB"), Rate("sliding", "AB", "B")),
    ]
    assert [(t.point, t.base) for t in motion.frames.chain("AB", "B")] == [
        ("A", "O"),
        ("B", "A"),
    ]  # v_B = v_A + v_BA


def test_four_bar_one_vector_equation_for_coupler_and_rocker() -> None:
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (1, 0), "B": (4, 2), "C": (3, -1)},
        {"OA": "O A", "AB": "A B", "CB": "C B"},
        [
            Pin("O", (GROUND, "OA")),
            Pin("A", ("OA", "AB")),
            Pin("B", ("AB", "CB")),
            Pin("C", ("CB", GROUND)),
        ],
        [p.turns("OA", 2)],
    )
    assert order(motion) == [
        (make_turning("OA"),),
        (make_turning("AB"), make_turning("CB")),
    ] or order(motion) == [
        (make_turning("OA"),),
        (make_turning("CB"), make_turning("AB")),
    ]
    assert origins(motion)[1] == ["the pin B of AB and CB"]


def test_planetary_gear_the_arm_then_the_centre_on_its_circle_then_no_slip() -> None:
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (3, 0), "B": (4, 0)},
        {"OA": "O A", "II": "A B"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("A", ("OA", "II")),
            Roll("II", p.circle("A", 1), GROUND, p.circle("O", 2)),
        ],
        [p.turns("OA", 2)],
    )
    assert origins(motion) == [
        ["the given rotation of OA"],
        ["the rolling of II on ground"],
        ["no slip: the rolling of II on ground"],
    ]
    assert order(motion)[-1] == (make_turning("II"),)


def test_driven_slider_starts_at_the_driven_point() -> None:
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (0, 3), "B": (4, 0)},
        {"OA": "O A", "AB": "A B"},
        [
            Pin("O", ("OA", GROUND)),
            Pin("A", ("OA", "AB")),
            Slide("B", "AB", p.line(0, 0, X), GROUND),
        ],
        [p.moves("B", "AB", X, 1)],
    )
    assert motion.frames.bases["AB"].point == "B"
    assert origins(motion) == [["the given motion of B of AB"], ["the pin A of OA and AB"]]


def test_two_equations_together_only_where_nothing_smaller_works() -> None:
    # a triad: a plate ABC on three rockers, the middle one driven: neither rocker alone can be
    # found
    p = Paper()
    motion = p.motion(
        {"A": (0, 2), "B": (4, 2), "C": (2, 4), "D": (0, 0), "E": (5, 0), "F": (4, 5), "G": (6, 4)},
        {"plate": "A B C", "left": "A D", "right": "B E", "rod": "C F", "crank": "F G"},
        [
            Pin("A", ("plate", "left")),
            Pin("B", ("plate", "right")),
            Pin("C", ("plate", "rod")),
            Pin("D", ("left", GROUND)),
            Pin("E", ("right", GROUND)),
            Pin("F", ("rod", "crank")),
            Pin("G", ("crank", GROUND)),
        ],
        [p.turns("crank", 1)],
    )
    assert max(len(step.relations) for step in motion.plan.steps) == 2
    assert len(motion.plan.steps[0].relations) == 1


def test_a_surplus_relation_is_a_step_that_gives_nothing() -> None:
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (1, 0)},
        {"OA": "O A"},
        [Pin("O", ("OA", GROUND))],
        [p.turns("OA", 2), p.circles("A", "OA", "O", 2)],
    )
    assert [step.unknowns for step in motion.plan.steps] == [(make_turning("OA"),), ()]


def test_a_plan_that_does_not_fit_is_replaced() -> None:
    p = Paper()
    mechanism = p.mechanism(
        {"O": (0, 0), "A": (1, 0)}, {"OA": "O A"}, [Pin("O", ("OA", GROUND))], [p.turns("OA", 2)]
    )
    wrong = plan.Plan((plan.Step((0,), (make_turning("OA"), make_turning("AB"))),))
    assert solve_motion(mechanism, p.field, wrong).omega("OA") == 2


def test_no_plan_is_found_for_relations_that_leave_a_motion_free() -> None:
    p = Paper()
    mechanism = p.mechanism(
        {"O": (0, 0), "A": (1, 0)},
        {"OA": "O A", "AB": "A"},
        [Pin("O", ("OA", GROUND)), Pin("A", ("OA", "AB"))],
        [p.turns("OA", 2, of="AB")],
    )
    frames = build_frames(mechanism, p.field)
    with pytest.raises(Singular):
        plan.find_plan(
            frames.relations, [relation.equations() for relation in frames.relations], p.field
        )
