"""Which slips a template gives occasion for: whether it has terms of which a share may be taken."""

from __future__ import annotations

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
        "pole": "pole" in slips,
    }


def calls(tree: Expression, functions: tuple[str, ...], count: int) -> bool:
    """Whether one of the functions is called with `count` arguments in an expression."""
    return any(
        isinstance(part, Call) and part.function in functions and len(part.arguments) == count
        for part in walk(tree)
    )
