"""Chapters of small solutions as a reader sees them: rods whose ends are guided, by each method."""

from __future__ import annotations

from tests.worked.chapters import as_read, find_untold, read_chapter, solve_small
from tests.worked.draws import kept, stated
from tests.worked.telling import displayed

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
    assert read_chapter("## $AB$: base point $B$", solution) == as_read(
        r"""
        The velocity of $A$ is that of the base point $B$ plus that of the rotation of $AB$ about
            $B$.
            Here $BA = \sqrt{x_{B}^{2} + y_{A}^{2}} = \sqrt{(4\,\unit{m})^{2} +
            (3\,\unit{m})^{2}} = 5\,\unit{m}$.
        [ ] \boldsymbol{v}_{A} | ? | $+y$
        [=] \boldsymbol{v}_{B} | $2\,\unit{m/s}$ | $+x$
        [+] \boldsymbol{v}_{AB} | ? $(BA \cdot \omega)$ | $\perp BA,\curvearrowleft$
        In a polygon a small letter marks the tip of the vector of the point
            with that letter, laid off from $o$.
        $BA$ makes the acute angle $\psi_{BA}$ with the $x$ axis:
        \tan\psi_{BA} &= \frac{y_{A}}{x_{B}} = \frac{3\,\unit{m}}{4\,\unit{m}} = 0.75
        \psi_{BA} &\approx 36.870^\circ
        Projecting on the direction from $B$ to $A$, which is perpendicular to
            $\boldsymbol{v}_{AB}$, eliminates $\boldsymbol{v}_{AB}$:
        v_{A}\sin\psi_{BA} &= -v_{B}\cos\psi_{BA}
        v_{A} &= -\frac{v_{B}\cos\psi_{BA}}{\sin\psi_{BA}} = -\frac{2\,\unit{m/s} \cdot \cos
            36.870^\circ}{\sin 36.870^\circ} \approx -2.6667\,\unit{m/s}\quad\text{(downwards)}
        $BA$ makes $\psi_{BA}$ with the $x$ axis, so $\boldsymbol{v}_{AB} \perp BA$ makes
            $90^\circ - \psi_{BA}$ with the $x$ axis.
            Projecting on the normal to $\boldsymbol{v}_{A}$ (to the left) eliminates
            $\boldsymbol{v}_{A}$:
        0 &= -v_{B} + v_{AB}\sin\psi_{BA}
        v_{AB} &= \frac{v_{B}}{\sin\psi_{BA}} = \frac{2\,\unit{m/s}}{\sin 36.870^\circ} \approx
            3.3333\,\unit{m/s}
        \omega &= \frac{v_{AB}}{BA} = \frac{3.3333\,\unit{m/s}}{5\,\unit{m}} \approx
            0.66667\,\unit{rad/s}\quad\text{(counter-clockwise)}
        """
    )


def test_velocities_by_the_projection_theorem() -> None:
    solution = solve_small(LADDER, v_A="y(velocity(A)) in m/s")
    assert read_chapter("## $AB$: velocity projection theorem", solution, "projection") == as_read(
        r"""
        Velocity projection theorem: the velocities of $B$ and $A$ of $AB$ have equal projections on
            the line $BA$.
        $BA$ makes the acute angle $\psi_{BA}$ with the $x$ axis:
        \tan\psi_{BA} &= \frac{y_{A}}{x_{B}} = \frac{3\,\unit{m}}{4\,\unit{m}} = 0.75
        \psi_{BA} &\approx 36.87^\circ
        v_{A}\sin\psi_{BA} &= -v_{B}\cos\psi_{BA}
        v_{A} &= -\frac{v_{B}\cos\psi_{BA}}{\sin\psi_{BA}} = -\frac{2\,\unit{m/s} \cdot \cos
            36.87^\circ}{\sin 36.87^\circ} \approx -2.667\,\unit{m/s}\quad\text{(downwards)}
        The velocity of $A$ is that of the base point $B$ plus that of the rotation of $AB$ about
            $B$.
            Here $BA = \sqrt{x_{B}^{2} + y_{A}^{2}} = \sqrt{(4\,\unit{m})^{2} +
            (3\,\unit{m})^{2}} = 5\,\unit{m}$.
        [ ] \boldsymbol{v}_{A} | ? | $+y$
        [=] \boldsymbol{v}_{B} | $2\,\unit{m/s}$ | $+x$
        [+] \boldsymbol{v}_{AB} | ? $(BA \cdot \omega_{AB})$ | $\perp BA,\curvearrowleft$
        In a polygon a small letter marks the tip of the vector of the point
            with that letter, laid off from $o$.
        $BA$ makes $\psi_{BA}$ with the $x$ axis, so $\boldsymbol{v}_{AB} \perp BA$ makes
            $90^\circ - \psi_{BA}$ with the $x$ axis.
            Projecting on the normal to $\boldsymbol{v}_{A}$ (to the left) eliminates
            $\boldsymbol{v}_{A}$:
        0 &= -v_{B} + v_{AB}\sin\psi_{BA}
        v_{AB} &= \frac{v_{B}}{\sin\psi_{BA}} = \frac{2\,\unit{m/s}}{\sin 36.87^\circ} \approx
            3.333\,\unit{m/s}
        """
    )


def test_velocities_by_the_instantaneous_centre() -> None:
    solution = solve_small(LADDER, v_A="y(velocity(A)) in m/s", omega="omega(AB) in rad/s")
    assert read_chapter("## $AB$: velocity pole", solution, "pole") == as_read(
        r"""
        The normals to the velocities of $B$ and $A$ meet in the velocity pole $P$ of $AB$.
        $BA$ makes the acute angle $\psi_{BA}$ with the $x$ axis:
        \tan\psi_{BA} &= \frac{y_{A}}{x_{B}} = \frac{3\,\unit{m}}{4\,\unit{m}} = 0.75
        \psi_{BA} &\approx 36.87^\circ
        BA &= \sqrt{x_{B}^{2} + y_{A}^{2}} = \sqrt{(4\,\unit{m})^{2} + (3\,\unit{m})^{2}} =
            5\,\unit{m}
        By the law of sines in the triangle $PBA$, whose angles are $90^\circ - \psi_{BA}$ at $B$,
            $\psi_{BA}$ at $A$ and $90^\circ$ at $P$:
        PB &= BA\sin\psi_{BA} = 5\,\unit{m} \cdot \sin 36.87^\circ = 3\,\unit{m}
        PA &= BA\cos\psi_{BA} = 5\,\unit{m} \cdot \cos 36.87^\circ = 4\,\unit{m}
        \omega &= \frac{v_{B}}{PB} = \frac{2\,\unit{m/s}}{3\,\unit{m}} = \frac{2}{3}\,\unit{rad/s}
            \approx 0.6667\,\unit{rad/s}\quad\text{(counter-clockwise)}
        \left|v_{A}\right| &= PA \cdot \omega = 4\,\unit{m} \cdot 0.6667\,\unit{rad/s}
            \approx 2.667\,\unit{m/s}\quad\text{(downwards)}
        v_{A} &= -\left|v_{A}\right| = -\frac{8}{3}\,\unit{m/s} \approx -2.667\,\unit{m/s}
        """
    )


def test_a_pole_has_its_distances_from_a_triangle_and_its_coordinates_where_asked() -> None:
    lengths = {"b": "0.8", "l_BC": "1.3", "l_CD": "2.1", "d": "1.9"}
    coupler = displayed(stated("pole-four-bar-coupler", **lengths))
    crusher = displayed(kept("stone-crusher"))
    starts = (
        r"SB &= \frac{l_{BC}\sin(\psi_{BC} + \psi_{DC})}{\cos\psi_{DC}} = ",
        r"x_{S} &= x_{B} = 0",
        r"y_{S} &= y_{B} + SB = 0.8\,\unit{m} + 2.3904\,\unit{m} ",
    )
    assert [start for start in starts if not any(line.startswith(start) for line in coupler)] == []
    # the law of sines in the triangle BGC_2, by the angles of the statement
    sines = r"C_{2}G &= \frac{BG\sin\gamma}{\sin(\beta + \gamma)} = "
    assert any(line.startswith(sines) for line in crusher), crusher


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
    assert read_chapter("## $AB$: base point $B$", solution) == as_read(
        r"""
        The velocity of $A$ is that of the base point $B$ plus that of the rotation of $AB$ about
            $B$.
            Here $BA = \sqrt{x_{B}^{2} + y_{A}^{2}} = \sqrt{(4\,\unit{m})^{2} +
            (3\,\unit{m})^{2}} = 5\,\unit{m}$.
        [ ] \boldsymbol{v}_{A} | ? | $+y$
        [=] \boldsymbol{v}_{AB} | ? $(BA \cdot \omega)$ | $\perp BA,\curvearrowleft$
        Here $v_{B} = 0$.
        $BA$ makes the acute angle $\psi_{BA}$ with the $x$ axis:
        \tan\psi_{BA} &= \frac{y_{A}}{x_{B}} = \frac{3\,\unit{m}}{4\,\unit{m}} = 0.75
        \psi_{BA} &\approx 36.87^\circ
        Projecting on the direction from $B$ to $A$, which is perpendicular to
            $\boldsymbol{v}_{AB}$, eliminates $\boldsymbol{v}_{AB}$:
        v_{A}\sin\psi_{BA} &= 0
        v_{A} &= 0
        $BA$ makes $\psi_{BA}$ with the $x$ axis, so $\boldsymbol{v}_{AB} \perp BA$ makes
            $90^\circ - \psi_{BA}$ with the $x$ axis.
            Projecting on the normal to $\boldsymbol{v}_{A}$ (to the left) eliminates
            $\boldsymbol{v}_{A}$:
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
        Rotations are positive counter-clockwise.
        Given: the angular velocity of $OA$.
        \omega_{OA} &= 2\,\unit{rad/s}\quad\text{(counter-clockwise)}
        ## $AB$: velocity pole
        The normals to the velocities of $A$ and $B$ are parallel: the pole of $AB$ is at infinity,
            the body is in instantaneous translation and all its points have the same velocity.
        v_{A} &= OA \cdot \omega_{OA} = 6\,\unit{m/s}\quad\text{(to the left)}
        \omega &= 0
        \left|v_{B}\right| &= v_{A} = 6\,\unit{m/s}\quad\text{(to the left)}
        v_{B} &= -\left|v_{B}\right| = -6\,\unit{m/s}
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
        ## $AB$: base point $A$
        The acceleration of $B$ is that of the base point $A$ plus the normal (n) and tangential
            (t) accelerations of the rotation of $AB$ about $A$.
            Here $OA = y_{A} = 3\,\unit{m}$, $AB = \sqrt{x_{B}^{2} + y_{A}^{2}} =
            \sqrt{(4\,\unit{m})^{2} + (3\,\unit{m})^{2}} = 5\,\unit{m}$.
        [ ] \boldsymbol{a}_{B} | ? | $+x$
        [=] \boldsymbol{a}_{A}^{\mathrm{n}} | $OA \cdot \omega_{OA}^{2} = 12\,\unit{m/s^2}$ | $A \to
            O$
        [+] \boldsymbol{a}_{BA}^{\mathrm{t}} | ? $(AB \cdot \alpha)$ | $\perp AB,\curvearrowleft$
        In a polygon a small letter marks the tip of the vector of the point
            with that letter, laid off from $o$.
        Here $a_{A}^{\mathrm{t}} = 0$, $a_{BA}^{\mathrm{n}} = 0$.
        $AB$ makes the acute angle $\psi_{AB}$ with the $x$ axis:
        \tan\psi_{AB} &= \frac{y_{A}}{x_{B}} = \frac{3\,\unit{m}}{4\,\unit{m}} = 0.75
        \psi_{AB} &\approx 36.87^\circ
        Projecting on the direction from $A$ to $B$, which is perpendicular to
            $\boldsymbol{a}_{BA}^{\mathrm{t}}$, eliminates $\boldsymbol{a}_{BA}^{\mathrm{t}}$:
        a_{B}\cos\psi_{AB} &= a_{A}^{\mathrm{n}}\sin\psi_{AB}
        a_{B} &= \frac{a_{A}^{\mathrm{n}}\sin\psi_{AB}}{\cos\psi_{AB}} = \frac{12\,\unit{m/s^2}
            \cdot \sin 36.87^\circ}{\cos 36.87^\circ} = 9\,\unit{m/s^2}\quad\text{(to the right)}
        $AB$ makes $\psi_{AB}$ with the $x$ axis, so $\boldsymbol{a}_{BA}^{\mathrm{t}} \perp AB$
            makes $\psi_{AB}$ with the $y$ axis.
            Projecting on the $y$ axis, which is perpendicular to $\boldsymbol{a}_{B}$, eliminates
            $\boldsymbol{a}_{B}$:
        0 &= -a_{A}^{\mathrm{n}} + a_{BA}^{\mathrm{t}}\cos\psi_{AB}
        a_{BA}^{\mathrm{t}} &= \frac{a_{A}^{\mathrm{n}}}{\cos\psi_{AB}} =
            \frac{12\,\unit{m/s^2}}{\cos 36.87^\circ} = 15\,\unit{m/s^2}
        \alpha &= \frac{a_{BA}^{\mathrm{t}}}{AB} = \frac{15\,\unit{m/s^2}}{5\,\unit{m}} =
            3\,\unit{rad/s^2}\quad\text{(counter-clockwise)}
        """
    )
