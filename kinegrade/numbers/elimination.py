"""Linear equations in any arithmetic with a test for zero: Gauss elimination with surplus rows
allowed.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


class Singular(ArithmeticError):
    """The equations do not determine all unknowns."""


class Contradiction(ArithmeticError):
    """A surplus equation contradicts the others."""


def eliminate(rows: list[list[Any]], right: list[Any], is_zero: Callable[[Any], bool]) -> list[Any]:
    """The unknowns of rows * unknowns = right; more rows than unknowns are allowed if they agree.

    Raises Singular when the columns are dependent, Contradiction when a surplus row does not fit.
    """
    table = [[*row, value] for row, value in zip(rows, right, strict=True)]
    count = len(rows[0])
    for column in range(count):
        pivot = next((i for i in range(column, len(table)) if not is_zero(table[i][column])), None)
        if pivot is None:
            raise Singular
        table[column], table[pivot] = table[pivot], table[column]
        _clear_column(table, column, is_zero)
    if any(not is_zero(row[count]) for row in table[count:]):
        raise Contradiction
    return [table[column][count] for column in range(count)]


def _clear_column(table: list[list[Any]], column: int, is_zero: Callable[[Any], bool]) -> None:
    """Make the pivot row's entry one and all others of the column zero."""
    pivot_row = table[column]
    factor = 1 / pivot_row[column]
    pivot_row[column:] = [entry * factor for entry in pivot_row[column:]]
    for row in table:
        if row is not pivot_row and not is_zero(row[column]):
            multiple = row[column]
            row[column:] = [
                entry - multiple * source
                for entry, source in zip(row[column:], pivot_row[column:], strict=True)
            ]


def _reduce_table(
    table: list[list[Any]], columns: int, is_zero: Callable[[Any], bool]
) -> list[int]:
    """Bring the table to reduced echelon form in its first `columns` columns, in place; gives the
    pivot columns.
    """
    pivots: list[int] = []
    for column in range(columns):
        depth = len(pivots)
        pivot = next((i for i in range(depth, len(table)) if not is_zero(table[i][column])), None)
        if pivot is None:
            continue
        table[depth], table[pivot] = table[pivot], table[depth]
        factor = 1 / table[depth][column]
        table[depth] = [entry * factor for entry in table[depth]]
        for index, row in enumerate(table):
            if index != depth and not is_zero(row[column]):
                multiple = row[column]
                table[index] = [a - multiple * b for a, b in zip(row, table[depth], strict=True)]
        pivots.append(column)
    return pivots


def find_null_vectors(
    rows: list[list[Any]], columns: int, is_zero: Callable[[Any], bool]
) -> list[set[int]]:
    """For each independent solution of rows * x = 0: which components of x are not zero."""
    table = [list(row) for row in rows]
    pivots = _reduce_table(table, columns, is_zero)
    free = [column for column in range(columns) if column not in pivots]
    return [
        {column}
        | {pivot for depth, pivot in enumerate(pivots) if not is_zero(table[depth][column])}
        for column in free
    ]


def is_consistent(rows: list[list[Any]], right: list[Any], is_zero: Callable[[Any], bool]) -> bool:
    """Whether rows * x = right has any solution."""
    table = [[*row, value] for row, value in zip(rows, right, strict=True)]
    depth = len(_reduce_table(table, len(rows[0]) if rows else 0, is_zero))
    return all(is_zero(row[-1]) for row in table[depth:])
