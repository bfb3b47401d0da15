"""Chapters of small solutions as a reader sees them: rates that are given, equal, or in mesh."""

from __future__ import annotations

from tests.worked.chapters import as_read, find_untold, read_chapter, solve_small

PLANETS = """
joints = [
  "pin O: ground arm",
  "pin A: arm planet",
  "pin O: ground sun",
  "circle(A, 1) of planet meshes with circle(O, 2) of sun on arm",
]
inputs = [
  { motion = "arm turns", velocity = "2" },
  { motion = "sun turns", velocity = "-3", acceleration = "4" },
]
[points]
O = "(0, 0)"
A = "(3, 0)"
[bodies]
arm = "O A"
planet = "A"
sun = "O"
"""

SLEEVE = """
joints = [
  "pin A: ground crank",
  "pin O: ground sleeve",
  "pin B: crank rod",
  "rod slides through sleeve along line(B, O)",
]
inputs = [{ motion = "crank turns", velocity = "2" }]
[points]
A = "(0, 0)"
O = "(6, 0)"
B = "(3, 4)"
[bodies]
crank = "A B"
rod = "B"
sleeve = "O"
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


def test_meshing_seen_from_the_carrier() -> None:
    # Relative to the arm the sun turns at -5, so the planet of half its radius at +10
    solution = solve_small(PLANETS, omega="omega(planet) in rad/s")
    assert read_chapter("# Velocities", solution) == as_read(
        r"""
        Numbers after $\approx$ are rounded, to 4 significant digits (any angles to 2 decimals);
            where they are put in, they count in full.
        Rotations are positive counter-clockwise. The words in brackets after a value give the actual
            sense.
        Given: $\omega_{OA} = 2\,\unit{rad/s}\quad\text{(counter-clockwise)}$,
            $\omega_{\text{sun}} = -3\,\unit{rad/s}\quad\text{(clockwise)}$.
        ## The planet gear meshes with the sun gear
        Relative to the arm $OA$ the pitch circles have equal speeds at the contact; in an external
            mesh the gears turn in opposite senses:
        1\,\unit{m} \cdot (\omega - \omega_{OA}) &= -2\,\unit{m} \cdot (\omega_{\text{sun}} - \omega_{OA})
        \omega &= \omega_{OA} - \frac{2\,\unit{m}}{1\,\unit{m}} \cdot (\omega_{\text{sun}} - \omega_{OA}) =
            2\,\unit{rad/s} - \frac{2\,\unit{m}}{1\,\unit{m}} \cdot (-3\,\unit{rad/s} -
            2\,\unit{rad/s}) = 12\,\unit{rad/s}\quad\text{(counter-clockwise)}
        """
    )


def test_meshing_of_angular_accelerations() -> None:
    solution = solve_small(PLANETS, alpha="alpha(planet) in rad/s^2")
    assert read_chapter("# Accelerations", solution) == as_read(
        r"""
        Given: $\alpha_{OA} = 0$, $\alpha_{\text{sun}} = 4\,\unit{rad/s^2}\quad\text{(counter-clockwise)}$.
        ## The planet gear meshes with the sun gear
        Relative to the arm $OA$ the pitch circles always have equal speeds at the contact;
            differentiated with respect to time:
        1\,\unit{m} \cdot (\alpha - \alpha_{OA}) &= -2\,\unit{m} \cdot (\alpha_{\text{sun}} - \alpha_{OA})
        \alpha &= \alpha_{OA} - \frac{2\,\unit{m}}{1\,\unit{m}} \cdot (\alpha_{\text{sun}} - \alpha_{OA}) =
            -\frac{2\,\unit{m}}{1\,\unit{m}} \cdot 4\,\unit{rad/s^2} = -8\,\unit{rad/s^2}\quad\text{(clockwise)}
        """
    )


def test_a_ratio_of_rates() -> None:
    solution = solve_small(PLANETS, i="omega(planet)/omega(arm) in 1")
    assert not find_untold(
        r"""
        i &= \frac{\omega_{\text{planet}}}{\omega_{OA}} = \frac{12\,\unit{rad/s}}{2\,\unit{rad/s}} = 6
        """,
        solution,
    )


def test_a_given_relative_rate() -> None:
    # A negative number that is given is not told twice
    solution = solve_small(LINK, omega="omega(link) in rad/s")
    assert read_chapter("# Velocities", solution) == as_read(
        r"""
        Numbers after $\approx$ are rounded, to 4 significant digits (any angles to 2 decimals);
            where they are put in, they count in full.
        Rotations are positive counter-clockwise. The words in brackets after a value give the actual
            sense.
        Given: the angular velocity of the arm $OA$.
        \omega_{OA} &= 2\,\unit{rad/s}\quad\text{(counter-clockwise)}
        ## The given motion
        Given: the angular velocity of link relative to the arm $OA$.
        \omega - \omega_{OA} &= -5\,\unit{rad/s}\quad\text{(clockwise)}
        \omega &= \omega_{OA} - 5\,\unit{rad/s} = 2\,\unit{rad/s} - 5\,\unit{rad/s} = -3\,\unit{rad/s}\quad\text{(clockwise)}
        """
    )


def test_a_rod_that_turns_with_its_sleeve() -> None:
    # The sleeve's rate, not that of the crank
    solution = solve_small(SLEEVE, omega="omega(rod) in rad/s")
    assert read_chapter("## 2. The rod turns with the sleeve", solution) == as_read(
        r"""
        The rod does not turn relative to the sleeve, so their angular velocities are equal:
        \omega &= \omega_{O} = 0.56\,\unit{rad/s}\quad\text{(counter-clockwise)}
        """
    )


def test_a_relative_rate_and_a_relative_speed_that_are_asked_for() -> None:
    solution = solve_small(
        SLEEVE,
        omega_r="omega(rod, crank) in rad/s",
        v_r="magnitude(relative_velocity(B, rod, sleeve)) in m/s",
    )
    assert not find_untold(
        r"""
        \omega_{r} &= \omega_{\text{rod}} - \omega_{AB} = 0.56\,\unit{rad/s} - 2\,\unit{rad/s} =
            -1.44\,\unit{rad/s}
        v_{r} &= \left|v_{\mathrm{r}}\right| = 9.6\,\unit{m/s}
        """,
        solution,
    )
