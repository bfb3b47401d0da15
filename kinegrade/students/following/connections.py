"""Which asks of a template depend on which, and the order in which the plan comes to them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from math import modf

from kinegrade.errors import KinegradeError
from kinegrade.mechanics.plan import Plan
from kinegrade.problem.template.template import Template
from kinegrade.students.following.follow_through import SAME, Follower
from kinegrade.students.following.followed_quantities import (
    find_calls,
    find_level,
    find_share,
)
from kinegrade.students.mistakes import convert_parameter

_INSTANCES = 8  # looked at to see which asks are connected
_GOLDEN, _ROOT = 0.6180339887, 0.4142135624  # steps along choices that never meet again


def find_connections(template: Template) -> frozenset[tuple[str, str]]:
    """Which ask (first) another one (second) depends on in a template: at one of several sets of
    values at least.
    """
    found: set[tuple[str, str]] = set()
    for number in range(_INSTANCES):
        with suppress(KinegradeError, ArithmeticError):
            found.update(
                _find_connected(Follower(template, choose_generic_values(template, number)))
            )
    return frozenset(found)


def find_generic_plan(template: Template) -> Plan | None:
    """The plan of a template, found where nothing is special; None where no drawable values have
    one.
    """
    for number in range(_INSTANCES):
        with suppress(KinegradeError, ArithmeticError):
            return Follower(template, choose_generic_values(template, number)).plan
    return None


def choose_generic_values(template: Template, number: int) -> dict[str, float]:
    """One of many sets of drawable parameters, in SI: each as far along its choices as chance would
    have it.
    """
    shares = (
        modf(number * _GOLDEN + place * _ROOT)[0] for place in range(len(template.parameters))
    )
    return {
        name: convert_parameter(parameter, parameter.choices[int(share * len(parameter.choices))])
        for (name, parameter), share in zip(template.parameters.items(), shares, strict=True)
    }


def _find_connected(follower: Follower) -> Iterator[tuple[str, str]]:
    """Which ask each one depends on in an instance: a change of the first by one per cent changes
    the second.
    """
    asks = follower.template.asks
    right = {name: follower.right(name) for name in asks}
    for earlier, number in right.items():
        motion = follower.motion({earlier: number * 1.01}) if number else None
        for later, before in right.items():
            after = follower.read(asks[later], motion) if motion and later != earlier else None
            if (
                before is not None
                and after is not None
                and abs(after - before) > SAME * max(abs(before), abs(after))
            ):
                yield earlier, later


def order_by_plan(template: Template, asks: Iterable[str]) -> tuple[str, ...]:
    """The asks in the order in which the plan comes to them: of velocities, of Coriolis and normal
    parts, which velocities decide, then of accelerations; alike ones stay as they stand.
    """

    def stage(name: str) -> int:
        calls = find_calls(template.asks[name].quantity) if name in template.asks else ()
        accelerations = [call for call in calls if find_level(call) == "acceleration"]
        return bool(accelerations) + any(not find_share(call) for call in accelerations)

    return tuple(sorted(asks, key=stage))
