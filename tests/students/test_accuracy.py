"""What is allowed at an instance: the stated tolerance where honest rounding stays within it, a
wider one where the ask may have it, else nothing.
"""

from __future__ import annotations

from fractions import Fraction

import pytest

from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.students.rounding.accuracy import Accuracy, find_plain_figure
from kinegrade.students.rounding.rounding import Rounding
from tests.problem.crank import crank

PER_CENT = Tolerance(Fraction(1, 100))


def solution(h: str = "1") -> Solution:
    """v_x is -2 h."""
    vanishing = crank(('sign = "+x", points', 'sign = "+x", vanishes = true, points'))
    return solve_template(vanishing, {"r": "2", "h": h, "omega": "2"}, ("v_x",))


def allow(
    bound: float,
    *,
    h: str = "1",
    largest: float = 2.0,
    stated: Tolerance = PER_CENT,
    honest: bool = True,
) -> object:
    accuracy = Accuracy({"v_x": stated}, 4, frozenset({"v_x"} if honest else ()))
    return accuracy.allow(solution(h), {"v_x": Rounding(bound, largest)})["v_x"]


@pytest.mark.parametrize("honest", [True, False])
def test_the_stated_tolerance_holds_while_rounding_stays_within_it(honest: bool) -> None:
    assert allow(0.0199, honest=honest) == PER_CENT
    three_figures = Tolerance(figures=3)  # of -2: from -2.005 to -1.995
    assert allow(0.0049, stated=three_figures, honest=honest) == three_figures


def test_what_rounding_may_leave_is_refused_unless_the_ask_is_honest() -> None:
    assert allow(0.0201, honest=False) is None
    assert allow(0.0201) == Tolerance(Fraction(15, 1000))


@pytest.mark.parametrize(
    ("bound", "share"), [(0.03, "1.5"), (0.0301, "2"), (0.07, "4"), (0.13, "8"), (0.2, "10")]
)
def test_a_wider_tolerance_is_a_plain_figure(bound: float, share: str) -> None:
    assert allow(bound) == Tolerance(Fraction(share) / 100)


def test_no_tolerance_is_wider_than_a_tenth_of_the_answer() -> None:
    assert allow(0.201) is None
    assert allow(float("inf")) is None


def test_an_answer_next_to_zero_is_allowed_its_amount_and_no_more() -> None:
    """A hundredth of the largest term that goes into it."""
    assert allow(0.04, h="0", largest=4.0) == Tolerance(Fraction(1, 100), Fraction(4, 100))
    assert allow(0.041, h="0", largest=4.0) is None
    assert allow(0.0, h="0", largest=0.0) == PER_CENT


def test_what_is_stated_holds_next_to_zero_even_where_rounding_leaves_it() -> None:
    """So that a draw that was dealt, and would be refused now, is not marked more strictly."""
    accuracy = Accuracy({"v_x": PER_CENT}, 4, frozenset())
    stated = accuracy.state(solution("0"), {"v_x": Rounding(0.041, 4.0)})
    assert stated == {"v_x": Tolerance(Fraction(1, 100), Fraction(4, 100))}


def test_an_ask_without_a_stated_tolerance_is_honest() -> None:
    assert Accuracy().allow(solution(), {"v_x": Rounding(0.05, 2.0)})["v_x"] == Tolerance(
        Fraction(3, 100)
    )


def test_plain_figures_are_those_that_people_say() -> None:
    assert find_plain_figure(1.0) == 1
    assert find_plain_figure(0.0101) == Fraction(15, 1000)
    assert find_plain_figure(0.00801) == Fraction(1, 100)
