"""How far results may be off when every value is written down: by hand calculation."""

from __future__ import annotations

from math import cos, radians, sin

import numpy as np
import pytest

from kinegrade.numbers.noting.noting import Noting
from kinegrade.numbers.noting.pad import Noted, Pad


def pad(figures: int = 3) -> Pad:
    return Pad(figures, 1)


def given(sheet: Pad, *values: float) -> list[Noted]:
    return [sheet.write(np.array([value])) for value in values]


def error(sheet: Pad, result: Noted) -> float:
    return float(sheet.sweep_back((result,)).errors[0, 0])


def test_a_product_is_off_by_half_a_unit_of_its_last_figure() -> None:
    sheet = pad()
    first, second = given(sheet, 1.23, 4.56)
    assert error(sheet, first * second) == pytest.approx(0.005)  # 5.6088 is written 5.61


def test_errors_before_are_carried_on_with_the_derivative() -> None:
    sheet = pad()
    first, second, third = given(sheet, 1.23, 4.56, 7.0)
    # 5.6088 off by 0.005, times 7; 39.26 off by 0.05
    assert error(sheet, first * second * third) == pytest.approx(7 * 0.005 + 0.05)


def test_a_difference_of_two_close_numbers_keeps_their_errors() -> None:
    sheet = pad()
    (one,) = given(sheet, 3.0)
    root = Noting(sheet).sqrt(one)  # 1.73205 off by 0.005
    assert error(sheet, root - 1.7) == pytest.approx(0.005 + 0.00005)  # 0.03205 off by 0.00005


def test_one_error_used_twice_cancels_where_the_value_does() -> None:
    sheet = pad()
    (two,) = given(sheet, 2.0)
    root = Noting(sheet).sqrt(two)
    assert error(sheet, root - root) == 0
    assert error(sheet, root / root) == pytest.approx(0.005)  # the quotient is written down


def test_nothing_is_lost_of_a_value_that_has_no_more_figures() -> None:
    sheet = pad()
    first, second = given(sheet, 1.5, 2.0)
    assert error(sheet, first * second) == 0
    assert error(sheet, first / second) == 0
    assert error(sheet, second * second + first) == 0
    assert error(sheet, given(sheet, 1.234)[0]) == pytest.approx(0.005)


def test_a_value_that_stands_there_already_is_not_written_again() -> None:
    sheet = pad()
    root = Noting(sheet).sqrt(given(sheet, 3.0)[0])
    one, zero = given(sheet, 1.0, 0.0)
    for same in (-root, abs(-root), root * one, root + zero, root * 1, root + 0, root / one):
        assert error(sheet, same) == pytest.approx(0.005)


def test_angles_are_written_in_degrees() -> None:
    sheet = pad()
    arithmetic = Noting(sheet)
    up, right = given(sheet, 3.0, 4.0)
    angle = arithmetic.arctangent(up, right)  # 36.87 degrees are off by 0.05
    assert error(sheet, angle) == pytest.approx(radians(0.05))
    assert error(sheet, arithmetic.sin(angle)) == pytest.approx(0.8 * radians(0.05) + 0.0005)
    exact = sheet.write(np.array([radians(30)]), angle=True)
    assert error(sheet, arithmetic.sin(exact)) == 0
    assert error(sheet, arithmetic.cos(exact)) == pytest.approx(0.0005)
    assert error(sheet, exact + angle) == pytest.approx(radians(0.1))


def test_what_lies_next_below_a_power_of_ten_may_come_out_above_it() -> None:
    sheet = pad()
    first, second = given(sheet, 2.22, 4.5)
    assert error(sheet, first * second) == pytest.approx(0.05)  # 9.99 may have become 10.0


def test_two_equations_are_eliminated_line_by_line() -> None:
    """cos 50 x - sin 20 y = 1, sin 50 x + cos 20 y = 2, its lines written to six figures: the
    errors are a thousandth of those at three figures.
    """

    def solve(figures: int) -> tuple[Pad, list[Noted]]:
        sheet = pad(figures)
        rows = [
            given(sheet, cos(radians(50)), -sin(radians(20))),
            given(sheet, sin(radians(50)), cos(radians(20))),
        ]
        return sheet, Noting(sheet).solve(rows, given(sheet, 1.0, 2.0))

    sheet, (x, y) = solve(3)
    assert cos(radians(50)) * x.value - sin(radians(20)) * y.value == pytest.approx(1)
    assert sin(radians(50)) * x.value + cos(radians(20)) * y.value == pytest.approx(2)
    finer, unknowns = solve(6)
    coarse = sheet.sweep_back((x, y)).errors
    assert np.all((coarse > 0.002) & (coarse < 0.02))
    assert finer.sweep_back(unknowns).errors == pytest.approx(coarse / 1000)


def test_each_instance_has_errors_of_its_own() -> None:
    sheet = Pad(3, 3)
    values = sheet.write(np.array([4.0, 3.0, -1.0]))
    arithmetic = Noting(sheet)
    with arithmetic.context():
        errors = sheet.sweep_back((arithmetic.sqrt(values),)).errors[0]
    assert errors[:2].tolist() == pytest.approx([0, 0.005])
    assert np.isnan(errors[2])
    assert float(values) == 4.0
