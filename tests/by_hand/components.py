"""Vectors by their components, as students write them."""

from __future__ import annotations

from math import sqrt

from tests.by_hand.pad import Pad


def magnitude(x: float, y: float, p: Pad) -> float:
    """The magnitude of a vector: two squares, their sum and its root, all of them written down.

    >>> magnitude(2.0, 3.0, Pad(2))
    3.6
    """
    return p(sqrt(p(p(x**2) + p(y**2))))
