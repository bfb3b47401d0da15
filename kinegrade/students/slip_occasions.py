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
    moving = Counter(joint.point for joint in template.scheme.joints if joint.of != GROUND)
    rods = _has_rods(template)
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
        "own_transport": any(count > 1 for count in moving.values()),
        "vector_sum": any(_takes_magnitude(ask.quantity) for ask in asks.values()),
        "pole": "pole" in slips,
        "far_pivot": rods and "pole" in slips,
        "far_end": rods,
        "across": rods,
        "neighbour": rods and "pole" in slips,
        "rotation": rods,
    }


def _has_rods(template: Template) -> bool:
    """Whether a body is held at two points or more, by pins and guides: not by a pin on the ground,
    and not by its rim.
    """
    joints = template.scheme.joints
    at_rest = {body for joint in joints if GROUND in joint.bodies for body in joint.bodies}
    round_bodies = {joint.body for joint in joints if joint.circle is not None}
    held = Counter(
        body for joint in joints for body in (*joint.bodies, joint.body) if joint.of == GROUND
    )
    return any(held[body] > 1 for body in set(held) - at_rest - round_bodies - {""})


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
