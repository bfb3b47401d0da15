"""The constructions of a template as steps: every point with its construction, whose arguments are
names, numbers and vectors of named points.

A construction within another becomes a separate step with an auxiliary point H.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, find_names
from kinegrade.mechanics.ground import GROUND
from kinegrade.problem.template.template import Template

_CENTRED = frozenset({"polar", "foot", "toward", "circle", "line"})
PLACED = frozenset({"polar", "meet", "foot", "midpoint", "toward"})


@dataclass(frozen=True)
class Step:
    """A point and its construction, whose arguments are names, numbers and vectors of named
    points.
    """

    point: str
    tree: Expression
    track: Call | None = None  # the fixed line along which a joint lets the point slide


def list_steps(template: Template) -> tuple[Step, ...]:
    """The template's points in its order, each after the auxiliary points that its construction
    needs.
    """
    found: list[Step] = []
    taken = {*template.scheme.points, *template.parameters, *template.scheme.lengths}
    for point, tree in template.scheme.points.items():
        hoisted: list[Step] = []
        before = sum(step.point not in template.scheme.points for step in found)
        plain = unnest(tree, hoisted, before, taken, top=True)
        found += [*hoisted, Step(point, plain, _find_track(point, template))]
    return tuple(found)


def _find_track(point: str, template: Template) -> Call | None:
    """The line fixed to the ground along which a point slides; None for any other point."""
    for joint in template.scheme.joints:
        fixed = joint.point == point and joint.of == GROUND
        if fixed and joint.on is not None and joint.on.function == "line":
            return joint.on
    return None


def unnest(
    tree: Expression, found: list[Step], before: int, taken: set[str], top: bool = False
) -> Expression:
    """The tree with inner constructions replaced by the names of auxiliary points, which are added
    to `found`.
    """
    match tree:
        case Operation(sign=sign):
            left, right = (unnest(part, found, before, taken) for part in (tree.left, tree.right))
            return Operation(sign, left, right)
        case Number() | Name():
            return tree
        case Call():
            return _unnest_call(tree, found, before, taken, top)
        case _:
            assert_never(tree)


def _unnest_call(
    tree: Call, found: list[Step], before: int, taken: set[str], top: bool
) -> Expression:
    """A call with inner constructions replaced likewise; where it places a point and is not `top`,
    it becomes a new point itself.
    """
    plain = Call(
        tree.function, tuple(unnest(part, found, before, taken) for part in tree.arguments)
    )
    if tree.function in _CENTRED and _reads_awkwardly(tree.function, plain.arguments[0]):
        centre = _add_auxiliary_point(plain.arguments[0], found, before, taken)
        plain = Call(tree.function, (centre, *plain.arguments[1:]))
    return (
        plain
        if top or tree.function not in PLACED
        else _add_auxiliary_point(plain, found, before, taken)
    )


def _reads_awkwardly(function: str, centre: Expression) -> bool:
    """Whether a sentence would read badly with the point about which, or from which, something is
    constructed.
    """
    pair = isinstance(centre, Call) and function == "circle"
    return pair or isinstance(centre, Operation)


def _add_auxiliary_point(tree: Expression, found: list[Step], before: int, taken: set[str]) -> Name:
    """The name of an auxiliary point, whose step is added to `found`."""
    name = next(
        name
        for count in range(before + len(found) + 1, 10_000)
        if (name := f"H{count}") not in taken
    )
    found.append(Step(name, tree))
    return Name(name)


def select_needed(all_steps: tuple[Step, ...], wanted: Iterable[str]) -> tuple[Step, ...]:
    """The steps of the points wanted and of those they are constructed from, in order."""
    missing = set(wanted)
    for step in reversed(all_steps):
        if step.point in missing:
            missing |= set(find_names(step.tree))
    return tuple(step for step in all_steps if step.point in missing)
