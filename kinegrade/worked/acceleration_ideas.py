"""What the idea of a solution says of accelerations: whether they follow as the velocities do."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from kinegrade.expressions.tree import Call, Name
from kinegrade.language.message import Message
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.vector_equation import Part
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.template.template import Ask
from kinegrade.worked.case import Case
from kinegrade.worked.contacts import find_contact
from kinegrade.worked.rate_chapters import find_stages, list_found
from kinegrade.worked.rates.kinds import find_fixed_axis
from kinegrade.worked.steps.couplers import name_method
from kinegrade.worked.steps.given_steps import is_given
from kinegrade.worked.vectors.stage import Stage


def explain_accelerations(
    velocities: Mapping[Step, Stage],
    accelerations: Sequence[Step],
    asked: Iterable[Ask],
    case: Case,
) -> Iterator[Message]:
    """Whether the accelerations take steps of the velocities, with vectors, by the same methods;
    else, where a pole has given velocities, that it gives no accelerations.
    """
    if not accelerations:
        return
    given = list_found(step for step in accelerations if is_given(step, case))
    stages = find_stages(accelerations, case, "acceleration", given)
    vectorial = any(stage.equations for stage in stages.values())
    poles = any(map(name_method, velocities.values()))
    if vectorial and stages.keys() <= velocities.keys() and not poles:
        yield Message("solution.idea-accelerations")
        return
    bodies = case.motion.frames.mechanism.bodies
    contacts = any(find_contact(body.name, case) for body in bodies if not body.particle)
    points = any(
        _takes_base_point(call, case) for ask in asked for call in find_motion_calls(ask.quantity)
    )
    based = any(
        _is_about_base(part, case)
        for stage in stages.values()
        for equation in stage.equations
        for part in equation.parts
    )
    if (poles or contacts) and (based or points):
        yield Message("solution.idea-accelerations-base")


def _is_about_base(part: Part, case: Case) -> bool:
    """Whether a part of an acceleration is of the rotation about a base point, of a body that turns
    about no fixed axis.
    """
    if part.role != "rotation" or part.term is None:
        return False
    named = part.term.rate.body
    (body,) = (each for each in case.motion.frames.mechanism.bodies if each.name == named)
    return find_fixed_axis(body, case) is None


def _takes_base_point(call: Call, case: Case) -> bool:
    """Whether an acceleration is that of a point which goes round no fixed axis."""
    if MOTION_FUNCTIONS[call.function].level != "acceleration":
        return False
    named = {part.name for part in call.arguments if isinstance(part, Name)}
    owners = [
        body for body in case.motion.frames.mechanism.bodies if not named.isdisjoint(body.points)
    ]
    return bool(owners) and not any(find_fixed_axis(body, case) for body in owners)
