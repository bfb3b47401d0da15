"""Rims of equal speed: those of gears in mesh, and of pulleys that a belt joins."""

from __future__ import annotations

from dataclasses import dataclass
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import EqualBeltSpeed, EqualPitchSpeed, EqualRimSpeed
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import ZERO
from kinegrade.worked.formulas.equation import Equation, equate, lead_to
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.speeds import (
    Statement,
    find_rotation_value,
    name_carried_rotation,
    name_relative_rotation,
    name_rotation,
    state_radius,
)
from kinegrade.worked.vectors.vectors import UNITS


def state_meshing(mesh: EqualPitchSpeed, case: Case, level: Level) -> Statement:
    """Equal pitch speeds relative to the carrier, of opposite senses for external gears."""
    body, other = case.naming.body(mesh.body), case.naming.body(mesh.of)
    return Statement(
        Message("solution.title-mesh", body=body, other=other),
        say_of_carrier(_name_mesh(mesh, level), mesh.carrier, case),
        _equate_rim_speeds(mesh, case, level),
    )


def _name_mesh(mesh: EqualPitchSpeed, level: Level) -> str:
    """Which sentence says how gears turn: by the kind of mesh, then as said before."""
    match level:
        case "velocity":
            return "mesh-internal-velocity" if mesh.inside else "mesh-external-velocity"
        case "acceleration":
            return "mesh-acceleration"
        case _:
            assert_never(level)


def state_belt(belt: EqualBeltSpeed, case: Case, level: Level) -> Statement:
    """Both rims move with the belt, seen from the carrier."""
    body, other = case.naming.body(belt.body), case.naming.body(belt.of)
    shape = "crossed" if belt.crossed else "open"
    return Statement(
        Message("solution.title-belt", body=body, other=other),
        say_of_carrier(f"belt-{shape}-{level}", belt.carrier, case),
        _equate_rim_speeds(belt, case, level),
    )


def say_of_carrier(what: str, carrier: str, case: Case) -> Message:
    """A sentence on rims as they are seen from their carrier, which is not named where it is the
    ground.
    """
    if carrier == GROUND:
        return Message(f"solution.{what}-from-ground")
    return Message(f"solution.{what}-from-carrier", carrier=case.naming.body(carrier))


def solve_rims(law: EqualRimSpeed, result: Equation, case: Case, level: Level) -> Equation | None:
    """What equal rim speeds say of the rotation of a gear or pulley, which `result` gives: in
    symbols, with numbers, and the value. None for the carrier's.
    """
    names, unit = (law.body, law.of), UNITS[level, True]
    letters = [name_rotation(name, case, level) for name in names]
    if result.left not in letters:
        return None
    turned = letters.index(result.left)
    other, sign = names[1 - turned], -1 if law.is_opposite else 1
    rims = _Rims(
        state_radii(law, case)[1 - turned] / state_radii(law, case)[turned],
        name_rotation(other, case, level),
        name_carried_rotation(law.carrier, case, level),
    )
    lengths = [measure(circle.radius, "m") for circle in (law.circle, law.on)]
    numbers = _Rims(
        lengths[1 - turned] / lengths[turned],
        measure(find_rotation_value(other, case, level), unit),
        measure(find_rotation_value(law.carrier, case, level), unit),
    )
    working = rims.solve(sign), numbers.solve(sign)
    return Equation(result.left, lead_to(result.left, working, result.links), result.aside)


@dataclass(frozen=True)
class _Rims:
    """The ratio of the radii, the rotation of the other body and that of the carrier."""

    ratio: Formula
    other: Formula
    carrier: Formula

    def solve(self, sign: int) -> Formula:
        """The rotation that is sought: omega_c + r' / r (omega' - omega_c)."""
        if self.carrier == ZERO:
            return ZERO if self.other == ZERO else self.ratio.dot(self.other).signed(sign)
        if self.other == ZERO:
            return self.carrier + self.ratio.dot(self.carrier).signed(-sign)
        return self.carrier + self.ratio.dot(self.other - self.carrier).signed(sign)


def _equate_rim_speeds(law: EqualRimSpeed, case: Case, level: Level) -> Equation:
    """The speeds of both rims relative to the carrier, or their changes."""
    left, right = (
        radius * name_relative_rotation(turned, law.carrier, case, level)
        for radius, turned in zip(state_radii(law, case), (law.body, law.of), strict=True)
    )
    return Equation(left, equate(right.signed(-1 if law.is_opposite else 1)))


def state_radii(law: EqualRimSpeed, case: Case) -> tuple[Formula, Formula]:
    """The radii of both rims, in symbols where the template has them."""
    sentence = case.template.scheme.joints[law.joint]
    return (
        state_radius(sentence.circle, law.circle.radius, case),
        state_radius(sentence.on, law.on.radius, case),
    )
