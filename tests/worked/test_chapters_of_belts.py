"""Chapters of small solutions as a reader sees them: pulleys that a belt joins."""

from __future__ import annotations

from tests.worked.chapters import as_read, read_chapter, solve_small

FIXED = """
joints = [
  "pin O: ground pulley1",
  "pin C: ground pulley2",
  "open belt: circle(C, 1) of pulley2, circle(O, 3) of pulley1 on ground",
]
inputs = [{ motion = "pulley1 turns", velocity = "2", acceleration="5" }]
[points]
O = "(0, 0)"
C = "(6, 0)"
[bodies]
pulley1 = "O"
pulley2 = "C"
"""
CARRIED = """
joints = [
  "pin O: ground arm",
  "pin C: arm pulley",
  "crossed belt: circle(C, 1 + 1) of pulley, circle(O, 3) of ground on arm",
]
inputs = [{ motion = "arm turns", velocity = "2" }]
[points]
O = "(0, 0)"
C = "(6, 0)"
[bodies]
arm = "O C"
pulley = "C"
"""
RIDDEN = """
joints = [
  "frame translates",
  "pin O: frame pulley1",
  "pin C: frame pulley2",
  "C of frame slides on line(C, 0)",
  "open belt: circle(C, 1) of pulley2, circle(O, 3) of pulley1 on frame",
]
inputs = [
  { motion = "pulley1 turns", velocity = "2" },
  { motion = "C of frame moves along +x", velocity = "1" },
]
[points]
O = "(0, 0)"
C = "(6, 0)"
[bodies]
frame = "O C"
pulley1 = "O"
pulley2 = "C"
"""


def test_a_frame_that_translates_gives_no_rotation_to_its_pulleys() -> None:
    chapter = read_chapter("# Velocities", solve_small(RIDDEN, omega="omega(pulley2) in rad/s"))
    assert r"= \frac{3\,\unit{m}}{1\,\unit{m}} \cdot \omega_{\text{pulley 1}}" in " ".join(
        chapter.split()
    )
    assert r"\omega_{OC}" not in chapter


def test_an_open_belt_between_fixed_pulleys() -> None:
    solution = solve_small(FIXED, alpha="alpha(pulley2) in rad/s^2")
    title = "## A belt joins pulley 2 and pulley 1"
    chapter = read_chapter("# Velocities", solution)
    assert chapter.partition(f"{title}\n")[2] == as_read(
        r"""
        The belt is open, so both pulley rims always move with its speed
            in the same sense:
        1\,\unit{m} \cdot \omega &= 3\,\unit{m} \cdot \omega_{O}
        \omega &= \frac{3\,\unit{m}}{1\,\unit{m}} \cdot \omega_{O} =
            \frac{3\,\unit{m}}{1\,\unit{m}} \cdot 2\,\unit{rad/s} = 6\,\unit{rad/s}\quad\text{(counter-clockwise)}
        """
    )
    assert read_chapter("# Accelerations", solution).partition(f"{title}\n")[2] == as_read(
        r"""
        Both pulley rims always have the speed of the open belt; differentiated
            with respect to time:
        1\,\unit{m} \cdot \alpha &= 3\,\unit{m} \cdot \alpha_{O}
        \alpha &= \frac{3\,\unit{m}}{1\,\unit{m}} \cdot \alpha_{O} = \frac{3\,\unit{m}}{1\,\unit{m}} \cdot
            5\,\unit{rad/s^2} = 15\,\unit{rad/s^2}\quad\text{(counter-clockwise)}
        """
    )


def test_a_crossed_belt_about_a_fixed_pulley() -> None:
    # omega - 2 = -3/2 (0 - 2)
    solution = solve_small(CARRIED, omega="omega(pulley) in rad/s")
    assert read_chapter("## A belt joins the pulley and the ground", solution) == as_read(
        r"""
        The belt is crossed, so relative to the arm $OC$ both pulley rims always move with its
            speed in opposite senses:
        (1 + 1)\,(\omega - \omega_{OC}) &= -3\,\unit{m} \cdot (0 - \omega_{OC})
        \omega &= \omega_{OC} + \frac{3\,\unit{m}}{1 + 1} \cdot \omega_{OC} = 2\,\unit{rad/s} +
            \frac{3\,\unit{m}}{2\,\unit{m}} \cdot 2\,\unit{rad/s} = 5\,\unit{rad/s}\quad\text{(counter-clockwise)}
        """
    )
