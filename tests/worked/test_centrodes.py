"""Why a fixed centrode is a circle: proved by Thales' theorem where the mechanism allows it."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.worked.document import Block
from kinegrade.worked.solution import write_worked_solution
from tests.worked.chapters import FRAME, find_untold
from tests.worked.telling import displayed, proses

SHOWN = "without a proof for all positions"

GEAR = """
joints = [
  "pin O: ground arm",
  "pin A: arm gear",
  "circle(A, l) of gear rolls on circle(O, 2*l)",
]
inputs = [{ motion = "arm turns", velocity = "1" }]
[parameters]
l = { unit = "m", draw = [1], means = { en = "length", zh = "长" } }
theta = { unit = "deg", draw = [30], means = { en = "angle", zh = "角" } }
[points]
O = "(0, 0)"
A = "polar(O, 3*l, theta)"
[bodies]
arm = "O A"
gear = "A"
[asks]
rho = { quantity = "radius(circle_of_poles(gear, theta))", unit = "m", sign = "magnitude", \
means = { en = "radius", zh = "半径" } }
"""


def tell_radius(name: str, **given: str) -> tuple[Block, ...]:
    """How the radius of the centrode of a shipped template is found."""
    solution = solve_template(load_template(name), given, ["rho"])
    return write_worked_solution(solution, ["rho"], "en").blocks


@pytest.mark.parametrize(
    ("name", "given", "sentence", "radius"),
    [
        (  # AB subtends the angle of the guides: OS = l / sin(gamma)
            "rod-ground-incline-fixed-centrode",
            {"l": "2", "gamma": "120"},
            "At $A$ and $B$ the normals make right angles with the guides",
            r"\rho &= \frac{l}{\sin\gamma} = \frac{2\,\unit{m}}{\sin 120^\circ}",
        ),
        (  # O sees BS under a right angle, and AO = AB: AS = AB
            "guide-tube-rod-fixed-centrode",
            {"r": "0.5", "theta": "-118"},  # an angle of which the size alone is given
            "By Thales $O$ lies on the circle with the diameter $BS$. Its centre is $A$",
            r"\rho &= r = 0.5\,\unit{m}",
        ),
    ],
)
def test_a_centrode_is_proved_by_thales(
    name: str, given: dict[str, str], sentence: str, radius: str
) -> None:
    blocks = tell_radius(name, **given)
    assert sentence in "\n".join(proses(blocks))
    assert [text for text in proses(blocks) if SHOWN in text] == []
    boxed = [line for line in displayed(blocks) if line.startswith(r"\rho &=")]
    assert len(boxed) == 1
    assert boxed[0].startswith(radius)


def test_where_no_proof_applies_the_solution_says_what_it_shows() -> None:
    solution = solve_template(read_template("gear", FRAME + GEAR, kept=True), {})
    blocks = write_worked_solution(solution, ["rho"], "en").blocks
    assert SHOWN in "\n".join(proses(blocks))
    told = displayed(blocks)
    assert any(line.startswith(r"\rho &= 2\,\unit{m}") for line in told), told


def test_a_centrode_found_by_normals_needs_no_speeds() -> None:
    """The statement gives none, and the circle does not depend on them."""
    solution = solve_template(load_template("rod-ground-incline-fixed-centrode"), {})
    blocks = write_worked_solution(solution, ["x_S", "y_S", "rho"], "en").blocks
    assert [text for text in proses(blocks) if "Known:" in text or "Given:" in text] == []
    assert [line for line in displayed(blocks) if "v_{" in line or "omega" in line] == []


def test_a_component_of_the_vector_to_a_pole_is_worked_out_by_coordinates() -> None:
    """It printed the expression of the template, along(AS, midpoint(O, B) - A)."""
    solution = solve_template(load_template("guide-tube-rod-fixed-centrode"), {})
    expected = (
        r"\xi_{S} &= x_{S}\cos\frac{\theta}{2} + y_{S}\sin\frac{\theta}{2} = -0.05\,\unit{m} \cdot"
    )
    assert find_untold(expected, solution) == []


def test_a_bisector_has_half_the_angle_of_which_the_size_alone_is_given() -> None:
    solution = solve_template(load_template("guide-tube-rod-fixed-centrode"), {"theta": "-118"})
    half = r"\frac{\theta}{2}"  # below the x axis
    expected = rf"\eta_{{S}} &= x_{{S}}\sin{half} + y_{{S}}\cos{half} ="
    assert find_untold(expected, solution) == []
