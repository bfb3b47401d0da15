"""What no slip gives: the speed of the centre by the rotation, or the rotation by that speed."""

from __future__ import annotations

from kinegrade.mechanics.laws import NoSlip
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import ZERO, add_terms
from kinegrade.worked.formulas.equation import Equation, lead_to
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.rolled_motion import (
    find_linked_term,
    find_slip_sign,
    state_rolled_radius,
)
from kinegrade.worked.rates.speeds import (
    find_rotation_value,
    name_carried_rotation,
    name_relative_rotation,
    name_rotation,
    name_speed,
)
from kinegrade.worked.vectors.known_vectors import find_stated_sense
from kinegrade.worked.vectors.stage import measure_along_direction
from kinegrade.worked.vectors.vectors import UNITS


def solve_rolling(
    roll: NoSlip, relation: Relation, result: Equation, case: Case, level: Level
) -> Equation | None:
    """What no slip says of the speed that goes with the body's rotation, or of this, which `result`
    gives: in symbols, with numbers unless they are zero, and the value. None for other rates.
    """
    term = find_linked_term(roll, relation, case)
    if result.left == name_speed(term, case, level):
        working = _state_centre_speed(roll, relation, case, level)
    elif result.left == name_rotation(roll.body, case, level):
        working = _state_rotation(roll, relation, case, level)
    else:
        return None
    return Equation(result.left, lead_to(result.left, working, result.links), result.aside)


def _state_centre_speed(
    roll: NoSlip, relation: Relation, case: Case, level: Level
) -> tuple[Formula, ...]:
    """The radius times the rotation relative to the track, in symbols and in numbers."""
    sign = find_slip_sign(roll, relation, case, level)
    other = find_rotation_value(roll.of, case, level)
    symbols = state_rolled_radius(roll, case) * name_relative_rotation(
        roll.body, roll.of, case, level
    )
    turned = measure(find_rotation_value(roll.body, case, level), UNITS[level, True])
    if turned == ZERO and not double(other):
        return (symbols.signed(sign),)
    rotation = turned - measure(other, UNITS[level, True]) if double(other) else turned
    numbers = measure(roll.circle.radius, "m").dot(rotation)
    return symbols.signed(sign), numbers.signed(sign)


def _state_rotation(
    roll: NoSlip, relation: Relation, case: Case, level: Level
) -> tuple[Formula, ...]:
    """The rotation of the track and the speed of the centre over the radius, in symbols and in
    numbers.
    """
    sign = find_slip_sign(roll, relation, case, level)
    term = find_linked_term(roll, relation, case)
    other = find_rotation_value(roll.of, case, level)
    symbol: Formula = name_speed(term, case, level)
    value = measure_along_direction(term, case, level) * find_stated_sense(term, case, level)
    turned = (symbol.size / state_rolled_radius(roll, case)).signed(sign * symbol.sign)
    carried = name_carried_rotation(roll.of, case, level)
    symbols = add_terms((carried, turned) if carried != ZERO else (turned,))
    known = measure(value * sign, UNITS[level, False])
    if known == ZERO:
        return (symbols,)
    rest = (known.size / measure(roll.circle.radius, "m")).signed(known.sign)
    track = measure(other, UNITS[level, True])
    return symbols, add_terms((track, rest) if double(other) else (rest,))
