"""Fast arithmetic: many instances at once, each as it would be alone."""

from __future__ import annotations

import numpy as np
import pytest
from flint import fmpq

from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.field import Field
from kinegrade.numbers.floats import Floats

FLOATS = Floats()


def test_each_instance_is_solved_on_its_own() -> None:
    factor = np.array([1.0, 2.0, 4.0])
    x, y = FLOATS.solve([[factor, 0], [0, 1.0], [factor, 1.0]], [8.0, 3.0, 11.0])
    assert np.allclose(x, [8, 4, 2])
    assert np.allclose(y, 3)


def test_an_instance_at_a_dead_point_is_not_a_number_and_leaves_the_others_alone() -> None:
    with FLOATS.context():
        (x,) = FLOATS.solve([[np.array([1.0, 0.0, np.nan, 2.0])]], [4.0])
    assert np.allclose(x[[0, 3]], [4, 2])
    assert np.isnan(x[[1, 2]]).all()


def test_equations_that_determine_nothing_in_any_instance_are_refused() -> None:
    with pytest.raises(Singular):
        FLOATS.solve([[np.array([1.0, 1.0]), 2.0], [2.0, 4.0]], [0.0, 0.0])
    with pytest.raises(Singular):
        FLOATS.solve([[1.0, 2.0]], [0.0])


def test_signs_and_roots_forgive_rounding_about_zero() -> None:
    assert FLOATS.sqrt(np.array([4.0, -1e-15])).tolist() == [2.0, 0.0]
    assert FLOATS.sign(np.array([3.0, -3.0, 1e-15])).tolist() == [1.0, -1.0, 0.0]
    with FLOATS.context():
        assert np.isnan(FLOATS.sqrt(np.array([-1.0]))).all()
    assert FLOATS.is_zero(np.array([1e-13, 0.0]))
    assert not FLOATS.is_zero(np.array([1.0, 0.0]))
    assert FLOATS.choose(np.array([True, False]), 1.0, 2.0).tolist() == [1.0, 2.0]


def test_exact_numbers_become_doubles() -> None:
    assert FLOATS.number(fmpq(1, 3)) == 1 / 3
    assert FLOATS.number(Field().sqrt(fmpq(2))) == 2**0.5
    assert FLOATS.turns(fmpq(1, 2)) == np.pi / 2
    assert FLOATS.number(2) == 2
