"""Round numbers next to any number, exactly."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from kinegrade.round_numbers import round_down, round_up

FINE = tuple(map(Fraction, ("1", "1.5", "2", "3", "4", "5", "6", "8")))
# By hand: every 1, 2 and 5 of a range wider than that of the numbers tried
LADDER = [int(f"{figure}{'0' * zeros}") for zeros in range(12) for figure in (1, 2, 5)]


@given(st.fractions(min_value=1, max_value=10**10))
def test_the_nearest_round_numbers_enclose_a_number(number: Fraction) -> None:
    assert round_down(number) == max(step for step in LADDER if step <= number)
    assert round_up(number) == min(step for step in LADDER if step >= number)


@given(st.fractions(min_value=Fraction(1, 10**6), max_value=10**6), st.integers(-9, 9))
def test_a_power_of_ten_moves_the_point_alone(number: Fraction, power: int) -> None:
    factor = Fraction(10) ** power
    assert round_up(number * factor, FINE) == factor * round_up(number, FINE)
    assert round_down(number * factor, FINE) == factor * round_down(number, FINE)


@given(st.integers(-30, 30))
def test_a_power_of_ten_is_round_though_its_logarithm_in_doubles_may_be_another(power: int) -> None:
    number = Fraction(10) ** power
    tiny = number / 10**25
    assert round_down(number) == round_up(number) == number
    assert (round_down(number - tiny), round_up(number + tiny)) == (number / 2, number * 2)
