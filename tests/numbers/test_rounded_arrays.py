"""Working by hand for many at once gives each what it gets alone, to the last bit; who differs from
most is told.
"""

from __future__ import annotations

import random
from math import pi

import numpy as np
import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.rounded_arrays import RoundedArrays
from kinegrade.numbers.rounding import Rounded, Sparing

NUMBERS = st.lists(st.floats(-1e25, 1e25), min_size=1, max_size=30)
FIGURES = st.integers(1, 10)


def same(found: object, expected: list[float]) -> bool:
    """Whether all are equal, down to the last bit."""
    return [float(number).hex() for number in np.asarray(found).tolist()] == [
        number.hex() for number in expected
    ]


@given(NUMBERS, FIGURES)
def test_numbers_are_written_as_alone(numbers: list[float], figures: int) -> None:
    array = np.array(numbers)
    together, alone = RoundedArrays(figures, len(array)), Rounded(figures)
    with together.context():
        found = together.written(array)
    assert same(found + 0.0, [alone.written(number) + 0.0 for number in numbers])


def test_a_number_that_all_have_in_common_stays_a_number_through_a_choice() -> None:
    together = RoundedArrays(3, 2)
    for number in (0.2345, 1.2345, 0.5):
        found = together.noted(together.choose(True, number, 0.0))  # a tie in three figures
        assert found == Rounded(3).written(number)
        assert together.written(together.sign(found) * number) == found


def test_ties_and_powers_of_ten_are_written_as_alone() -> None:
    ties = [
        sign * (number + 0.5) * 10.0**power
        for number in range(100, 1000, 7)
        for power in range(-14, 15)
        for sign in (1, -1)
    ]
    tens = [
        float(np.nextafter(10.0**power, side))
        for power in range(-11, 20)
        for side in (0.0, 10.0**power, 1e30)
    ]
    tens += [99.95, 999.5, 9.995, 0.9995, 1e-12, 9.9999e-13]
    array = np.array(ties + tens)
    for figures in (3, 4, 10):
        alone = list(map(Rounded(figures).written, array.tolist()))
        assert same(RoundedArrays(figures, len(array)).written(array), alone)


@pytest.mark.parametrize("sparing", [True, False])
def test_sines_roots_and_angles_are_those_of_single_doubles(sparing: bool) -> None:
    source = random.Random(7)
    array = np.array([source.uniform(-7, 7) for _ in range(2000)] + [0.0, pi, pi / 2, pi / 6])
    other = array[::-1].copy()
    alone, together = (
        Sparing(3) if sparing else Rounded(3),
        RoundedArrays(3, len(array), sparing=sparing),
    )
    singles = list(zip(array.tolist(), other.tolist(), strict=True))
    assert same(together.cos(array), [alone.cos(angle) for angle, _ in singles])
    assert same(together.sin(array), [alone.sin(angle) for angle, _ in singles])
    assert same(together.arctangent(array, other), [alone.arctangent(y, x) for y, x in singles])
    assert same(
        together.sqrt(array * array), [alone.sqrt(number * number) for number, _ in singles]
    )


def test_lengths_along_an_axis_settle_everybody() -> None:
    x, y = np.array([0.0, -1.23456, 1e-13, 3.0, 0.0]), np.array([2.34567, 0.0, -7.77777, 4.0, 0.0])
    together = RoundedArrays(3, len(x))
    assert same(together.magnitude(x, y), [2.34567, 1.23456, 7.77777, 5.0, 0.0])
    assert same(together.magnitude(x, 0.0), [0.0, 1.23456, 0.0, 3.0, 0.0])
    assert not together.unsettled.any()


@given(st.integers(2, 4), st.integers(0, 1), st.integers(0, 10**6))
def test_equations_are_solved_as_alone(count: int, surplus: int, seed: int) -> None:
    source, size = random.Random(seed), 6
    rows = [
        [
            np.array([source.choice((0.0, 1.0, -1.0, source.uniform(-5, 5))) for _ in range(size)])
            for _ in range(count)
        ]
        for _ in range(count + surplus)
    ]
    right = [np.array([source.uniform(-5, 5) for _ in range(size)]) for _ in rows]
    together = RoundedArrays(3, size)
    found = together.solve(rows, right)
    for place in range(size):
        try:
            alone = Rounded(3).solve(
                [[float(entry[place]) for entry in row] for row in rows],
                [float(side[place]) for side in right],
            )
        except Singular:
            assert together.unsettled[place]
            continue
        assert same(np.array([unknown[place] for unknown in found]), alone)


def test_too_few_equations_are_refused() -> None:
    with pytest.raises(Singular):
        RoundedArrays(3, 2).solve([[1.0, 2.0]], [3.0])


def test_what_most_are_decides_and_the_others_are_unsettled() -> None:
    arithmetic = RoundedArrays(3, 3)
    assert not arithmetic.is_zero(np.array([1.0, 0.0, 2.0]))
    assert arithmetic.unsettled.tolist() == [False, True, False]
    assert arithmetic.is_zero(np.array([0.0, 5.0, 1e-13]))
    assert arithmetic.unsettled.tolist() == [False, True, False]


def test_roots_below_zero_are_unsettled() -> None:
    arithmetic = RoundedArrays(3, 3)
    assert arithmetic.sqrt(np.array([3.0, -2.0, -1e-13])).tolist() == [1.73, 1.0, 0.0]
    assert arithmetic.unsettled.tolist() == [False, True, False]


def test_what_is_the_same_in_all_is_a_single_double() -> None:
    arithmetic = RoundedArrays(3, 2)
    assert (arithmetic.written(1.2345), arithmetic.cos(pi / 6), arithmetic.sqrt(12.0)) == (
        1.23,
        0.866,
        3.46,
    )
    assert (
        arithmetic.number(fmpq(1, 8)),
        arithmetic.is_zero(1e-13),
        RoundedArrays(3, 2, sparing=True).sqrt(3.0),
    ) == (0.125, True, 3**0.5)


def test_a_division_by_zero_is_refused() -> None:
    with pytest.raises(FloatingPointError), RoundedArrays(3, 1).context():
        np.array([1.0]) / np.array([0.0])
