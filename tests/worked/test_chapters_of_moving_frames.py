"""Chapters of small solutions as a reader sees them: a point that moves in a moving frame."""

from __future__ import annotations

from tests.worked.chapters import as_read, find_untold, read_chapter, solve_small

SLOT = """
joints = ["pin O: ground OB", "pin O1: ground crank", "A of crank slides on line(O, B) of OB"]
inputs = [{ motion = "crank turns", velocity = "2" }]
[points]
O = "(0, 0)"
O1 = "(0, 3)"
A = "(4, 3)"
B = "(8, 6)"
[bodies]
OB = "O B"
crank = "O1 A"
"""

YOKE = """
joints = [
  "block translates",
  "D of block slides on line(O, 0)",
  "pin O: ground crank",
  "C of crank slides on line(C, pi/2) of block",
]
inputs = [{ motion = "crank turns", velocity = "2" }]
[points]
O = "(0, 0)"
D = "(4, 0)"
C = "(3, 4)"
[bodies]
crank = "O C"
block = "D"
"""

LINK = """
joints = ["pin O: ground arm", "pin A: arm link"]
inputs = [
  { motion = "arm turns", velocity = "2" },
  { motion = "link turns relative to arm", velocity = "-5" },
]
[points]
O = "(0, 0)"
A = "(3, 0)"
B = "(3, 1)"
[bodies]
arm = "O A"
link = "A B"
"""


def test_a_composition_of_velocities() -> None:
    # v_a = 8 upwards, the slot rises 3 in 4: v_r = 8 * 3/5, v_e = 8 * 4/5 at 5 m from O
    solution = solve_small(SLOT, omega="omega(OB) in rad/s")
    assert read_chapter("# Velocities", solution) == as_read(
        r"""
        Rotations are positive counter-clockwise. A vector's letter stands for its component in the direction given in its first table ($\perp$ with $\curvearrowleft$: turned through $90^\circ$
            counter-clockwise from what is named).
        Given: the angular velocity of the crank $O_{1}A$.
        \omega_{O_{1}A} &= 2\,\unit{rad/s}\quad\text{(counter-clockwise)}
        ## Composition of motions: moving point $A$, moving frame on $OB$
        $\boldsymbol{v}_{\mathrm{a}} = \boldsymbol{v}_{\mathrm{e}} + \boldsymbol{v}_{\mathrm{r}}$: the
            absolute velocity of $A$ (of the crank $O_{1}A$) is its transport velocity (that of the
            point of $OB$ which is at $A$) plus the relative one (seen from $OB$).
            Here $y_{O_{1}} - y_{A} = 3\,\unit{m} - 3\,\unit{m} = 0$, $O_{1}A = x_{A} = 4\,\unit{m}$, $OA = \sqrt{x_{A}^{2} + y_{A}^{2}} =
            \sqrt{(4\,\unit{m})^{2} + (3\,\unit{m})^{2}} = 5\,\unit{m}$.
        [ ] \boldsymbol{v}_{\mathrm{a}} | $O_{1}A \cdot \omega_{O_{1}A} = 8\,\unit{m/s}$ | $\perp
            O_{1}A,\curvearrowleft$
        [=] \boldsymbol{v}_{\mathrm{e}} | ? $(OA \cdot \omega)$ | $\perp OA,\curvearrowleft$
        [+] \boldsymbol{v}_{\mathrm{r}} | ? | $O \to B$
        In a polygon a small letter marks the tip of the vector of the point
            with that letter, laid off from $o$.
        In the polygon, $a'$ denotes the point fixed to $OB$ that coincides with $A$.
        $OB$ makes the acute angle $\psi_{OB}$ with the $x$ axis:
        \tan\psi_{OB} &= \frac{y_{B}}{x_{B}} = \frac{6\,\unit{m}}{8\,\unit{m}} = 0.75
        \psi_{OB} &\approx 36.87^\circ
        $OB$ makes $\psi_{OB}$ with the $x$ axis, so $\boldsymbol{v}_{\mathrm{a}} \parallel y$
            makes $\psi_{OB}$ with the normal to $OB$.
            Projecting on the normal to $\boldsymbol{v}_{\mathrm{r}}$ (its positive direction
            turned counter-clockwise) eliminates
            $\boldsymbol{v}_{\mathrm{r}}$:
        v_{\mathrm{e}} &= v_{\mathrm{a}}\cos\psi_{OB} = 8\,\unit{m/s} \cdot \cos 36.87^\circ =
            6.4\,\unit{m/s}
        \omega &= \frac{v_{\mathrm{e}}}{OA} = \frac{6.4\,\unit{m/s}}{5\,\unit{m}} =
            1.28\,\unit{rad/s}\quad\text{(counter-clockwise)}
        """
    )


def test_a_composition_of_accelerations_with_coriolis() -> None:
    # a_C = 2 * 1.28 * 4.8; a_e^t = 16 * 3/5 - a_C
    solution = solve_small(SLOT, alpha="alpha(OB) in rad/s^2")
    assert read_chapter("# Accelerations", solution) == as_read(
        r"""
        Given: the angular acceleration of the crank $O_{1}A$.
        \alpha_{O_{1}A} &= 0
        ## Composition of motions: moving point $A$, moving frame on $OB$
        $\boldsymbol{a}_{\mathrm{a}} = \boldsymbol{a}_{\mathrm{e}} + \boldsymbol{a}_{\mathrm{r}} + \boldsymbol{a}_{\mathrm{Cor}}$: $\boldsymbol{a}_{\mathrm{e}}$
            is the acceleration of the point of $OB$ which is at $A$,
            $\boldsymbol{a}_{\mathrm{r}}$ that seen from $OB$,
            $\boldsymbol{a}_{\mathrm{Cor}}$ the Coriolis acceleration. The
            indices n and t mark normal and tangential parts.
        [ ] \boldsymbol{a}_{\mathrm{a}}^{\mathrm{n}} | $O_{1}A \cdot \omega_{O_{1}A}^{2} =
            16\,\unit{m/s^2}$ | $A \to O_{1}$
        [=] \boldsymbol{a}_{\mathrm{e}}^{\mathrm{n}} | $OA \cdot \omega^{2} = 8.192\,\unit{m/s^2}$ |
            $A \to O$
        [+] \boldsymbol{a}_{\mathrm{e}}^{\mathrm{t}} | ? $(OA \cdot \alpha)$ | $\perp OA,\curvearrowleft$
        [+] \boldsymbol{a}_{\mathrm{r}} | ? | $O \to B$
        [+] \boldsymbol{a}_{\mathrm{Cor}} | $2\omega\,v_{\mathrm{r}} = 12.288\,\unit{m/s^2}$ | $\perp
            \boldsymbol{v}_{\mathrm{r}},\curvearrowleft$
        Here $a_{\mathrm{a}}^{\mathrm{t}} = 0$.
        Coriolis acceleration by the right-hand rule:
            $\boldsymbol{a}_{\mathrm{Cor}}=2\,\boldsymbol{\omega}\times\boldsymbol{v}_{\mathrm{r}}$
            has the direction of
            $\boldsymbol{v}_{\mathrm{r}}$ turned through $90^\circ$ counter-clockwise, with
            $\omega$.
        Projecting on the normal to $\boldsymbol{a}_{\mathrm{r}}$ (its positive direction
            turned counter-clockwise) eliminates
            $\boldsymbol{a}_{\mathrm{r}}$:
        a_{\mathrm{a}}^{\mathrm{n}}\sin\psi_{OA} &= a_{\mathrm{e}}^{\mathrm{t}} + a_{\mathrm{Cor}}
        a_{\mathrm{e}}^{\mathrm{t}} &= -a_{\mathrm{Cor}} + a_{\mathrm{a}}^{\mathrm{n}}\sin\psi_{OA}
            = -12.288\,\unit{m/s^2} + 16\,\unit{m/s^2} \cdot \sin 36.870^\circ
        &= -2.688\,\unit{m/s^2}\quad\text{(clockwise about }O\text{)}
        \alpha &= \frac{a_{\mathrm{e}}^{\mathrm{t}}}{OA} = \frac{-2.688\,\unit{m/s^2}}{5\,\unit{m}}
            = -0.5376\,\unit{rad/s^2}\quad\text{(clockwise)}
        """
    )


def test_a_composition_of_velocities_in_a_translating_frame() -> None:
    # v_a = 10 at right angles to OC, whose slope is 4 in 3
    solution = solve_small(YOKE, v_D="x(velocity(D)) in m/s")
    assert read_chapter(
        "## Composition of motions: moving point $C$, moving frame on block", solution
    ) == as_read(
        r"""
        $\boldsymbol{v}_{\mathrm{a}} = \boldsymbol{v}_{\mathrm{e}} + \boldsymbol{v}_{\mathrm{r}}$: the
            absolute velocity of $C$ (of the crank $OC$) is its transport velocity (that of the
            point of block which is at $C$) plus the relative one (seen from block).
            Here $OC = \sqrt{x_{C}^{2} + y_{C}^{2}} = \sqrt{(3\,\unit{m})^{2} +
            (4\,\unit{m})^{2}} = 5\,\unit{m}$.
        Here $\boldsymbol{v}_{\mathrm{e}} = \boldsymbol{v}_{D}$.
        [ ] \boldsymbol{v}_{\mathrm{a}} | $OC \cdot \omega_{OC} = 10\,\unit{m/s}$ | $\perp OC,\curvearrowleft$
        [=] \boldsymbol{v}_{D} | ? | $+x$
        [+] \boldsymbol{v}_{\mathrm{r}} | ? | $+y$
        In a polygon a small letter marks the tip of the vector of the point
            with that letter, laid off from $o$.
        Block translates: all its points have the same velocity.
        In the polygon, $c'$ denotes the point fixed to block that coincides with $C$.
        $OC$ makes the acute angle $\psi_{OC}$ with the $x$ axis:
        \tan\psi_{OC} &= \frac{y_{C}}{x_{C}} = \frac{4\,\unit{m}}{3\,\unit{m}} = \frac{4}{3} \approx
            1.333
        \psi_{OC} &\approx 53.13^\circ
        $OC$ makes $\psi_{OC}$ with the $x$ axis, so $\boldsymbol{v}_{\mathrm{a}} \perp OC$ makes
            $90^\circ - \psi_{OC}$ with the $x$ axis.
            Projecting on the $x$ axis, which is perpendicular to $\boldsymbol{v}_{\mathrm{r}}$,
            eliminates $\boldsymbol{v}_{\mathrm{r}}$:
        v_{D} &= -v_{\mathrm{a}}\sin\psi_{OC} = -10\,\unit{m/s} \cdot \sin 53.13^\circ =
            -8\,\unit{m/s}\quad\text{(to the left)}
        """
    )


def test_a_composition_of_accelerations_without_coriolis() -> None:
    solution = solve_small(YOKE, a_D="x(acceleration(D)) in m/s^2")
    assert read_chapter("# Accelerations", solution) == as_read(
        r"""
        Given: the angular acceleration of the crank $OC$.
        \alpha_{OC} &= 0
        ## Composition of motions: moving point $C$, moving frame on block
        $\boldsymbol{a}_{\mathrm{a}} = \boldsymbol{a}_{\mathrm{e}} + \boldsymbol{a}_{\mathrm{r}} + \boldsymbol{a}_{\mathrm{Cor}}$: $\boldsymbol{a}_{\mathrm{e}}$
            is the acceleration of the point of block which is at $C$,
            $\boldsymbol{a}_{\mathrm{r}}$ that seen from block,
            $\boldsymbol{a}_{\mathrm{Cor}}$ the Coriolis acceleration. The
            indices n and t mark normal and tangential parts.
        Here $\boldsymbol{a}_{\mathrm{e}} = \boldsymbol{a}_{D}$.
        [ ] \boldsymbol{a}_{\mathrm{a}}^{\mathrm{n}} | $OC \cdot \omega_{OC}^{2} = 20\,\unit{m/s^2}$
            | $C \to O$
        [=] \boldsymbol{a}_{D} | ? | $+x$
        [+] \boldsymbol{a}_{\mathrm{r}} | ? | $+y$
        Block translates: all its points have the same acceleration, and there is no Coriolis
            acceleration.
        Here $a_{\mathrm{a}}^{\mathrm{t}} = 0$.
        Projecting on the $x$ axis, which is perpendicular to $\boldsymbol{a}_{\mathrm{r}}$,
            eliminates $\boldsymbol{a}_{\mathrm{r}}$:
        a_{D} &= -a_{\mathrm{a}}^{\mathrm{n}}\cos\psi_{OC} = -20\,\unit{m/s^2} \cdot \cos
            53.13^\circ = -12\,\unit{m/s^2}\quad\text{(to the left)}
        """
    )


def test_a_relative_vector_that_is_asked_for() -> None:
    # B is 1 m from A and turns at -5 relative to the arm
    solution = solve_small(LINK, v_r="magnitude(relative_velocity(B, link, arm)) in m/s")
    assert not find_untold(
        r"""
        $A$ is a point of the arm $OA$, which turns about $O$:
        v_{A} &= OA \cdot \omega_{OA} = 3\,\unit{m} \cdot 2\,\unit{rad/s} =
            6\,\unit{m/s}\quad\text{(upwards)}
        $B$ is a point of link, base point $A$:
        v_{B,x} &= -\omega_{AB}\,y_{B} = -(-3\,\unit{rad/s}) \cdot 1\,\unit{m} = 3\,\unit{m/s}
        v_{B,y} &= v_{A} + \omega_{AB}(x_{B} - x_{A}) = 6\,\unit{m/s}
        The point of the arm $OA$ that coincides with $B$ turns about $O$:
        v_{B(OA)} &= OB \cdot \omega_{OA} = 3.1623\,\unit{m} \cdot 2\,\unit{rad/s} \approx
            6.3246\,\unit{m/s}\quad\text{(counter-clockwise about }O\text{)}
        Relative to the arm $OA$, $B$ has the velocity
            $\boldsymbol{v}_{\mathrm{r}} = \boldsymbol{v}_{B} - \boldsymbol{v}_{B(OA)}$.
        v_{\mathrm{r},x} &= v_{B,x} + \omega_{OA}\,y_{B} = 3\,\unit{m/s} + 2\,\unit{rad/s} \cdot
            1\,\unit{m} = 5\,\unit{m/s}
        v_{\mathrm{r},y} &= v_{B,y} - \omega_{OA}\,x_{B} = 6\,\unit{m/s} - 2\,\unit{rad/s} \cdot
            3\,\unit{m} = 0
        v_{r} &= v_{\mathrm{r},x} = 5\,\unit{m/s}
        """,
        solution,
    )


def test_an_acceleration_about_a_base_point_that_moves_itself() -> None:
    solution = solve_small(LINK, a_B="magnitude(acceleration(B)) in m/s^2")
    assert not find_untold(
        r"""
        As $\alpha_{OA} = 0$, the acceleration of $A$ has only its normal part (n).
            $A$ is a point of the arm $OA$, which turns about $O$:
        a_{A}^{\mathrm{n}} &= OA \cdot \omega_{OA}^{2} = 3\,\unit{m} \cdot (2\,\unit{rad/s})^{2} =
            12\,\unit{m/s^2}\quad\text{(to the left)}
        $B$ is a point of link, base point $A$:
        a_{B,x} &= -a_{A}^{\mathrm{n}} - \omega_{AB}^{2}(x_{B} - x_{A}) = -12\,\unit{m/s^2}
        a_{B,y} &= -\omega_{AB}^{2}\,y_{B} = -(-3\,\unit{rad/s})^{2} \cdot 1\,\unit{m} =
            -9\,\unit{m/s^2}
        a_{B} &= \sqrt{a_{B,x}^{2} + a_{B,y}^{2}} = \sqrt{(-12\,\unit{m/s^2})^{2} +
            (-9\,\unit{m/s^2})^{2}} = 15\,\unit{m/s^2}
        """,
        solution,
    )


def test_the_points_of_a_body_that_translates_move_as_its_base_point() -> None:
    pushed = YOKE.replace("crank turns", "D of block moves along +x")
    solution = solve_small(pushed, omega="omega(crank) in rad/s", alpha="alpha(crank) in rad/s^2")
    told = r"""
        Block translates: all its points have the same velocity.
        v_{\mathrm{e}} &= v_{D} = 2\,\unit{m/s}\quad\text{(to the right)}
        Block translates: all its points have the same acceleration.
        a_{\mathrm{e}} &= a_{D} = 0
        """
    assert find_untold(told, solution) == []
