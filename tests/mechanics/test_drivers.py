"""Every driver kind on an example that can be worked out by hand."""

from __future__ import annotations

from kinegrade.mechanics.joints import GROUND, Parallel, Pin, Sleeve, Slide
from kinegrade.mechanics.laws import ImposedComponent, ImposedMotion
from tests.mechanics.writing import Paper, X, Y


def test_rotation_relative_to_another_body_adds() -> None:
    # arm 2 with 3, forearm 1 with 4 relative to it: absolute 7: v_B = (0, 6 + 7); a_B = (-18 - 49,
    # 2 + 2 + 5)
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (2, 0), "B": (3, 0)},
        {"OA": "O A", "AB": "A B"},
        [Pin("O", ("OA", GROUND)), Pin("A", ("OA", "AB"))],
        [p.turns("OA", 3, 1), p.turns("AB", 4, 6, of="OA")],
    )
    assert motion.omega("AB") == 7
    assert motion.omega("AB", "OA") == 4
    assert motion.alpha("AB") == 7
    assert motion.velocity("B", "AB") == (0, 13)
    assert motion.acceleration("B", "AB") == (-67, 9)


def test_rotation_seen_from_the_body_the_other_way_round() -> None:
    # the crank turns with -5 seen from the rod, the rod with 2: so the crank with -3
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (1, 0)},
        {"OA": "O A", "AB": "A"},
        [Pin("O", ("OA", GROUND)), Pin("A", ("OA", "AB"))],
        [p.turns("OA", -5, 0, of="AB"), p.turns("AB", 2)],
    )
    assert motion.omega("OA") == -3
    assert motion.velocity("A", "OA") == (0, -3)


def test_component_of_a_guided_point_is_its_motion_along_the_guide() -> None:
    # ladder 5: foot at (4, 0) driven with 3 away, head at (0, 3): v_head = -3*4/3 = -4; omega = 1
    # (pole at (4, 3)) x^2 + y^2 = 25 with x'' = 0: y'' = -(x'^2 + y'^2)/y = -25/3 = -3*1^2 - 4
    # alpha: alpha = 4/3
    p = Paper()
    motion = p.motion(
        {"A": (4, 0), "B": (0, 3)},
        {"AB": "A B"},
        [Slide("A", "AB", p.line(0, 0, X), GROUND), Slide("B", "AB", p.line(0, 0, Y), GROUND)],
        [p.moves("A", "AB", X, 3)],
    )
    assert motion.velocity("B", "AB") == (0, -4)
    assert motion.omega("AB") == 1
    assert motion.acceleration("B", "AB") == (0, p.number("-25/3"))
    assert motion.alpha("AB") == p.number("4/3")
    assert motion.pole("AB", p.field) == (4, 3)


def test_components_of_a_free_particle_two_at_once() -> None:
    p = Paper()
    motion = p.motion(
        {"M": (1, 1)},
        {"M": "particle M"},
        [],
        [p.moves("M", "M", X, 3, 1), p.moves("M", "M", ("3/5", "4/5"), 5, 0)],
    )
    # v_y: 5 = 3*3/5 + 4/5 v_y: v_y = 4; a_y: 0 = 3/5 + 4/5 a_y: a_y = -3/4
    assert motion.velocity("M", "M") == (3, 4)
    assert motion.acceleration("M", "M") == (1, p.number("-3/4"))


def test_a_component_of_a_free_point_is_another_law_than_a_motion_along_a_guide() -> None:
    p = Paper()
    free = p.motion(
        {"M": (1, 1)},
        {"M": "particle M"},
        [],
        [p.moves("M", "M", (-1, 0), 3), p.moves("M", "M", Y, 5)],
    )
    guided = p.motion(
        {"M": (1, 0)},
        {"M": "particle M"},
        [Slide("M", "M", p.line(0, 0, X), GROUND)],
        [p.moves("M", "M", X, 3)],
    )
    laws = [relation.source for relation in free.frames.relations]
    assert laws == [ImposedComponent(0, "M", "x", (-1, 0)), ImposedComponent(1, "M", "y", Y)]
    (law,) = (relation.source for relation in guided.frames.relations)
    assert law == ImposedMotion(0, "M", GROUND, X)


def test_component_relative_to_a_moving_body_has_coriolis_acceleration() -> None:
    # a bead at distance 2 on a bar that turns with 3 (alpha 1) runs outwards with 4, 5: v = (4, 6),
    # a = (5 - 18, 2 + 24)
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "M": (2, 0)},
        {"bar": "O", "M": "particle M"},
        [Pin("O", ("bar", GROUND)), Slide("M", "M", p.line(0, 0, X), "bar")],
        [p.turns("bar", 3, 1), p.moves("M", "M", X, 4, 5, of="bar")],
    )
    assert motion.velocity("M", "M") == (4, 6)
    assert motion.acceleration("M", "M") == (-13, 26)
    assert motion.relative_velocity("M", "M", "bar") == (4, 0)
    assert motion.coriolis("M", "M", "bar") == (0, 24)
    assert motion.relative_acceleration("M", "M", "bar") == (5, 0)


def test_component_across_the_path_of_a_point_that_nothing_guides_on_the_moving_body() -> None:
    # two components seen from the bar, no slot at all: the same bead
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "M": (2, 0)},
        {"bar": "O", "M": "particle M"},
        [Pin("O", ("bar", GROUND))],
        [
            p.turns("bar", 3, 1),
            p.moves("M", "M", X, 4, 5, of="bar"),
            p.moves("M", "M", Y, 0, of="bar"),
        ],
    )
    assert motion.velocity("M", "M") == (4, 6)
    assert motion.acceleration("M", "M") == (-13, 26)


def test_circulation_along_a_circle_of_two_metres() -> None:
    # v = 6 counter-clockwise on a circle of 2: omega = 3; a = (-6^2/2, 4): alpha = 2
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (2, 0)},
        {"OA": "O A"},
        [Pin("O", ("OA", GROUND))],
        [p.circles("A", "OA", "O", 6, 4)],
    )
    assert motion.omega("OA") == 3
    assert motion.alpha("OA") == 2
    assert motion.velocity("A", "OA") == (0, 6)
    assert motion.acceleration("A", "OA") == (-18, 4)


def test_two_drivers_at_once_on_one_link() -> None:
    # A runs to the right with 3, B, 5 above it, with 1: omega = (3 - 1)/5
    p = Paper()
    motion = p.motion(
        {"A": (0, 0), "B": (0, 5)},
        {"left": "A", "right": "B", "AB": "A B"},
        [
            Sleeve("left", p.line(0, 0, X), GROUND),
            Pin("A", ("left", "AB")),
            Parallel("right", GROUND),
            Slide("B", "right", p.line(0, 5, X), GROUND),
            Slide("B", "right", p.line(0, 0, Y), "AB"),
        ],
        [p.moves("A", "left", X, 3, 0), p.moves("B", "right", X, 1, 0)],
    )
    assert motion.omega("AB") == p.number("2/5")
    assert motion.alpha("AB") == 0  # v_r along AB is zero, and so are both inputs' accelerations
    assert motion.relative_acceleration("B", "right", "AB") == (
        0,
        p.number("4/5"),
    )  # omega^2*5 away from A
