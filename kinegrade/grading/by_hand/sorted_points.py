"""Points by hand whose column was sorted alone, so that they stand beside other students.

Who sorts whole rows by their points moves the students with them; points in order beside students
in the order of the roster tell that only their column was sorted, or that all stand so by chance.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from math import factorial, prod
from typing import Any

from kinegrade.grading.by_hand.hand_file import HandRow
from kinegrade.language.message import Message

_LEAST_ORDERS = 100_000  # in which the same points could stand: two of them are sorted


def describe_sorted(rows: Iterable[HandRow], students: Sequence[str]) -> Iterator[Message]:
    """That the points for something stand in order; the rows are as in the file, the `students` as
    in the roster.
    """
    places = {student: place for place, student in enumerate(students)}
    columns: dict[str, list[HandRow]] = {}
    for row in rows:
        columns.setdefault(row.mark.column, []).append(row)
    for column, own in columns.items():
        points = [row.mark.points for row in own]
        listed = _is_ascending([places[row.mark.student] for row in own])
        if listed and _are_sorted(points) and _count_orders(points) >= _LEAST_ORDERS:
            yield Message("marking.points-sorted", count=len(own), column=column)


def _are_sorted(values: Sequence[Any]) -> bool:
    return _is_ascending(values) or _is_ascending(values[::-1])


def _is_ascending(values: Sequence[Any]) -> bool:
    return all(before <= after for before, after in pairwise(values))


def _count_orders(values: Sequence[Any]) -> int:
    """In how many orders the same values could stand."""
    return factorial(len(values)) // prod(map(factorial, Counter(values).values()))
