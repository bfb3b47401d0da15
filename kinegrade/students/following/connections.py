"""Which asks of a template depend on which, and the order in which the plan comes to them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import chain
from math import modf

from kinegrade.errors import KinegradeError
from kinegrade.mechanics.plan import Plan
from kinegrade.problem.template.template import Template
from kinegrade.students.following.follow_through import Follower
from kinegrade.students.following.followed_quantities import (
    find_calls,
    find_level,
    find_share,
)
from kinegrade.students.following.followers import AnyFollower, make_follower
from kinegrade.students.mistaking.mistakes import convert_parameter

_INSTANCES = 3  # looked at to see which asks are connected
_CHANGED = 1.3  # times the right answer
_GOLDEN, _ROOT = 0.6180339887, 0.4142135624  # steps along choices that never meet again


def find_connections(template: Template, asks: Collection[str]) -> Mapping[str, tuple[str, ...]]:
    """For each of some asks the others from which it follows, where it follows from any: at one of
    several sets of values at least.
    """
    stages = find_stages(template, asks)
    found: dict[str, set[str]] = {name: set() for stage in stages for name in stage}
    for number in range(_INSTANCES):
        with suppress(KinegradeError, ArithmeticError):
            follower = make_follower(template, choose_generic_values(template, number))
            for earlier, later in _find_connected(follower, stages):
                found[later].add(earlier)
    return {
        later: tuple(name for name in found if name in earlier)
        for later, earlier in found.items()
        if earlier
    }


def find_generic_plan(template: Template) -> Plan | None:
    """The plan of a template, found where nothing is special; None where no drawable values have
    one, as steps have none.
    """
    if not template.scheme.has_mechanism:
        return None
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


def _find_connected(
    follower: AnyFollower, stages: Sequence[Sequence[str]]
) -> Iterator[tuple[str, str]]:
    """Which ask each one depends on in an instance: a change of the first, by nearly a third,
    changes the second in some way of going on.
    """
    for number, stage in enumerate(stages):
        for earlier in stage:
            own = {earlier: _CHANGED * (follower.right(earlier) or 0.0)}
            for later in chain(*stages[number:]):
                if follower.consequences(own, later):
                    yield earlier, later


def find_stages(template: Template, asks: Iterable[str]) -> Sequence[Sequence[str]]:
    """The asks in the order in which the plan comes to them: of velocities, of Coriolis and normal
    parts, which velocities decide, then of accelerations; alike ones stand together. Steps come one
    after the other.
    """
    if not template.scheme.has_mechanism:
        wanted = frozenset(asks)
        return [[name] for name in template.scheme.steps if name in wanted]
    stages: tuple[list[str], ...] = ([], [], [])
    for name in asks:
        calls = find_calls(template.asks[name].quantity) if name in template.asks else ()
        accelerations = [call for call in calls if find_level(call) == "acceleration"]
        parts = not any(not find_share(call) for call in accelerations)
        stages[bool(accelerations) + (not parts)].append(name)
    return [stage for stage in stages if stage]
