"""The components of a point carried by a body that turns, from those of a base point."""

from __future__ import annotations

from kinegrade.mechanics.relations import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level, find_term_value
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import AxisName, VectorSymbol
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.vectors.components import find_known, list_component, list_turning_summands
from kinegrade.worked.vectors.summands import PLACES, add_summands, name_component


def state_carried_component(
    axis: AxisName,
    name: VectorSymbol,
    base: tuple[VectorSymbol, Vector] | None,
    term: Term,
    *,
    case: Case,
    level: Level,
) -> Equation:
    """v_Ax - omega (y_P - y_A), or a_Ax - alpha (y_P - y_A) - omega^2 (x_P - x_A), with numbers and
    value.

    `base` is the vector of the base point with its symbol, None where it is fixed. Terms of a
    rotation that is zero are left out.
    """
    place = PLACES[axis]
    summands = list(list_turning_summands(axis, term, case, level))
    value = find_term_value(term, case.motion, level)[place]
    if base is not None:
        symbol, vector = base
        summands = [*list_component(find_known(symbol, vector, case), axis, case), *summands]
        value = vector[place] + value
    return add_summands(name_component(name, axis), summands, value, level)
