"""What of a template's givens is needed for what is asked: nothing else is printed for students."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from kinegrade.expressions.tree import Call, Expression, find_names
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.template.sentences import DriverSentence, JointSentence
from kinegrade.problem.template.template import Ask, Template


@dataclass(frozen=True)
class Needs:
    """The givens on which what is asked depends, and whether it is read off accelerations."""

    givens: frozenset[str]
    changes: bool


def find_needs(template: Template, asks: Iterable[str]) -> Needs:
    """What these asks need: the whole mechanism and the velocities that are imposed, accelerations
    where one is asked for, and points that no joint mentions where they are.
    """
    scheme, asked = template.scheme, [template.asks[name] for name in asks]
    changes = any(map(_is_by_changes, asked))
    names = {name for ask in asked for name in find_names(ask.quantity)}
    names |= {point for body in scheme.bodies if body.name in names for point in body.points}
    for joint in scheme.joints:
        names |= set(_list_joint_names(joint))
    for driver in scheme.drivers:
        names |= set(_list_driver_names(driver, changes=changes))
    made = {**scheme.points, **scheme.lengths, **scheme.steps}
    return Needs(frozenset(template.parameters) & _trace_back(names, made), changes)


def find_idle_givens(template: Template) -> tuple[str, ...]:
    """The givens on which nothing depends that is asked, moves, is drawn or is taken for something
    else.
    """
    scheme = template.scheme
    names = {*find_needs(template, template.asks).givens, *scheme.points}
    for mistake in scheme.mistakes:
        names.update(_find_all_names(*mistake.steps.values()))
    for driver in scheme.drivers:
        names |= set(_list_driver_names(driver, changes=True))
    used = _trace_back(names, {**scheme.points, **scheme.lengths, **scheme.steps})
    return tuple(name for name in template.parameters if name not in used)


def find_needed_steps(template: Template, asks: Iterable[str]) -> tuple[str, ...]:
    """The steps on which these asks depend, themselves among them, in order."""
    needed = _trace_back(asks, dict(template.scheme.steps))
    return tuple(name for name in template.scheme.steps if name in needed)


def _is_by_changes(ask: Ask) -> bool:
    """Whether the quantity of an ask is read off the changes of rates."""
    calls = find_motion_calls(ask.quantity)
    return any(MOTION_FUNCTIONS[call.function].by_changes for call in calls)


def _list_joint_names(joint: JointSentence) -> Iterator[str]:
    yield joint.point
    yield from _find_all_names(joint.circle, joint.on)


def _list_driver_names(driver: DriverSentence, *, changes: bool) -> Iterator[str]:
    yield from (driver.point, driver.centre)
    yield from _find_all_names(driver.along, driver.velocity)
    yield from find_names(driver.acceleration) if changes else ()


def _find_all_names(*trees: Expression | Call | None) -> Iterator[str]:
    return (name for tree in trees if tree is not None for name in find_names(tree))


def _trace_back(names: Iterable[str], made: dict[str, Expression]) -> frozenset[str]:
    """Names with all that they are made of."""
    found: set[str] = set()
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting += find_names(made[name]) if name in made else ()
    return frozenset(found)
