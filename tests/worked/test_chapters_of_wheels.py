"""Chapters of small solutions as a reader sees them: wheels on lines and on circles."""

from __future__ import annotations

import re

import pytest

from kinegrade.language import Language
from tests.worked.chapters import as_read, find_untold, read_chapter, solve_small
from tests.worked.draws import kept
from tests.worked.telling import proses

ON_A_LINE = """
joints = ["circle(C, 2) of wheel rolls on line(D, 0)"]
inputs = [{ motion = "C of wheel moves along +x", velocity = "6", acceleration="2" }]
[points]
D = "(0, 0)"
C = "(0, 2)"
P = "(2, 2)"
[bodies]
wheel = "C D P"
"""

ON_A_CIRCLE = """
joints = ["circle(C, 2) of wheel rolls on circle(O, 4)"]
inputs = [{ motion = "wheel turns", velocity = "3" }]
[points]
O = "(0, 0)"
C = "(0, 6)"
D = "(0, 4)"
[bodies]
wheel = "C D"
"""

GEARS = """
joints = [
  "pin O: ground gear",
  "pin C: ground pinion",
  "circle(C, 1) of pinion rolls on circle(O, 3) of gear",
]
inputs = [{ motion = "gear turns", velocity = "2", acceleration="5" }]
[points]
O = "(0, 0)"
C = "(4, 0)"
[bodies]
gear = "O"
pinion = "C"
"""

DRIVEN_ROUND = """
joints = ["circle(A, 1) of W rolls on circle(O, 4) inside"]
inputs = [{ motion = "A of W circles O", velocity = "6", acceleration="3" }]
[points]
O = "(0, 0)"
A = "(3, 0)"
B = "(3, 1)"
[bodies]
W = "A B"
"""


def test_a_fixed_rope_is_a_fixed_track() -> None:
    rope = ON_A_LINE.replace("line(D, 0)", "line(D, 0) of rope").replace(
        "joints = [", 'joints = ["pin E: ground rope", "rope translates", '
    )
    rope = rope.replace("[bodies]", 'E = "(9, 0)"\n[bodies]\nrope = "E"')
    asks = {"omega": "omega(wheel) in rad/s", "v": "magnitude(velocity(P)) in m/s"}
    asks |= {"a": "magnitude(acceleration(P)) in m/s^2"}
    for chapter in ("# Velocities", "# Accelerations"):
        plain = read_chapter(chapter, solve_small(ON_A_LINE, **asks))
        assert read_chapter(chapter, solve_small(rope, **asks)) == plain


def test_rolling_on_a_line() -> None:
    solution = solve_small(ON_A_LINE, omega="omega(wheel) in rad/s")
    assert read_chapter("# Velocities", solution) == as_read(
        r"""
        Numbers after $\approx$ are rounded, to 4 significant digits (any angles to 2 decimals);
            where they are put in, they count in full.
        Rotations are positive counter-clockwise. The words in brackets after a value give the actual
            sense.
        Given: the velocity of $C$.
        v_{C} &= 6\,\unit{m/s}\quad\text{(to the right)}
        ## The wheel rolls without slipping on a fixed straight track
        As the wheel does not slip, its point of contact is its velocity pole, so the motion of
            $C$ ($v_{C}$ positive to the right) and the rotation of the wheel are linked:
        \omega &= -\frac{v_{C}}{2\,\unit{m}} = -\frac{6\,\unit{m/s}}{2\,\unit{m}} =
            -3\,\unit{rad/s}\quad\text{(clockwise)}
        """
    )


def test_the_points_of_a_rolling_wheel() -> None:
    # The point of contact accelerates towards the centre: omega^2 r = 18
    solution = solve_small(
        ON_A_LINE, v_P="magnitude(velocity(P)) in m/s", a_D="magnitude(acceleration(D)) in m/s^2"
    )
    assert not find_untold(
        r"""
        The point of contact $D$ is the velocity pole of the wheel, so the velocity of $P$ is
            normal to $DP$:
        v_{P} &= DP \cdot \left|\omega_{\text{wheel}}\right| = 2.8284\,\unit{m} \cdot 3\,\unit{rad/s} \approx
            8.4853\,\unit{m/s}
        $D$ is a point of the wheel, base point $C$:
        a_{D,x} &= a_{C} + \alpha_{\text{wheel}}\,y_{C} = 2\,\unit{m/s^2} + (-1\,\unit{rad/s^2}) \cdot
            2\,\unit{m} = 0
        a_{D,y} &= \omega_{\text{wheel}}^{2}\,y_{C} = (-3\,\unit{rad/s})^{2} \cdot 2\,\unit{m} =
            18\,\unit{m/s^2}
        a_{D} &= a_{D,y} = 18\,\unit{m/s^2}
        """,
        solution,
    )


def test_rolling_on_a_circle() -> None:
    # C is above the contact: it goes to the left, counter-clockwise about O
    solution = solve_small(ON_A_CIRCLE, v_C="magnitude(velocity(C)) in m/s")
    assert read_chapter(
        "## The wheel rolls without slipping on a fixed circle", solution
    ) == as_read(
        r"""
        As the wheel does not slip, its point of contact is its velocity pole, so the motion of
            $C$ ($v_{C}$ positive counter-clockwise about $O$) and the rotation of the wheel
            are linked:
        v_{C} &= 2\,\unit{m} \cdot \omega_{\text{wheel}} = 2\,\unit{m} \cdot 3\,\unit{rad/s} =
            6\,\unit{m/s}\quad\text{(counter-clockwise about }O\text{)}
        """
    )


def test_rolling_inside_a_circle() -> None:
    # C is below the contact: it goes to the right, clockwise about O
    solution = solve_small(
        ON_A_CIRCLE.replace("(0, 6)", "(0, 2)").replace("O, 4)", "O, 4) inside"),
        v_C="magnitude(velocity(C)) in m/s",
        a_C="magnitude(acceleration(C)) in m/s^2",
    )
    assert read_chapter("# Velocities", solution) == as_read(
        r"""
        Angular velocities $\omega$ and angular accelerations $\alpha$ are positive counter-clockwise. The words in brackets after a value give the actual
            sense.
        Given: the angular velocity of the wheel.
        \omega_{\text{wheel}} &= 3\,\unit{rad/s}\quad\text{(counter-clockwise)}
        ## The wheel rolls without slipping on a fixed circle
        As the wheel does not slip, its point of contact is its velocity pole, so the motion of
            $C$ ($v_{C}$ positive counter-clockwise about $O$) and the rotation of the wheel
            are linked:
        v_{C} &= -2\,\unit{m} \cdot \omega_{\text{wheel}} = -2\,\unit{m} \cdot 3\,\unit{rad/s} =
            -6\,\unit{m/s}\quad\text{(clockwise about }O\text{)}
        \left|v_{C}\right| &= 6\,\unit{m/s}
        """
    )


def test_the_centre_of_a_wheel_on_a_circle_accelerates_towards_the_middle() -> None:
    # 6^2 / 6, and inside 6^2 / 2
    solution = solve_small(
        ON_A_CIRCLE.replace("(0, 6)", "(0, 2)").replace("O, 4)", "O, 4) inside"),
        a_C="magnitude(acceleration(C)) in m/s^2",
    )
    assert not find_untold(
        r"""
        $C$ moves on the circle about $O$; its normal acceleration follows from its speed, the
            tangential one is known:
        a_{C}^{\mathrm{n}} &= \frac{v_{C}^{2}}{OC} = \frac{(6\,\unit{m/s})^{2}}{2\,\unit{m}} =
            18\,\unit{m/s^2}
        a_{C} &= a_{C}^{\mathrm{n}} = 18\,\unit{m/s^2}
        """,
        solution,
    )


def test_a_centre_that_is_driven_on_its_circle() -> None:
    solution = solve_small(DRIVEN_ROUND, omega="omega(W) in rad/s", alpha="alpha(W) in rad/s^2")
    assert read_chapter("# Velocities", solution) == as_read(
        r"""
        Numbers after $\approx$ are rounded, to 4 significant digits (any angles to 2 decimals);
            where they are put in, they count in full.
        Angular velocities $\omega$ and angular accelerations $\alpha$ are positive counter-clockwise. The words in brackets after a value give the actual
            sense.
        Given: the velocity of $A$ on its circle about $O$.
        v_{A} &= 6\,\unit{m/s}\quad\text{(counter-clockwise about }O\text{)}
        ## The wheel rolls without slipping on a fixed circle
        As the wheel does not slip, its point of contact is its velocity pole, so the motion of
            $A$ ($v_{A}$ positive counter-clockwise about $O$) and the rotation of the wheel
            are linked:
        \omega &= -\frac{v_{A}}{1\,\unit{m}} = -\frac{6\,\unit{m/s}}{1\,\unit{m}} =
            -6\,\unit{rad/s}\quad\text{(clockwise)}
        """
    )


def test_the_given_tangential_acceleration() -> None:
    solution = solve_small(DRIVEN_ROUND, alpha="alpha(W) in rad/s^2")
    assert read_chapter("# Accelerations", solution) == as_read(
        r"""
        Given: the tangential acceleration of $A$ on its circle about $O$.
        a_{A}^{\mathrm{t}} &= 3\,\unit{m/s^2}\quad\text{(counter-clockwise about }O\text{)}
        ## The wheel rolls without slipping on a fixed circle
        The condition of no slip holds at all times; differentiated with respect to time, it links
            the tangential acceleration of $A$ ($a_{A}^{\mathrm{t}}$ positive counter-clockwise
            about $O$) and the rotation of the wheel:
        \alpha &= -\frac{a_{A}^{\mathrm{t}}}{1\,\unit{m}} = -\frac{3\,\unit{m/s^2}}{1\,\unit{m}} =
            -3\,\unit{rad/s^2}\quad\text{(clockwise)}
        """
    )


def test_gears_with_fixed_axes() -> None:
    # Radii 3 and 1: the pinion turns three times as fast, the other way
    solution = solve_small(GEARS, omega="omega(pinion) in rad/s")
    assert read_chapter("# Velocities", solution) == as_read(
        r"""
        Rotations are positive counter-clockwise. A vector's letter stands for its component in the direction given in its first table ($\perp$ with $\curvearrowleft$: turned through $90^\circ$
            counter-clockwise from what is named). The words in brackets after a value give the actual sense.
        Given: the angular velocity of the gear.
        \omega_{O} &= 2\,\unit{rad/s}\quad\text{(counter-clockwise)}
        ## 1. Composition of motions: moving point $C$, moving frame on the gear
        $\boldsymbol{v}_{\mathrm{a}} = \boldsymbol{v}_{\mathrm{e}} + \boldsymbol{v}_{\mathrm{r}}$: the
            absolute velocity of $C$ (of the pinion) is its transport velocity (that of the point of the
            gear which is at $C$) plus the relative one (seen from the gear).
            Here $OC = x_{C} = 4\,\unit{m}$.
        Here $\boldsymbol{v}_{\mathrm{a}} = 0$.
        [ ] 0 | |
        [=] \boldsymbol{v}_{\mathrm{e}} | $OC \cdot \omega_{O} = 8\,\unit{m/s}$ | $\perp OC,\curvearrowleft$
        [+] \boldsymbol{v}_{\mathrm{r}} | ? | $\perp OC,\curvearrowleft$
        Projecting on the $y$ axis:
        0 &= v_{\mathrm{e}} + v_{\mathrm{r}}
        v_{\mathrm{r}} &= -v_{\mathrm{e}} = -8\,\unit{m/s}\quad\text{(downwards)}
        ## 2. The pinion rolls without slipping on the gear
        There is no slip at the contact with the gear; seen from the gear, the point of the pinion
            at the contact is at rest, so the motion of $C$ and the rotation of the pinion are linked:
        v_{\mathrm{r}} &= 1\,\unit{m} \cdot (\omega - \omega_{O})
        \omega &= \omega_{O} + \frac{v_{\mathrm{r}}}{1\,\unit{m}} = 2\,\unit{rad/s} -
            \frac{8\,\unit{m/s}}{1\,\unit{m}} = -6\,\unit{rad/s}\quad\text{(clockwise)}
        """
    )


def test_a_wheel_on_two_tracks_rolls_on_both() -> None:
    # it was said to roll on the rope A alone
    said = next(
        text for text in proses(kept("stepped-drum-on-two-ropes")) if "plane motion" in text
    )
    assert "plane motion, without slip on the rope $A$ and the rope $B$;" in said


ROLLING_ON_ROPES = {
    "en": (r"\b(?:rolls?|rolling)\b[^.,;:]*\b(?:rope|cord)", r"\btracks\b"),
    "de": (r"(?:rollt|Rollen)\b[^.,;:]*Seil", r"\bBahnen\b"),
    "zh": (r"绳[^，。；：与]*上[^，。；：]*滚动", "两条"),
}


@pytest.mark.parametrize("language", ["en", "de", "zh"])
@pytest.mark.parametrize("name", ["spool-pulled-by-cord", "stepped-drum-on-two-ropes"])
def test_nothing_rolls_on_a_cord_which_is_no_track(name: str, language: Language) -> None:
    page = "\n".join(proses(kept(name, 0, None, language)))
    assert [each for each in ROLLING_ON_ROPES[language] if re.search(each, page)] == []


ROPE = """
joints = [
  "pin C: ground drum",
  "rope translates",
  "E of rope slides on line(E, pi/2)",
  "circle(C, 2) of drum rolls on line(E, pi/2) of rope",
]
inputs = [{ motion = "drum turns", velocity = "-3", acceleration="5" }]
[points]
C = "(0, 0)"
E = "(2, -4)"
[bodies]
drum = "C"
rope = "E"
"""


def test_a_rope_moves_with_the_rim_of_its_drum() -> None:
    asks = {"v": "y(velocity(E)) in m/s", "a": "y(acceleration(E)) in m/s^2"}
    told = r"""
        ## The rope moves with the rim of radius $2\,\unit{m}$ of the drum
        There is no slip at the contact, and the centre of the drum is fixed; so the rope has the\
             speed of this rim ($v_{E}$ positive upwards):
        v_{E} &= 2\,\unit{m} \cdot \omega_{C} = 2\,\unit{m} \cdot (-3\,\unit{rad/s}) = -6\,\unit{m/s}
        The rope has the speed of this rim of the drum at any time; differentiated with respect\
             to time ($a_{E}$ positive upwards):
        a_{E} &= 2\,\unit{m} \cdot \alpha_{C} = 2\,\unit{m} \cdot 5\,\unit{rad/s^2} = 10\,\unit{m/s^2}
        """
    assert find_untold(told, solve_small(ROPE, **asks)) == []


def test_a_drum_turns_with_the_speed_of_its_rope() -> None:
    pulled = ROPE.replace("drum turns", "E of rope moves along -y").replace('"-3"', '"6"')
    told = r"\omega &= -\frac{v_{E}}{2\,\unit{m}} = -\frac{6\,\unit{m/s}}{2\,\unit{m}}"
    assert find_untold(told, solve_small(pulled, omega="omega(drum) in rad/s")) == []


def test_a_drum_that_moves_is_seen_from_its_rope() -> None:
    """v_r is negative by the rolling drum; as the velocity seen from the rope it counts by its
    size.
    """
    joints = [line for line in ROPE.splitlines() if "pin C" not in line]
    lifted = "\n".join(joints).replace(
        "joints = [", 'joints = ["C of drum slides on line(C, pi/2)",'
    )
    lifted = lifted.replace(
        "inputs = [", 'inputs = [{ motion = "C of drum moves along +y", velocity = "1" },'
    )
    solution = solve_small(lifted.replace('"-3"', '"3"'), v="y(velocity(E)) in m/s")
    relative = r"v_{\mathrm{r}}"
    told = rf"""
        Known: the motion of $C$ and the rotation of the drum. Sought: $v$ (asked). The drum rolls\
             without slipping on the rope, which links its rotation and the motion of its centre\
             $C$, both seen from the rope. Seen from the rope, the motion of $C$ is known by then,\
             so composing its motions leaves one magnitude unknown.
        {relative} &= -2
        v_{{\mathrm{{a}}}} &= v_{{E}} - \left|{relative}\right|
        """
    assert find_untold(told, solution) == []
