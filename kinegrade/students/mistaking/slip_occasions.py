"""Which slips a template gives occasion for: whether it has terms of which a share may be taken."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from kinegrade.expressions.tree import Call, Expression, walk
from kinegrade.mechanics.joints import GROUND
from kinegrade.problem.template.template import Ask, Template


def find_share_occasions(template: Template, asks: Mapping[str, Ask]) -> dict[str, bool]:
    """For each share of a term whether the template has such terms."""
    slips = {slip for joint in template.scheme.joints for slip in joint.stated.SLIPS}
    relative = any(joint.of != GROUND for joint in template.scheme.joints) or any(
        driver.of != GROUND for driver in template.scheme.drivers
    )
    guided = Counter(joint.point for joint in template.scheme.joints if joint.of != GROUND)
    rods = _find_rods(template)
    neighbours = _count_neighbours(template, rods)
    accelerations = any(ask.unit.time == -2 for ask in asks.values())
    return {
        "coriolis": accelerations and relative,
        "frame_rate": accelerations and relative,
        "relative_normal": accelerations,
        "path_normal": accelerations,
        "square": accelerations,
        "tangential": accelerations,
        "carried": "carried" in slips
        or any(driver.of != GROUND for driver in template.scheme.drivers),
        "asked_relative": any(calls(ask.quantity, ("omega", "alpha"), 2) for ask in asks.values()),
        "meshing": "meshing" in slips,
        "crossing": "crossing" in slips,
        "arm": "arm" in slips,
        "ratio": any(
            "ratio" in joint.stated.SLIPS and joint.on is not None and joint.on.function == "circle"
            for joint in template.scheme.joints
        ),
        "centre": "centre" in slips,
        "relative": relative,
        "own_transport": any(count > 1 for point, count in guided.items() if point),
        "vector_sum": any(_takes_magnitude(ask.quantity) for ask in asks.values()),
        "pole": "pole" in slips,
        "far_pivot": neighbours > 1,
        "far_end": bool(rods),
        "across": bool(rods),
        "neighbour": neighbours > 0,
        "rotation": bool(rods),
    }


def _find_rods(template: Template) -> set[str]:
    """The bodies that pins and fixed guides hold at two points or more, and nothing else: no pin on
    the ground, no rim, no sleeve, nothing that keeps them from turning.
    """
    joints = template.scheme.joints
    held = Counter(body for joint in joints for body in joint.bodies)
    held.update(joint.body for joint in joints if joint.body and joint.of == GROUND)
    otherwise = {joint.body for joint in joints if not joint.point}
    several = {body for body, count in held.items() if count > 1}
    return several - _find_pivoted(template) - otherwise


def _find_pivoted(template: Template) -> set[str]:
    """The ground and the bodies that are pinned to it."""
    joints = template.scheme.joints
    return {body for joint in joints if GROUND in joint.bodies for body in joint.bodies}


def _count_neighbours(template: Template, rods: set[str]) -> int:
    """To how many bodies that turn about a fixed pin a rod is pinned, at most."""
    pivoted, joints = _find_pivoted(template), template.scheme.joints
    counts = [
        len({body for joint in joints if rod in joint.bodies for body in joint.bodies} & pivoted)
        for rod in rods
    ]
    return max(counts, default=0)


def _takes_magnitude(tree: Expression) -> bool:
    """Whether the magnitude of a velocity or an acceleration is taken in an expression."""
    return any(
        isinstance(part, Call)
        and part.function == "magnitude"
        and isinstance(part.arguments[0], Call)
        and part.arguments[0].function in ("velocity", "acceleration")
        for part in walk(tree)
    )


def calls(tree: Expression, functions: tuple[str, ...], count: int) -> bool:
    """Whether one of the functions is called with `count` arguments in an expression."""
    return any(
        isinstance(part, Call) and part.function in functions and len(part.arguments) == count
        for part in walk(tree)
    )
