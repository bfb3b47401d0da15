"""Bodies that translate: by a joint of their own, or by all joints together."""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.case import Case
from tests.worked.chapters import solve_small
from tests.worked.draws import kept
from tests.worked.telling import displayed, lines, proses

# Both cranks have the length 2 and are parallel: BD translates on circles
PARALLELOGRAM = """
joints = ["pin A: ground AB", "pin C: ground CD", "pin B: AB BD", "pin D: CD BD"]
inputs = [{ motion = "AB turns", velocity = "omega" }]
[points]
A = "(0, 0)"
B = "(0, 2)"
C = "(3, 0)"
D = "(3, 2)"
[bodies]
AB = "A B"
CD = "C D"
BD = "B D"
"""


@pytest.mark.parametrize(
    ("name", "body"), [("scissor-lift", "the platform"), ("parallelogram-with-sliding-rod", "$BD$")]
)
def test_a_body_that_all_joints_together_keep_from_turning_translates(name: str, body: str) -> None:
    for place in (0, 1):
        assert f"{body}: translation" in "\n".join(proses(kept(name, place)))


def test_a_body_that_does_not_turn_by_the_numbers_alone_is_in_plane_motion() -> None:
    """ABC of the bent coupler begins to turn."""
    template = load_template("bent-coupler-instant-translation")
    case = Case(solve_template(template, {}), "en")
    assert not float(case.motion.omega("ABC"))
    assert case.translating == frozenset()


def test_a_body_at_rest_for_the_moment_is_not_taken_to_translate() -> None:
    """Nothing moves with omega = 0, but with any other number the cranks turn."""
    moving = solve_small(PARALLELOGRAM, omega_CD="omega(CD) in rad/s")
    still = solve_template(moving.template, {"omega": "0"})
    assert [Case(one, "en").translating for one in (moving, still)] == [{"BD"}, {"BD"}]


def test_the_rotation_of_a_body_that_translates_is_no_unknown() -> None:
    told = tuple(lines(kept("parallelogram-with-sliding-rod", 1)))
    assert not [one for one in told if "BD \\cdot \\omega_{BD}" in one]
    assert "$BD$ translates: all its points have the same velocity." in told
    assert "$BD$ translates: all its points have the same acceleration." in told
    assert r"\omega_{BD} &= 0" in displayed(kept("parallelogram-with-sliding-rod", 1))


def test_a_body_whose_driver_stands_still_is_not_taken_to_translate() -> None:
    still = solve_small(PARALLELOGRAM.replace('"omega"', '"0"'), omega_CD="omega(CD) in rad/s")
    assert Case(still, "en").translating == {"BD"}
