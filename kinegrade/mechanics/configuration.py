"""Whether the bodies fit together: the condition of each joint on the positions at the instant."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.errors import MechanismError, Problem, suggest
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.mechanics.geometry import round_short
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.joints import Joint
from kinegrade.mechanics.laws import SharedPoint
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.numbers.number import Arithmetic


def require_assembled(mechanism: Mechanism, arithmetic: Arithmetic) -> None:
    """Raises MechanismError listing every joint that names unknown things or does not fit the
    positions.
    """
    problems = list(_find_unknown_names(mechanism)) or list(_find_nonsense(mechanism))
    problems = problems or [
        problem
        for joint in mechanism.joints
        for problem in _find_misfits(mechanism, joint, arithmetic)
    ]
    if problems:
        raise MechanismError(*problems)


def _find_unknown_names(mechanism: Mechanism) -> Iterator[Problem]:
    """Joints and drivers that name a body or point that does not exist, and bodies without
    points.
    """
    bodies = {body.name for body in mechanism.bodies} | {GROUND}
    for body in mechanism.bodies:
        if not body.points:
            yield Message("mechanics.no-points", body=body.name)
        for point in body.points:
            if point not in mechanism.points:
                where = Message("mechanics.body", name=body.name)
                yield Fault(where, _name_unknown_point(point, mechanism))
    for part in (*mechanism.joints, *mechanism.drivers):
        for name in part.list_bodies():
            if name not in bodies:
                hint = suggest(name, bodies)
                unknown = Message("mechanics.unknown-body", name=Quoted(name), hint=hint)
                yield Fault(part.describe(), unknown)
        for point in part.list_points():
            if point not in mechanism.points:
                yield Fault(part.describe(), _name_unknown_point(point, mechanism))


def _name_unknown_point(point: str, mechanism: Mechanism) -> Message:
    hint = suggest(point, mechanism.points)
    return Message("mechanics.unknown-point", name=Quoted(point), hint=hint)


def _find_nonsense(mechanism: Mechanism) -> Iterator[Problem]:
    """Joints and drivers that are meaningless: of a body with itself, or of a particle's
    rotation.
    """
    particles = {body.name for body in mechanism.bodies if body.particle}
    for part in (*mechanism.joints, *mechanism.drivers):
        yield from (Fault(part.describe(), what) for what in part.find_nonsense())
        yield from (
            Fault(part.describe(), Message("mechanics.particle", body=name))
            for name in part.list_turning_bodies()
            if name in particles
        )


def _find_misfits(mechanism: Mechanism, joint: Joint, arithmetic: Arithmetic) -> Iterator[Problem]:
    """What is wrong with the positions at one joint."""
    wrong = [
        Message("mechanics.radius", radius=round_short(circle.radius))
        for circle in joint.list_circles()
        if arithmetic.is_zero(circle.radius) or arithmetic.sign(circle.radius) <= 0
    ]
    wrong += [
        _name_loose_centre(pin) for pin in joint.list_needed_pins() if not mechanism.holds(pin)
    ]
    if any(arithmetic.is_zero(line.direction.squared()) for line in joint.list_lines()):
        wrong.append(Message("mechanics.no-direction"))
    else:
        wrong += joint.find_misfits(mechanism.points, arithmetic)
    return (Fault(joint.describe(), what) for what in wrong)


def _name_loose_centre(needed: SharedPoint) -> Message:
    """That a body does not turn on its carrier about its centre."""
    body, carrier = needed.bodies
    return Message("mechanics.not-carried", point=needed.point, body=body, carrier=carrier)
