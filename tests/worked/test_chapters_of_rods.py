"""Chapters of small solutions as a reader sees them: rods whose ends are guided, by each method."""

from __future__ import annotations

from tests.worked.chapters import as_read, find_untold, read_chapter, solve_small

LADDER = """
joints = ["A of AB slides on line(O, pi/2)", "B of AB slides on line(O, 0)"]
inputs = [{ motion = "B of AB moves along +x", velocity = "2" }]
[points]
O = "(0, 0)"
A = "(0, 3)"
B = "(4, 0)"
[bodies]
AB = "A B"
"""

CRANK_UP = """
joints = ["pin O: ground OA", "pin A: OA AB", "B of AB slides on line(O, 0)"]
inputs = [{ motion = "OA turns", velocity = "2" }]
[points]
O = "(0, 0)"
A = "(0, 3)"
B = "(4, 0)"
[bodies]
OA = "O A"
AB = "A B"
"""


def test_velocities_by_a_base_point() -> None:
    # A ladder of 5 m: v_B = 2, so v_A = -2 * 4/3 and omega = 2/3 about the point above B
    solution = solve_small(LADDER, v_A="y(velocity(A)) in m/s", omega="omega(AB) in rad/s")
    assert read_chapter("## 1. $AB$: base point $B$", solution) == as_read(
        r"""
        Base point method for $AB$: the velocity of $A$ is the velocity of the base point $B$ plus
            that of the rotation about $B$.
        [ ] \boldsymbol{v}_{A} | ? | $\parallel y$
        [=] \boldsymbol{v}_{B} | $2\,\unit{m/s}$ | $\parallel x$
        [+] \boldsymbol{v}_{AB} | ? $(BA \cdot \omega)$ | $\perp BA$
        Here $BA = \sqrt{x_{B}^{2} + y_{A}^{2}} = \sqrt{(4\,\unit{m})^{2} + (3\,\unit{m})^{2}} =
            5\,\unit{m}$.
        $BA$ makes the acute angle $\psi_{BA}$ with the $x$ axis:
        \tan\psi_{BA} &= \frac{y_{A}}{x_{B}} = \frac{3\,\unit{m}}{4\,\unit{m}} = 0.75
        \psi_{BA} &\approx 36.87^\circ
        Projected on the direction from $B$ to $A$, normal to $\boldsymbol{v}_{AB}$, which so drops
            out:
        v_{A}\sin\psi_{BA} &= -v_{B}\cos\psi_{BA}
        v_{A} &= -\frac{v_{B}\cos\psi_{BA}}{\sin\psi_{BA}} = -\frac{2\,\unit{m/s} \cdot \cos
            36.87^\circ}{\sin 36.87^\circ} = -\frac{8}{3}\,\unit{m/s} \approx
            -2.667\,\unit{m/s}\quad\text{(downwards)}
        Projected on the normal to $\boldsymbol{v}_{A}$, which so drops out:
        0 &= -v_{B} + v_{AB}\sin\psi_{BA}
        v_{AB} &= \frac{v_{B}}{\sin\psi_{BA}} = \frac{2\,\unit{m/s}}{\sin 36.87^\circ} =
            \frac{10}{3}\,\unit{m/s} \approx 3.333\,\unit{m/s}
        \omega &= \frac{v_{AB}}{BA} = \frac{3.333\,\unit{m/s}}{5\,\unit{m}} =
            \frac{2}{3}\,\unit{rad/s} \approx 0.6667\,\unit{rad/s}\quad\text{(counter-clockwise)}
        """
    )


def test_velocities_by_the_projection_theorem() -> None:
    solution = solve_small(LADDER, v_A="y(velocity(A)) in m/s")
    assert read_chapter(
        "## 1. $AB$: velocity projection theorem", solution, "projection"
    ) == as_read(
        r"""
        Velocity projection theorem: the velocities of $B$ and $A$ of $AB$ have equal projections on
            the line $BA$.
        v_{A}\sin\psi_{BA} &= -v_{B}\cos\psi_{BA}
        v_{A} &= -\frac{v_{B}\cos\psi_{BA}}{\sin\psi_{BA}} = -\frac{2\,\unit{m/s} \cdot \cos
            36.87^\circ}{\sin 36.87^\circ} = -\frac{8}{3}\,\unit{m/s} \approx
            -2.667\,\unit{m/s}\quad\text{(downwards)}
        Base point method for $AB$: the velocity of $A$ is the velocity of the base point $B$ plus
            that of the rotation about $B$.
        [ ] \boldsymbol{v}_{A} | ? | $\parallel y$
        [=] \boldsymbol{v}_{B} | $2\,\unit{m/s}$ | $\parallel x$
        [+] \boldsymbol{v}_{AB} | ? $(BA \cdot \omega_{AB})$ | $\perp BA$
        Here $BA = \sqrt{x_{B}^{2} + y_{A}^{2}} = \sqrt{(4\,\unit{m})^{2} + (3\,\unit{m})^{2}} =
            5\,\unit{m}$.
        $BA$ makes the acute angle $\psi_{BA}$ with the $x$ axis:
        \tan\psi_{BA} &= \frac{y_{A}}{x_{B}} = \frac{3\,\unit{m}}{4\,\unit{m}} = 0.75
        \psi_{BA} &\approx 36.87^\circ
        Projected on the normal to $\boldsymbol{v}_{A}$, which so drops out:
        0 &= -v_{B} + v_{AB}\sin\psi_{BA}
        v_{AB} &= \frac{v_{B}}{\sin\psi_{BA}} = \frac{2\,\unit{m/s}}{\sin 36.87^\circ} =
            \frac{10}{3}\,\unit{m/s} \approx 3.333\,\unit{m/s}
        \omega_{AB} &= \frac{v_{AB}}{BA} = \frac{3.333\,\unit{m/s}}{5\,\unit{m}} =
            \frac{2}{3}\,\unit{rad/s} \approx 0.6667\,\unit{rad/s}\quad\text{(counter-clockwise)}
        """
    )


def test_velocities_by_the_instantaneous_centre() -> None:
    solution = solve_small(LADDER, v_A="y(velocity(A)) in m/s", omega="omega(AB) in rad/s")
    assert read_chapter(
        "## 1. $AB$: instantaneous centre of velocity", solution, "pole"
    ) == as_read(
        r"""
        Instantaneous centre of $AB$: the normals to the velocities of $B$ and $A$ meet in the pole
            $P$.
        P &: (4\,\unit{m},\quad 3\,\unit{m})
        PB &= 3\,\unit{m}
        PA &= 4\,\unit{m}
        \left|\omega\right| &= \frac{v_{B}}{PB} = \frac{2\,\unit{m/s}}{3\,\unit{m}}
        \omega &= \frac{2}{3}\,\unit{rad/s} \approx
            0.6667\,\unit{rad/s}\quad\text{(counter-clockwise)}
        \left|v_{A}\right| &= PA \cdot \left|\omega\right| = 4\,\unit{m} \cdot 0.6667\,\unit{rad/s}
            = \frac{8}{3}\,\unit{m/s} \approx 2.667\,\unit{m/s}\quad\text{(downwards)}
        v_{A} &= -\frac{8}{3}\,\unit{m/s} \approx -2.667\,\unit{m/s}
        """
    )


def test_a_pole_that_is_asked_for() -> None:
    solution = solve_small(
        LADDER, x_S="x(pole(AB)) in m", y_S="y(pole(AB)) in m", OS="distance(O, pole(AB)) in m"
    )
    assert not find_untold(
        r"""
        """,
        solution,
        "pole",
    )


def test_a_rod_whose_end_stands_still() -> None:
    # Nothing moves: no vector of length zero is drawn into a table
    solution = solve_small(
        LADDER.replace('"2"', '"0"'), v_A="y(velocity(A)) in m/s", omega="omega(AB) in rad/s"
    )
    assert read_chapter("## 1. $AB$: base point $B$", solution) == as_read(
        r"""
        Base point method for $AB$: the velocity of $A$ is the velocity of the base point $B$ plus
            that of the rotation about $B$.
        [ ] \boldsymbol{v}_{A} | ? | $\parallel y$
        [=] \boldsymbol{v}_{AB} | ? $(BA \cdot \omega)$ | $\perp BA$
        Here $BA = \sqrt{x_{B}^{2} + y_{A}^{2}} = \sqrt{(4\,\unit{m})^{2} + (3\,\unit{m})^{2}} =
            5\,\unit{m}$.
        At this instant $v_{B} = 0$.
        $BA$ makes the acute angle $\psi_{BA}$ with the $x$ axis:
        \tan\psi_{BA} &= \frac{y_{A}}{x_{B}} = \frac{3\,\unit{m}}{4\,\unit{m}} = 0.75
        \psi_{BA} &\approx 36.87^\circ
        Projected on the direction from $B$ to $A$, normal to $\boldsymbol{v}_{AB}$, which so drops
            out:
        v_{A}\sin\psi_{BA} &= 0
        v_{A} &= 0
        Projected on the normal to $\boldsymbol{v}_{A}$, which so drops out:
        0 &= v_{AB}\sin\psi_{BA}
        v_{AB} &= 0
        \omega &= \frac{v_{AB}}{BA} = 0
        """
    )


def test_a_rod_in_instantaneous_translation() -> None:
    # The crank stands upright: both ends of the rod move horizontally
    solution = solve_small(CRANK_UP, v_B="x(velocity(B)) in m/s", omega="omega(AB) in rad/s")
    assert read_chapter("# Velocities", solution) == as_read(
        r"""
        Angular velocities and angular accelerations count positive counter-clockwise. Directions
            are given by the angle from the $x$ axis, counter-clockwise. The letter of an unknown
            vector denotes its component in the direction assumed for it, of a rotation the
            counter-clockwise one; that of a known vector denotes its magnitude.
        Given: the angular velocity of $OA$.
        \omega_{OA} &= 2\,\unit{rad/s}\quad\text{(counter-clockwise)}
        ## 1. $AB$: instantaneous centre of velocity
        The normals to the velocities of $A$ and $B$ are parallel: the pole of $AB$ is at
            infinity, the body is in instantaneous translation and all its points have the same
            velocity.
        v_{A} &= OA \cdot \omega_{OA} = 6\,\unit{m/s}\quad\text{(to the left)}
        \omega &= 0
        \left|v_{B}\right| &= v_{A} = 6\,\unit{m/s}\quad\text{(to the left)}
        v_{B} &= -6\,\unit{m/s}
        """
    )


def test_a_pole_at_infinity_that_is_asked_for() -> None:
    solution = solve_small(CRANK_UP, x_S="x(pole(AB)) in m", OS="distance(O, pole(AB)) in m")
    assert not find_untold(
        r"""
        $AB$ does not turn at this instant: its pole is at infinity.
        x_{S} &= \infty
        OS &= \infty
        """,
        solution,
    )


def test_accelerations_of_a_rod_that_does_not_turn_at_this_instant() -> None:
    # a_A = 2^2 * 3 downwards, so alpha = 12/4 and a_B = 3 * 3
    solution = solve_small(
        CRANK_UP, a_B="x(acceleration(B)) in m/s^2", alpha="alpha(AB) in rad/s^2"
    )
    assert read_chapter("# Accelerations", solution) == as_read(
        r"""
        Given: the angular acceleration of $OA$.
        \alpha_{OA} &= 0
        ## 1. $AB$: base point $A$
        Base point method for $AB$: the acceleration of $B$ is that of the base point $A$ plus the
            normal and tangential accelerations of the rotation about $A$.
        [ ] \boldsymbol{a}_{B} | ? | $\parallel x$
        [=] \boldsymbol{a}_{A}^{\mathrm{n}} | $OA \cdot \omega_{OA}^{2} = 12\,\unit{m/s^2}$ | $A \to
            O$
        [+] \boldsymbol{a}_{BA}^{\mathrm{t}} | ? $(AB \cdot \alpha)$ | $\perp AB$
        Here $OA = y_{A} = 3\,\unit{m}$, $AB = \sqrt{x_{B}^{2} + y_{A}^{2}} =
            \sqrt{(4\,\unit{m})^{2} + (3\,\unit{m})^{2}} = 5\,\unit{m}$.
        At this instant $a_{A}^{\mathrm{t}} = 0$, $a_{BA}^{\mathrm{n}} = 0$.
        $AB$ makes the acute angle $\psi_{AB}$ with the $x$ axis:
        \tan\psi_{AB} &= \frac{y_{A}}{x_{B}} = \frac{3\,\unit{m}}{4\,\unit{m}} = 0.75
        \psi_{AB} &\approx 36.87^\circ
        Projected on the direction from $A$ to $B$, normal to $\boldsymbol{a}_{BA}^{\mathrm{t}}$,
            which so drops out:
        a_{B}\cos\psi_{AB} &= a_{A}^{\mathrm{n}}\sin\psi_{AB}
        a_{B} &= \frac{a_{A}^{\mathrm{n}}\sin\psi_{AB}}{\cos\psi_{AB}} = \frac{12\,\unit{m/s^2}
            \cdot \sin 36.87^\circ}{\cos 36.87^\circ} = 9\,\unit{m/s^2}\quad\text{(to the right)}
        Projected on the $y$ axis, normal to $\boldsymbol{a}_{B}$, which so drops out:
        0 &= -a_{A}^{\mathrm{n}} + a_{BA}^{\mathrm{t}}\cos\psi_{AB}
        a_{BA}^{\mathrm{t}} &= \frac{a_{A}^{\mathrm{n}}}{\cos\psi_{AB}} =
            \frac{12\,\unit{m/s^2}}{\cos 36.87^\circ} = 15\,\unit{m/s^2}
        \alpha &= \frac{a_{BA}^{\mathrm{t}}}{AB} = \frac{15\,\unit{m/s^2}}{5\,\unit{m}} =
            3\,\unit{rad/s^2}\quad\text{(counter-clockwise)}
        """
    )
