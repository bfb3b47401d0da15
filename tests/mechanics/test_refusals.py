"""What the solver refuses, in the language of mechanics: every message is read."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from kinegrade.errors import MechanismError
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.mechanics.joints import (
    GROUND,
    Arc,
    Contact,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.motion import solve_motion
from kinegrade.numbers.balls import Balls
from kinegrade.numbers.floats import Floats
from tests.laws.cases import with_numbers
from tests.mechanics.refusals import BODIES, CRANK, POINTS, P, problem, written
from tests.mechanics.writing import X, Y


@pytest.mark.parametrize(
    ("joints", "drivers", "message"),
    [
        (
            CRANK,
            [P.turns("OA", 1)],
            "body AB can still turn (1 degree of freedom left): add a joint or a driver",
        ),
        (
            CRANK,
            [],
            "body AB can still turn, body OA can still turn (2 degrees of freedom left): add a "
            "joint or a driver",
        ),
        (
            CRANK[:1],
            [P.turns("OA", 1)],
            "body AB can still turn, A can still move (3 degrees of freedom left)",
        ),
        (
            [*CRANK, Slide("B", "AB", P.line(0, 0, Y), GROUND)],
            [P.turns("OA", 1)],
            "B of AB on the line of ground: B does not lie on that line: check the construction of "
            "B",
        ),
        (
            [*CRANK, Parallel("AB", GROUND), Pin("B", ("AB", GROUND))],
            [P.turns("OA", 1)],
            "the pin A of OA and AB, AB does not turn relative to ground and the given "
            "rotation of OA contradict each other: leave one out or make their values agree",
        ),
        (
            CRANK,
            [P.turns("OA", 1), P.turns("OA", 2), P.turns("AB", 1)],
            "the given rotation of OA and the given rotation of OA contradict each other",
        ),
        # the velocities agree, the accelerations do not
        (
            CRANK,
            [P.turns("OA", 1, 0), P.turns("OA", 1, 5), P.turns("AB", 1)],
            "the given rotation of OA and the given rotation of OA contradict each other",
        ),
        (
            [*CRANK, Slide("B", "AB", P.line(0, 0, X), GROUND)],
            [P.moves("B", "AB", X, 1)],
            "dead point: A, B and O are in line at these values, the pin A of OA and AB and "
            "the given motion of B of AB cannot act together",
        ),
        (
            [*CRANK, Slide("B", "AB", P.line(0, 0, X), GROUND)],
            [P.moves("B", "AB", X, 0)],
            "dead point: A, B and O are in line at these values: choose other values or another "
            "driver",
        ),
    ],
)
def test_loose_contradictory_and_dead_mechanisms(joints: Any, drivers: Any, message: str) -> None:
    assert message in problem(written(joints, drivers))


def test_a_given_motion_of_a_point_that_the_joints_hold() -> None:
    held = [Pin("A", ("AB", GROUND)), Pin("B", ("AB", GROUND))]
    driven = written(held, [P.moves("A", "AB", X, 1)], bodies={"AB": "A B"})
    assert problem(driven) == (
        "the given motion of A of AB contradicts the joints: leave it out or change the joints"
    )


def test_a_refusal_is_said_in_chinese() -> None:
    chinese = open_catalogue(Language("zh"))
    with pytest.raises(MechanismError) as loose:
        solve_motion(written(CRANK, []), P.field)
    assert [chinese.write(fault) for fault in loose.value.faults] == [
        "刚体 AB 仍可转动、刚体 OA 仍可转动（尚余 2 个自由度）：请添加约束或驱动"
    ]
    with pytest.raises(MechanismError) as apart:
        solve_motion(written([Slide("B", "AB", P.line(0, 0, Y), GROUND)]), P.field)
    assert [chinese.write(fault) for fault in apart.value.faults] == [
        "AB 上沿 ground 的直线滑动的点 B: 点 B 不在该直线上：请检查 B 的作法"
    ]


def test_a_body_that_only_translates_or_a_point_that_only_slides_is_loose() -> None:
    assert problem(written([Parallel("AB", GROUND)], bodies={"AB": "A B"})).startswith(
        "A can still move (2 degrees of freedom left)"
    )
    assert problem(
        written([Slide("A", "M", P.line(0, 0, X), GROUND)], bodies={"M": "particle A"})
    ).startswith("A can still move (1 degree of freedom left)")
    assert problem(written([], bodies={"M": "particle A", "AB": "A B"})).count("can still") == 2


@pytest.mark.parametrize(
    ("joints", "drivers", "message"),
    [
        (
            [Pin("O", ("OAB", GROUND))],
            [],
            'the pin O of OAB and ground: no body "OAB": did you mean "OA"? (known here: AB, OA, '
            "ground)",
        ),
        (
            [Pin("Q", ("OA", GROUND))],
            [],
            'the pin Q of OA and ground: no point "Q": known here: A, B, C, O',
        ),
        ([], [P.turns("wheel", 1)], 'the given rotation of wheel: no body "wheel"'),
        (
            [],
            [P.turns("AB", 1, of="arm")],
            'the given rotation of AB relative to arm: no body "arm"',
        ),
        ([], [P.moves("E", "AB", X, 1)], 'the given motion of E of AB: no point "E"'),
        ([], [P.circles("A", "OA", "Z", 1)], 'the given motion of A of OA about Z: no point "Z"'),
        (
            [Arc("A", "OA", P.circle("Z", 1), "AB")],
            [],
            'A of OA on the circle about Z of AB: no point "Z"',
        ),
        (
            [Mesh("OA", P.circle("O", 1), "AB", P.circle("A", 2), "arm")],
            [],
            'the meshing of OA and AB: no body "arm"',
        ),
    ],
)
def test_unknown_names(joints: Any, drivers: Any, message: str) -> None:
    assert message in problem(written(joints, drivers))


def test_bodies_need_points_that_exist() -> None:
    mechanism = written(CRANK)
    without, strange = (
        replace(mechanism.bodies[0], points=()),
        replace(mechanism.bodies[1], points=("A", "Q")),
    )
    assert problem(replace(mechanism, bodies=(without, strange))).splitlines() == [
        "body OA has no point: name at least one",
        'body AB: no point "Q": known here: A, B, C, O',
    ]


@pytest.mark.parametrize(
    ("joint", "message"),
    [
        (
            Arc("A", "OA", P.circle("C", 5), GROUND),
            "A of OA on the circle about C of ground: A and C are 4 apart: 5 is needed",
        ),
        (
            Contact("OA", P.circle("C", 3), GROUND, P.line(0, 0, X)),
            "the contact of OA and ground: the circle about C"
            " of radius 3 does not touch the line: its centre must be a radius away",
        ),
        (
            Contact("OA", P.circle("A", 1), GROUND, P.circle("C", 2)),
            "the contact of OA and ground: A and C are 4 apart: 3 is needed",
        ),
        (
            Roll("OA", P.circle("C", "1/2"), GROUND, P.line(0, 0, X)),
            "the rolling of OA on ground: the circle about C of radius 0.5",
        ),
        (
            Roll("OA", P.circle("A", 1), GROUND, P.circle("C", 6), inside=True),
            "A and C are 4 apart: 5 is needed",
        ),
        (
            Roll("OA", P.circle("A", 2), GROUND, P.circle("A", 2), inside=True),
            "the rolling of OA on ground: a circle within a circle of the same radius: one must be "
            "smaller",
        ),
        (
            Mesh("OA", P.circle("O", 1), "AB", P.circle("A", 1), GROUND),
            "the meshing of OA and AB: O and A are 3 apart: 2 is needed",
        ),
        (
            Roll("OA", P.circle("A", 0), GROUND, P.line(0, 0, X)),
            "a circle of radius 0: the radius must be positive",
        ),
        (
            Mesh("OA", P.circle("O", -1), "AB", P.circle("A", 4), GROUND),
            "a circle of radius -1: the radius must be positive",
        ),
        (
            Slide("A", "OA", P.line(0, 0, (0, 0)), GROUND),
            "A of OA on the line of ground: the line has no direction: give it two different "
            "points, or an angle",
        ),
        (
            Roll("OA", P.circle("A", 1), GROUND, P.line(0, 1, (0, 0))),
            "the rolling of OA on ground: the line has no direction",
        ),
        (
            Sleeve("OA", P.line(0, 1, (0, 0)), GROUND),
            "OA in the sleeve ground: the line has no direction",
        ),
    ],
)
def test_joints_that_do_not_fit_the_configuration(joint: Any, message: str) -> None:
    assert message in problem(written([*CRANK, joint], [P.turns("OA", 1)]))


@pytest.mark.parametrize(
    ("joints", "drivers", "message"),
    [
        (
            [Pin("A", ("OA", "OA"))],
            [],
            "the pin A of OA and OA: a body cannot move relative to itself: name two bodies",
        ),
        (
            [Pin("A", ("OA",))],
            [],
            "the pin A of OA: a body cannot move relative to itself: name two bodies",
        ),
        (
            [Parallel("OA", "OA")],
            [],
            "OA not turning relative to OA: a body cannot move relative to itself",
        ),
        (
            [],
            [P.turns(GROUND, 1)],
            "the given rotation of ground: a body cannot move relative to itself",
        ),
        (
            [Sleeve(GROUND, P.line(0, 0, X), "OA")],
            [],
            "ground in the sleeve OA: the ground does not slide: name the moving body first",
        ),
        (
            [],
            [P.turns("M", 1)],
            "the given rotation of M: M is a particle, which neither turns nor carries a line or "
            "circle",
        ),
        ([Slide("A", "OA", P.line(0, 0, X), "M")], [], "A of OA on the line of M: M is a particle"),
        ([Parallel("M", GROUND)], [], "M not turning relative to ground: M is a particle"),
        ([], [P.moves("A", "OA", X, 1, of="M")], "the given motion of A of OA: M is a particle"),
    ],
)
def test_joints_and_drivers_that_say_nothing(joints: Any, drivers: Any, message: str) -> None:
    assert message in problem(written(joints, drivers, bodies={**BODIES, "M": "particle C"}))


def test_all_misfits_are_told_at_once() -> None:
    joints = [
        *CRANK,
        Slide("B", "AB", P.line(0, 1, X), GROUND),
        Arc("A", "OA", P.circle("C", 5), GROUND),
    ]
    assert len(problem(written(joints, [P.turns("OA", 1)])).splitlines()) == 2


def test_a_point_at_the_centre_has_no_circular_path() -> None:
    assert (
        "the given motion of O of OA about O: O is at the centre: it has no path about it"
        in problem(written(CRANK[:1], [P.circles("O", "OA", "O", 1)], bodies={"OA": "O A"}))
    )


def test_what_a_solved_motion_is_not_asked_for() -> None:
    motion = P.motion(
        POINTS,
        {"OA": "O A", "M": "particle A"},
        [Pin("O", ("OA", GROUND)), Pin("A", ("OA", "M"))],
        [P.turns("OA", 0)],
    )
    with pytest.raises(
        MechanismError, match="M is a particle: it does not turn - ask for the motion of its point"
    ):
        motion.alpha("M")
    with pytest.raises(
        MechanismError, match="the velocity pole of OA is at infinity: OA does not turn"
    ):
        motion.pole("OA", P.field)


def test_the_same_refusals_in_balls() -> None:
    balls = Balls(256)
    with balls.context():
        for joints, drivers, message in [
            (CRANK, [P.turns("OA", 1)], "body AB can still turn"),
            (
                [*CRANK, Slide("B", "AB", P.line(0, 0, X), GROUND)],
                [P.moves("B", "AB", X, 1)],
                "dead point",
            ),
            (
                CRANK,
                [P.turns("OA", 1), P.turns("OA", 2), P.turns("AB", 1)],
                "contradict each other",
            ),
        ]:
            with pytest.raises(MechanismError, match=message):
                solve_motion(with_numbers(written(joints, drivers), balls.number), balls)


def test_doubles_refuse_a_loose_mechanism_too() -> None:
    floats = Floats()
    with pytest.raises(MechanismError, match="body AB can still turn"):
        solve_motion(with_numbers(written(CRANK, [P.turns("OA", 1)]), floats.number), floats)
