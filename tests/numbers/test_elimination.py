"""Linear equations: surplus rows, dependent columns, contradictions, what stays free."""

from __future__ import annotations

from typing import Any

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from kinegrade.numbers.elimination import (
    Contradiction,
    Singular,
    eliminate,
    find_null_vectors,
    is_consistent,
)
from kinegrade.numbers.field import Field
from kinegrade.numbers.floats import Floats
from tests.numbers.numbers import rationals

Q = fmpq


def zero(number: Any) -> bool:
    return bool(number == 0)


def rows(*table: tuple[int, ...]) -> list[list[Any]]:
    return [[Q(entry) for entry in row] for row in table]


def test_two_equations_by_hand() -> None:
    # x + 2y = 5, 3x + 4y = 11: subtract three times the first: -2y = -4
    assert eliminate(rows((1, 2), (3, 4)), [Q(5), Q(11)], zero) == [1, 2]


def test_rows_are_exchanged_where_the_pivot_is_zero() -> None:
    assert eliminate(rows((0, 1), (1, 0)), [Q(3), Q(4)], zero) == [4, 3]


def test_a_surplus_row_that_agrees_is_welcome_and_one_that_does_not_is_told() -> None:
    assert eliminate(rows((1, 0), (0, 1), (1, 1)), [Q(1), Q(2), Q(3)], zero) == [1, 2]
    with pytest.raises(Contradiction):
        eliminate(rows((1, 0), (0, 1), (1, 1)), [Q(1), Q(2), Q(4)], zero)


def test_dependent_columns_are_told() -> None:
    with pytest.raises(Singular):
        eliminate(rows((1, 2), (2, 4)), [Q(1), Q(2)], zero)


def test_what_stays_free_is_told_by_its_components() -> None:
    # x + y = 0 leaves z free, and x against y
    assert find_null_vectors(rows((1, 1, 0)), 3, zero) == [{0, 1}, {2}]
    assert find_null_vectors(rows((1, 0), (0, 1)), 2, zero) == []


def test_whether_equations_have_a_solution_at_all() -> None:
    assert is_consistent(rows((1, 1), (2, 2)), [Q(1), Q(2)], zero)
    assert not is_consistent(rows((1, 1), (2, 2)), [Q(1), Q(3)], zero)
    assert is_consistent([], [], zero)


@given(st.lists(rationals, min_size=9, max_size=9), st.lists(rationals, min_size=3, max_size=3))
def test_the_solution_solves_and_doubles_agree(entries: list[Any], unknowns: list[Any]) -> None:
    field = Field()
    two = field.sqrt(Q(2))
    matrix = [[entries[3 * i + j] + two * (i == j) for j in range(3)] for i in range(3)]
    matrix.append([sum(column, Q(0)) for column in zip(*matrix, strict=True)])
    right = [sum((a * x for a, x in zip(row, unknowns, strict=True)), Q(0)) for row in matrix]
    # A rational matrix plus root 2 on the diagonal is never singular
    assert field.solve(matrix, right) == unknowns
    fast = Floats().solve(
        [[float(a) if a != 0 else 0.0 for a in map(as_float, row)] for row in matrix],
        list(map(as_float, right)),
    )
    assert [
        (a, b)
        for a, b in zip(fast, unknowns, strict=True)
        if not abs(a - as_float(b)) < 1e-6 * (1 + abs(as_float(b)))
    ] == []


def as_float(number: Any) -> float:
    return Floats().number(number)
