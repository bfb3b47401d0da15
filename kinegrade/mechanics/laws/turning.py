"""The turning rates that a law relates, with their factors, and the arms that carry wheels."""

from __future__ import annotations

from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.shapes import Circle
from kinegrade.mechanics.shares import Shares
from kinegrade.numbers.number import Number

Turning = tuple[tuple[Rate, Number], ...]
# The point of a carried centre, the centre about which it runs, and the share of their distance
Arm = tuple[str, str, Number]


def add_up(*factors: tuple[str, Number]) -> Turning:
    """The factors of the bodies' turning rates, added up for each; the ground does not turn."""
    rates: dict[Rate, Number] = {}
    for body, factor in factors:
        if body != GROUND:
            rate = make_turning(body)
            rates[rate] = rates[rate] + factor if rate in rates else factor
    return tuple(rates.items())


def measure_arm(circle: Circle, on: Circle, inside: bool, shares: Shares) -> Arm:
    """The distance of the centres of two circles that touch: the share of r1 in r1 + r2."""
    radius = -circle.radius if inside else circle.radius
    share = (on.radius + shares.arm * radius) / (on.radius + radius)
    return circle.centre, on.centre, share
