"""Motions of one structure, in doubles, as a single motion whose numbers are arrays with an entry
for each.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.number import Number


def stack_motions(motions: Sequence[Motion]) -> Motion:
    """The motions, of one template and one plan and in doubles, as one. Joints and drivers are
    those of the first, as relations state all of the numbers.
    """
    numbers = zip(*(_list_numbers(motion) for motion in motions), strict=True)
    stacked = iter([stack_numbers(same) for same in numbers])
    return motions[0].map(lambda number: next(stacked))


def _list_numbers(motion: Motion) -> list[Number]:
    """The numbers of a motion, in the order in which it is mapped."""
    found: list[Number] = []

    def note(number: Number) -> Number:
        found.append(number)
        return number

    motion.map(note)
    return found


def stack_vectors(vectors: Sequence[Vector]) -> Vector:
    """Vectors as one."""
    return Vector(*(stack_numbers(components) for components in zip(*vectors, strict=True)))


def stack_numbers(numbers: Sequence[Number]) -> float | NDArray[np.float64]:
    """Doubles as an array; numbers that are equal in all, down to the sign of a zero, as one
    double.
    """
    array = np.array(numbers)
    first = array[0]
    if (array == first).all() and (np.signbit(array) == np.signbit(first)).all():
        return float(first)
    return array
