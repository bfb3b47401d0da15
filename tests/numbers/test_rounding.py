"""Working by hand: what is written down has so many significant figures, what stays in the
calculator has all.
"""

from __future__ import annotations

from math import cos, degrees, pi, radians

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.field import Field
from kinegrade.numbers.rounding import Rounded, Sparing

THREE = Rounded(3)
NUMBERS = st.floats(1e-6, 1e6) | st.floats(-1e6, -1e-6)


@given(NUMBERS, st.integers(2, 8))
def test_a_written_number_has_so_many_figures_and_is_the_nearest_of_those(
    number: float, figures: int
) -> None:
    written = Rounded(figures).written(number)
    assert written == float(f"{number:.{figures - 1}e}")
    assert Rounded(figures).written(written) == written


def test_what_rounding_of_doubles_leaves_of_zero_is_zero() -> None:
    assert THREE.cos(pi / 2) == 0.0
    assert THREE.written(-3e-17) == 0.0
    assert THREE.sqrt(-1e-17) == 0.0
    assert [THREE.sign(number) for number in (-1e-15, 2.0, -2.0)] == [0, 1, -1]


def test_sines_roots_and_angles_are_written_down() -> None:
    assert (THREE.cos(pi / 6), THREE.sin(radians(40)), THREE.sqrt(12.0)) == (0.866, 0.643, 3.46)
    assert degrees(THREE.arctangent(1.0, 2.0)) == pytest.approx(26.6, abs=1e-12)


def test_givens_are_used_as_they_are_given() -> None:
    assert THREE.number(fmpq(12345, 10000)) == 1.2345
    assert THREE.number(Field().sqrt(fmpq(2))) == 2**0.5
    assert THREE.turns(fmpq(1, 7)) == pi / 7
    assert THREE.embed(1.2345) == THREE.fork().number(1.2345) == 1.2345


def test_the_root_of_a_negative_number_is_refused() -> None:
    with pytest.raises(ValueError, match="math domain error|expected a nonnegative input"):
        THREE.sqrt(-1.0)


def test_every_unknown_that_is_solved_for_is_written_down() -> None:
    assert THREE.solve([[3.0]], [2.0]) == [0.667]
    assert THREE.solve([[0.0, 2.0], [7.0, 1.0]], [1.0, 1.0]) == [
        0.0714,
        0.5,
    ]  # 1/14, with 1/2 as the calculator has it


def test_surplus_equations_are_left_alone_although_rounding_makes_them_disagree() -> None:
    # The one with most weight is used
    assert THREE.solve([[1.0], [2.0], [1.0]], [0.333, 0.667, 0.334]) == [0.334]
    THREE.require_zero(0.001)


@pytest.mark.parametrize("rows", [[[1.0, 2.0], [2.0, 4.0]], [[1.0, 2.0]], [[0.0, 1.0], [0.0, 2.0]]])
def test_dependent_equations_are_refused(rows: list[list[float]]) -> None:
    with pytest.raises(Singular):
        THREE.solve(rows, [1.0] * len(rows))


def test_who_writes_sparingly_writes_down_the_unknowns_alone() -> None:
    sparing = Sparing(3)
    assert (sparing.sqrt(2.0), sparing.cos(1.0)) == (2**0.5, cos(1.0))
    assert sparing.cos(pi / 2) == 0.0
    assert sparing.solve([[3.0]], [2.0]) == [0.667]


def test_branches_are_chosen_as_in_every_arithmetic() -> None:
    assert THREE.choose(True, 1.0, 2.0) == 1.0
    with THREE.context():
        assert THREE.choose(False, 1.0, 2.0) == 2.0
    assert not THREE.exact
    assert not THREE.certified
