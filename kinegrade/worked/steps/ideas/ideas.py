"""The idea of a solution, before its steps: what is known and sought, which point or frame is
chosen and why.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence, Set
from typing import assert_never

from kinegrade.language.message import Message, list_all
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import (
    EqualBeltSpeed,
    EqualPitchSpeed,
    EqualRotation,
    GuidedPoint,
    ImposedCircling,
    ImposedComponent,
    ImposedMotion,
    ImposedRotation,
    Law,
    NoSlip,
    SharedPoint,
    find_rolling,
)
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.vector_equation import VectorEquation
from kinegrade.problem.quantities.functions import find_coordinate, find_motion_calls
from kinegrade.problem.template.template import Ask
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Heading
from kinegrade.worked.rates.rolling import group_rolls, tell_rolls
from kinegrade.worked.steps.couplers import Coupler, choose_method, find_coupler, find_pole_body
from kinegrade.worked.steps.ideas.frames import explain_frames
from kinegrade.worked.steps.ideas.links import explain_link
from kinegrade.worked.steps.rigid import explain_choice, find_rigid_triangle
from kinegrade.worked.steps.titles import find_rotations, select_scalars
from kinegrade.worked.steps.two_tracks import find_two_tracks
from kinegrade.worked.vectors.stage import Stage


def find_reasons(
    stages: Iterable[tuple[Step, Stage]], asked: Sequence[Ask], case: Case, accelerated: bool
) -> tuple[Message, ...]:
    """For each way of finding velocities why it serves, with what it says of accelerations where
    these are sought too.
    """
    stages = tuple(stages)
    reasons = dict.fromkeys(
        reason for step, stage in stages for reason in _find_reasons(step, stage, accelerated)
    )
    by_normals = {find_pole_body(stage) for _, stage in stages}
    reasons |= dict.fromkeys(_explain_poles(by_normals, case))
    if not any(any(find_motion_calls(ask.quantity)) for ask in asked):
        reasons |= dict.fromkeys((_explain_pose(asked),))
    return tuple(reasons)


def _explain_pose(asked: Sequence[Ask]) -> Message:
    """How a pose is found: coordinates, and from them what else is asked."""
    if all(find_coordinate(ask.quantity) for ask in asked):
        return Message("solution.idea-places")
    return Message("solution.idea-pose")


def say_idea(task: Message, reasons: Sequence[Message], case: Case) -> Iterator[Block]:
    """The known and the sought, `task`, then why each way serves."""
    yield Heading(case.write(Message("solution.idea")), 1)
    yield case.say(_join((task, *reasons)))


def _join(sentences: Sequence[Message]) -> Message:
    first, *others = sentences
    for following in others:
        first = Message("solution.sentences", first=first, next=following)
    return first


def _find_reasons(step: Step, stage: Stage, accelerated: bool) -> Iterator[Message]:
    """Why the equations of a step serve; nothing for those that only carry a motion on."""
    case, coupler = stage.case, find_coupler(stage)
    wheel = find_two_tracks(step, stage)
    if wheel is not None:
        yield wheel.state_idea()
        return
    laws = [relation.source for relation in select_scalars(step, case)]
    rolls = filter(None, map(find_rolling, laws))
    yield from (tell_rolls(group, case) for group in group_rolls(rolls))
    for law in laws:
        yield from explain_link(law, case)
    triangle = find_rigid_triangle(stage)
    if triangle is not None:
        yield explain_choice(triangle, case)
    elif coupler is not None:
        yield _explain_choice(coupler, case)
    elif len(stage.equations) > 1:
        coupled = all(len(equation.unknowns) > 2 for equation in stage.equations)
        yield Message("solution.idea-together" if coupled else "solution.idea-several")
    elif stage.equations and _joins_rotations(stage.equations[0]):
        yield _explain_common_point(stage.equations[0], case)
    elif stage.equations:
        yield from explain_frames(stage, accelerated)


def _explain_choice(coupler: Coupler, case: Case) -> Message:
    """Why two points of a body serve, by the method that is taken."""
    body = case.naming.body(coupler.body)
    base, point = map(case.naming.point, (coupler.base.point, coupler.point.point))
    driven = _is_driven(coupler.base.point, case)
    known = Message("solution.velocity-given") if driven else Message("solution.velocity-found")
    match choose_method(coupler, case):
        case "base-point":
            return Message(
                "solution.choice-base-point",
                body=body,
                base=base,
                point=point,
                known=known,
                chosen=case.naming.point(coupler.rotation.base),
            )
        case "projection":
            return Message(
                "solution.choice-projection", body=body, base=base, point=point, known=known
            )
        case "pole":
            return Message("solution.choice-pole", body=body, base=base, point=point)
        case method:
            assert_never(method)


def _is_driven(point: str, case: Case) -> bool:
    """Whether a driver imposes the motion of a point."""
    laws = (relation.source for relation in case.motion.frames.relations)
    return any(law is not None and _drives(law, point) for law in laws)


def _drives(law: Law, point: str) -> bool:
    match law:
        case ImposedMotion(point=driven, of=of):
            return driven == point and of == GROUND
        case ImposedComponent(point=driven) | ImposedCircling(point=driven):
            return driven == point
        case ImposedRotation() | SharedPoint() | GuidedPoint() | EqualRotation():
            return False
        case NoSlip() | EqualPitchSpeed() | EqualBeltSpeed():
            return False
        case _:
            assert_never(law)


def _joins_rotations(equation: VectorEquation) -> bool:
    """Whether an equation has several base points, and no moving frame."""
    return len(find_rotations(equation)) > 1 and not equation.compositions


def _explain_common_point(equation: VectorEquation, case: Case) -> Message:
    """Why base points serve from which several bodies lead to one point, or one after the other
    from point to point.
    """
    rotations = find_rotations(equation)
    bodies = list_all(case.naming.body(term.rate.body) for term in rotations)
    if len({term.point for term in rotations}) > 1:
        return Message("solution.idea-base-chain", bodies=bodies)
    point = case.naming.point(rotations[0].point)
    bases = list_all(f"${case.naming.point(term.base)}$" for term in rotations)
    return Message("solution.idea-common-point", point=point, bodies=bodies, bases=bases)


def _explain_poles(by_normals: Set[str | None], case: Case) -> Iterator[Message]:
    """How the velocity poles are found that answers are about and that no normals lead to."""
    for body in sorted(case.findings.poles_sought - by_normals):
        if not case.findings.places_alone:
            yield Message("solution.idea-pole", body=case.naming.body(body))
