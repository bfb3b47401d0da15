"""What the solver refuses, in the language of mechanics: every message is read."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from flint import arb

from kinegrade.errors import ExpressionError, MechanismError
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.mechanics.geometry import Constructions, Round
from kinegrade.mechanics.joints import (
    GROUND,
    Arc,
    Contact,
    Line,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.motion import solve_motion
from kinegrade.numbers.balls import Balls, Undecided
from kinegrade.numbers.floats import Floats
from tests.laws.cases import with_numbers
from tests.mechanics.writing import Paper, X, Y
from tests.small_class import kinegrade

P = Paper()
POINTS = {"O": (0, 0), "A": (3, 0), "B": (8, 0), "C": (3, 4)}
BODIES = {"OA": "O A", "AB": "A B"}
CRANK = [Pin("O", ("OA", GROUND)), Pin("A", ("OA", "AB"))]


def problem(mechanism: Mechanism) -> str:
    """The refusal of a mechanism, all its lines."""
    with pytest.raises(MechanismError) as refusal:
        solve_motion(mechanism, P.field)
    assert all("\n" not in line for line in refusal.value.problems)
    return str(refusal.value)


def written(
    joints: Any, drivers: Any = (), points: Any = POINTS, bodies: Any = BODIES
) -> Mechanism:
    return P.mechanism(points, bodies, list(joints), list(drivers))


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


def test_a_dead_point_names_the_joints_that_cannot_act_together() -> None:
    stretched = written(
        [*CRANK, Slide("B", "AB", P.line(0, 0, X), GROUND)], [P.moves("B", "AB", X, 1)]
    )
    assert problem(stretched).endswith(
        "the given motion of B of AB cannot act together: choose another configuration or driver"
    )


DYAD_POINTS = {"O": (0, 0), "C": (2, 0), "D": (5, 0), "O6": (9, 0)}
DYAD_BODIES = {"OC": "O C", "CD": "C D", "DO6": "D O6"}
DYAD = [
    Pin("O", ("OC", GROUND)),
    Pin("C", ("OC", "CD")),
    Pin("D", ("CD", "DO6")),
    Pin("O6", ("DO6", GROUND)),
]


def test_a_dead_point_says_what_is_in_line_and_asks_for_no_joint() -> None:
    """The four-bar is complete; only where its coupler and its rocker are in line they may turn
    either way.
    """
    assert problem(written(DYAD, [P.turns("OC", 0)], points=DYAD_POINTS, bodies=DYAD_BODIES)) == (
        "dead point: C, D and O6 are in line at these values: choose other values or another driver"
    )
    standing = {**DYAD_POINTS, "O": (2, -2)}
    assert problem(
        written(DYAD, [P.turns("OC", 1)], points=standing, bodies=DYAD_BODIES)
    ).startswith("dead point: C, D and O6 are in line at these values, ")


def test_a_rod_at_right_angles_to_its_guide_is_at_a_dead_point() -> None:
    upright = {**POINTS, "B": (3, 5)}
    joints = [*CRANK, Slide("B", "AB", P.line(0, 5, X), GROUND)]
    assert problem(written(joints, [P.turns("OA", 0)], points=upright)) == (
        "dead point: AB is at right angles to the line on which B slides at these values: "
        "choose other values or another driver"
    )


def test_links_in_line_that_lack_a_joint_are_loose() -> None:
    assert problem(
        written(DYAD[:3], [P.turns("OC", 1)], points=DYAD_POINTS, bodies=DYAD_BODIES)
    ).endswith("(2 degrees of freedom left): add a joint or a driver")
    assert problem(written(DYAD, [], points=DYAD_POINTS, bodies=DYAD_BODIES)).endswith(
        "left): add a joint or a driver"
    )


def test_solve_names_the_dead_point_of_a_trammel() -> None:
    shown = kinegrade("solve", "elliptic-trammel-end-driven", "--set", "phi=0")
    assert shown.exit_code == 2
    assert "dead point: AB is at right angles to the line on which B slides" in shown.stderr


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


def ground_line(y: Any) -> Line:
    return P.line(0, y, X)


BUILD = Constructions(P.field, {"A": (place := P.vector(0, 1))})


@pytest.mark.parametrize(
    ("construct", "message"),
    [
        (
            lambda: BUILD.meet(Round(place, P.number("3/10")), ground_line(0), "right"),
            "the circle about A of radius 0.3 does not reach the line y = 0",
        ),
        (
            lambda: BUILD.meet(P.line(2, 0, Y), Round(place, P.number(1)), "upper"),
            "the circle about A of radius 1 does not reach the line x = 2",
        ),
        (
            lambda: BUILD.meet(Round(place, P.number(1)), P.line(9, 0, (1, 1)), "upper"),
            "the circle about A of radius 1 does not reach the slanting line through (9, 0)",
        ),
        (
            lambda: BUILD.meet(
                Round(place, P.number(1)), Round(P.vector(5, 1), P.number(2)), "upper"
            ),
            "the circle about A of radius 1 does not reach the circle about (5, 1) of radius 2",
        ),
        (
            lambda: BUILD.meet(
                Round(place, P.number(9)), Round(P.vector(5, 1), P.number(2)), "upper"
            ),
            "the circle about A of radius 9 does not reach the circle about (5, 1) of radius 2",
        ),
        (
            lambda: BUILD.meet(
                Round(place, P.number(1)), Round(P.vector(0, 1), P.number(1)), "upper"
            ),
            "have one centre and do not meet",
        ),
        (
            lambda: BUILD.meet(Round(place, P.number(2)), P.line(1, 0, Y), "right"),
            "right does not distinguish the two common points - name another side, one of right, "
            "left, upper, lower",
        ),
        (
            lambda: BUILD.meet(Round(place, P.number(2)), P.line(1, 0, Y), "clockwise"),
            "clockwise does not distinguish the two",
        ),
        (
            lambda: BUILD.meet(ground_line(0), ground_line(3)),
            "the line y = 0 and the line y = 3 are parallel and do not meet",
        ),
    ],
)
def test_configurations_that_cannot_be_constructed(
    construct: Callable[[], Any], message: str
) -> None:
    with pytest.raises(MechanismError) as refusal:
        construct()
    assert message in str(refusal.value)


@pytest.mark.parametrize("branch", [None, "rightright", "up", place])
def test_two_common_points_need_the_name_of_a_side(branch: Any) -> None:
    with pytest.raises(
        ExpressionError,
        match="say which, one of right, left, upper, lower, counterclockwise, clockwise",
    ):
        BUILD.meet(Round(place, P.number(2)), ground_line(0), branch)


def test_a_ball_that_may_be_a_dead_point_is_undecided_rather_than_wrong() -> None:
    balls = Balls(256)
    with balls.context():
        mechanism = with_numbers(
            written(
                [*CRANK, Slide("B", "AB", P.line(0, 0, X), GROUND)], [P.moves("B", "AB", X, 1)]
            ),
            balls.number,
        )
        points = {**mechanism.points, "A": mechanism.points["A"]._replace(y=arb(0, arb("1e-30")))}
        with pytest.raises(Undecided):
            solve_motion(replace(mechanism, points=points), balls)
