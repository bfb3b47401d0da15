"""Rims of equal speed: those of gears in mesh, and of pulleys that a belt joins."""

from __future__ import annotations

from kinegrade.language.message import Message
from kinegrade.mechanics.laws import EqualBeltSpeed, EqualPitchSpeed, EqualRimSpeed
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.rates.speeds import Statement, name_relative_rotation, state_radius


def state_meshing(mesh: EqualPitchSpeed, case: Case, level: Level) -> Statement:
    """Equal pitch speeds relative to the carrier, of opposite senses for external gears."""
    body, other = case.naming.body(mesh.body), case.naming.body(mesh.of)
    return Statement(
        Message("solution.title-mesh", body=body, other=other),
        Message(f"solution.mesh-{level}", carrier=case.naming.body(mesh.carrier)),
        _equate_rim_speeds(mesh, case, level),
    )


def state_belt(belt: EqualBeltSpeed, case: Case, level: Level) -> Statement:
    """Both rims move with the belt, seen from the carrier."""
    body, other = case.naming.body(belt.body), case.naming.body(belt.of)
    shape = "crossed" if belt.crossed else "open"
    return Statement(
        Message("solution.title-belt", body=body, other=other),
        Message(f"solution.belt-{shape}-{level}", carrier=case.naming.body(belt.carrier)),
        _equate_rim_speeds(belt, case, level),
    )


def _equate_rim_speeds(law: EqualRimSpeed, case: Case, level: Level) -> Equation:
    """The speeds of both rims relative to the carrier, or their changes."""
    sentence = case.template.scheme.joints[law.joint]
    left, right = (
        state_radius(circle, radius, case)
        * name_relative_rotation(turned, law.carrier, case, level)
        for circle, radius, turned in (
            (sentence.circle, law.circle.radius, law.body),
            (sentence.on, law.on.radius, law.of),
        )
    )
    return Equation(left, equate(right.signed(-1 if law.is_opposite else 1)))
