"""A belt about two pulleys: what it states, by hand and by the length of its strands, and where it
does not fit.
"""

from __future__ import annotations

from math import acos, atan2, cos, sin
from typing import Any

import pytest

from kinegrade.errors import MechanismError
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.mechanics.geometry import size
from kinegrade.mechanics.joints import GROUND, Belt, Joint, Mesh, Pin, Slide
from kinegrade.mechanics.motion import Motion, solve_motion
from tests.mechanics.writing import Paper

STEP = 1e-6  # s


def on_arm(first: Any, second: Any, crossed: bool, p: Paper) -> Motion:
    """Pulleys of those radii on an arm from (0, 0) to (4, 3), which turns with 2 and 1, the first
    pulley with 7 and -3.
    """
    return p.motion(
        {"O": (0, 0), "A": (4, 3)},
        {"arm": "O A", "I": "O", "II": "A"},
        [
            Pin("O", ("arm", "I", GROUND)),
            Pin("A", ("arm", "II")),
            Belt("I", p.circle("O", first), "II", p.circle("A", second), "arm", crossed),
        ],
        [p.turns("arm", 2, 1), p.turns("I", 7, -3)],
    )


def test_an_open_belt_on_a_carrier() -> None:
    # relative to the arm: I 5 and -4, II twice that in the same sense
    motion = on_arm(2, 1, False, Paper())
    assert (motion.omega("II"), motion.alpha("II")) == (12, -7)
    assert motion.omega("II", "arm") == 10


def test_a_crossed_belt_on_a_carrier() -> None:
    motion = on_arm(2, 1, True, Paper())
    assert (motion.omega("II"), motion.alpha("II")) == (-8, 9)


def test_a_crossed_belt_between_fixed_centres() -> None:
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (4, 0)},
        {"I": "O", "II": "A"},
        [
            Pin("O", ("I", GROUND)),
            Pin("A", ("II", GROUND)),
            Belt("II", p.circle("A", 2), "I", p.circle("O", 1), GROUND, crossed=True),
        ],
        [p.turns("I", 6, 4)],
    )
    assert (motion.omega("II"), motion.alpha("II")) == (-3, -2)


def test_about_a_fixed_pulley_an_open_belt_of_equal_radii_keeps_the_other_from_turning() -> None:
    p = Paper()
    motion = p.motion(
        {"O": (0, 0), "A": (4, 0)},
        {"arm": "O A", "II": "A"},
        [
            Pin("O", ("arm", GROUND)),
            Pin("A", ("arm", "II")),
            Belt("II", p.circle("A", 1), GROUND, p.circle("O", 1), "arm"),
        ],
        [p.turns("arm", 5, 2)],
    )
    assert (motion.omega("II"), motion.alpha("II")) == (0, 0)


def list_strands(first: float, second: float, crossed: bool) -> list[tuple[complex, complex]]:
    """The ends of both strands when the arm lies as in `on_arm`, found by the angle between a
    radius to a strand and the line of centres.
    """
    other = -second if crossed else second
    toward, lean = atan2(3, 4), acos((first - other) / 5)
    radii = [complex(cos(toward + turn), sin(toward + turn)) for turn in (lean, -lean)]
    return [(first * radius, 4 + 3j + other * radius) for radius in radii]


def move(motion: Motion, body: str, centre: str, place: complex, time: float) -> complex:
    """Where a place of a body is after a short time."""
    at, velocity = motion.frames.mechanism.points[centre], motion.velocity(centre, body)
    start = complex(size(at.x), size(at.y))
    moved = start + complex(size(velocity.x), size(velocity.y)) * time
    turn = size(motion.omega(body)) * time
    return moved + (place - start) * complex(cos(turn), sin(turn))


@pytest.mark.parametrize("crossed", [False, True])
@pytest.mark.parametrize("radii", [(2, 1), (1, 3), (2, 2)])
def test_no_strand_gets_longer_or_shorter(radii: tuple[int, int], crossed: bool) -> None:
    """The two bits of the rims at which a strand ends move with the belt, which does not stretch."""
    motion = on_arm(*radii, crossed, Paper())
    for start, end in list_strands(*radii, crossed):
        lengths = [
            abs(move(motion, "II", "A", end, time) - move(motion, "I", "O", start, time))
            for time in (-STEP, STEP)
        ]
        assert abs(end - start) == pytest.approx(lengths[0], 1e-3)
        assert lengths[1] - lengths[0] == pytest.approx(0, abs=1e-13)


def test_a_strand_of_the_other_belt_would_stretch() -> None:
    motion = on_arm(2, 1, True, Paper())
    start, end = list_strands(2, 1, False)[0]
    rate = abs(move(motion, "II", "A", end, STEP) - move(motion, "I", "O", start, STEP)) - abs(
        move(motion, "II", "A", end, 0) - move(motion, "I", "O", start, 0)
    )
    assert abs(rate / STEP) == pytest.approx(20, rel=1e-3)  # (2 * 5) one way, (1 * -10) the other


P = Paper()
PINS = (Pin("O", ("arm", "I", GROUND)), Pin("A", ("arm", "II")))


def list_problems(*joints: Joint) -> list[dict[str, str]]:
    """What is wrong with two pulleys on an arm of 5, in every language."""
    mechanism = P.mechanism(
        {"O": (0, 0), "A": (4, 3)},
        {"arm": "O A", "I": "O", "II": "A"},
        list(joints),
        [P.turns("arm", 2), P.turns("I", 7)],
    )
    with pytest.raises(MechanismError) as refusal:
        solve_motion(mechanism, P.field)
    return [
        {code: open_catalogue(Language(code)).write(problem) for code in ("en", "de", "zh")}
        for problem in refusal.value.faults
    ]


def belt(first: Any, second: Any, crossed: bool = False, carrier: str = "arm") -> Belt:
    return Belt("I", P.circle("O", first), "II", P.circle("A", second), carrier, crossed)


@pytest.mark.parametrize("radii", [(3, 2), (4, 2), (2, 3)])
def test_a_crossed_belt_needs_room_between_the_pulleys(radii: tuple[int, int]) -> None:
    (problem,) = list_problems(*PINS, belt(*radii, crossed=True))
    least = sum(radii)
    assert problem == {
        "en": "the belt about I and II: O and A are 5 apart: a crossed belt needs more than "
        f"{least}, the sum of the radii",
        "de": "der Riemen um I und II: O und A haben den Abstand 5: ein gekreuzter Riemen braucht "
        f"mehr als {least}, die Summe der Radien",
        "zh": f"I 与 II 之间的带传动: O 与 A 相距 5：交叉传动的中心距须大于两半径之和 {least}",
    }


@pytest.mark.parametrize("radii", [(6, 1), (1, 6), (7, 1)])
def test_an_open_belt_needs_pulleys_of_which_none_lies_within_the_other(
    radii: tuple[int, int],
) -> None:
    (problem,) = list_problems(*PINS, belt(*radii))
    least = abs(radii[0] - radii[1])
    assert problem == {
        "en": "the belt about I and II: O and A are 5 apart: an open belt needs more than "
        f"{least}, the difference of the radii",
        "de": "der Riemen um I und II: O und A haben den Abstand 5: ein offener Riemen braucht "
        f"mehr als {least}, die Differenz der Radien",
        "zh": f"I 与 II 之间的带传动: O 与 A 相距 5：开口传动的中心距须大于两半径之差 {least}",
    }


def test_an_open_belt_fits_where_a_crossed_one_does_not() -> None:
    assert on_arm(3, 2, False, Paper()).omega("II", "arm") == P.number("15/2")


def test_the_radius_of_a_pulley_is_positive() -> None:
    (problem,) = list_problems(*PINS, belt(0, 2))
    assert problem["en"] == (
        "the belt about I and II: a circle of radius 0: the radius must be positive"
    )


@pytest.mark.parametrize("crossed", [False, True])
def test_both_centres_are_on_the_carrier(crossed: bool) -> None:
    (problem,) = list_problems(*PINS, belt(2, 1, crossed, carrier=GROUND))
    assert problem == {
        "en": "the belt about I and II: II does not turn about A on ground: pin II to ground at A",
        "de": "der Riemen um I und II: II dreht sich nicht um A auf ground: lagern Sie II in A "
        "drehbar an ground",
        "zh": "I 与 II 之间的带传动: II 不在 ground 上绕 A 转动：请在 A 处将 II 与 ground 铰接",
    }


def test_the_centres_of_gears_are_on_their_carrier_as_well() -> None:
    mesh = Mesh("I", P.circle("O", 3), "II", P.circle("A", 2), GROUND)
    (problem,) = list_problems(*PINS, mesh)
    assert problem["en"].endswith("II does not turn about A on ground: pin II to ground at A")


def test_a_pulley_may_be_pinned_to_its_carrier_by_way_of_the_ground() -> None:
    apart = (Pin("O", ("arm", GROUND)), Pin("O", ("I", GROUND)), Pin("A", ("arm", "II")))
    mechanism = P.mechanism(
        {"O": (0, 0), "A": (4, 3)},
        {"arm": "O A", "I": "O", "II": "A"},
        [*apart, belt(2, 1)],
        [P.turns("arm", 2), P.turns("I", 7)],
    )
    assert solve_motion(mechanism, P.field).omega("II") == 12


def test_a_centre_that_only_slides_on_the_carrier_is_not_held_there() -> None:
    slide = Slide("A", "II", P.line(0, 0, (4, 3)), "arm")
    (problem,) = list_problems(PINS[0], slide, belt(2, 1))
    assert "II does not turn about A on arm" in problem["en"]
