"""How the points of a question are shared out among what it asks."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction


def share_points(total: int, weights: Mapping[str, int]) -> dict[str, int]:
    """`total` in whole points, in proportion to positive weights, by largest remainder; at least
    one point for each.

    Of equal claims, the first listed takes precedence. `total` is at least the number of weights.

    >>> share_points(10, {"v_B": 3, "omega_AB": 2, "a_B": 4})
    {'v_B': 3, 'omega_AB': 2, 'a_B': 5}
    """
    whole = sum(weights.values())
    points = dict.fromkeys(weights, 1)
    for _ in range(total - len(weights)):
        claims = {name: Fraction(total * weights[name], whole) - points[name] for name in weights}
        points[max(claims, key=claims.__getitem__)] += 1
    return points
