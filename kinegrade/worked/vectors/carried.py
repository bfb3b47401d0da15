"""The components of a point carried by a body that turns, from those of a base point."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Literal

from kinegrade.mechanics.relations import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level, find_term_value
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import OTHER, TWO, AxisName, VectorSymbol
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.formulas.symbols import name_coordinate
from kinegrade.worked.positions.algebra import ZERO
from kinegrade.worked.positions.axes import Axes, choose_axes
from kinegrade.worked.positions.construction_steps import list_steps
from kinegrade.worked.vectors.summands import PLACES, Summand, add_summands, name_component
from kinegrade.worked.vectors.vectors import UNITS


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
    summands = list(_list_turning_summands(axis, term, case, level))
    value = find_term_value(term, case.motion, level)[place]
    if base is not None:
        symbol, vector = base
        size = measure(vector[place], UNITS[level, False])
        known = Summand("+", name_component(symbol, axis), (size,))
        summands, value = [known, *summands], vector[place] + value
    return add_summands(name_component(name, axis), summands, value, level)


def _list_turning_summands(
    axis: AxisName, term: Term, case: Case, level: Level
) -> Iterator[Summand]:
    """The terms that the rotation about a base point adds to a component; none where the rotation
    is zero, or the arm by the choice of the axes.
    """
    other = OTHER[axis]
    signs: Mapping[AxisName, Literal["+", "-"]] = {"x": "-", "y": "+"}
    rate, body = case.motion.rates[term.rate], term.rate.body
    letters, value = case.naming.turning(body, level), case.rates(level)[term.rate]
    axes = choose_axes(list_steps(case.template))
    across, along = (_state_arm(one, term, axes, case) for one in (other, axis))
    if double(value) and across is not None:
        yield Summand(
            signs[axis],
            letters * across,
            (measure(value, UNITS[level, True]), measure(term.vector[PLACES[other]], "m")),
        )
    if level == "acceleration" and double(rate) and along is not None:
        yield Summand(
            "-",
            case.naming.omega(body) ** TWO * along,
            (measure(rate, "rad/s"), measure(term.vector[PLACES[axis]], "m")),
            squared=True,
        )


def _state_arm(axis: AxisName, term: Term, axes: Axes, case: Case) -> Formula | None:
    """A coordinate of a point from its base point, the latter left out where the choice of the axes
    makes it zero; None where it makes both zero.
    """
    point, base = (
        name_coordinate(axis, case.naming.letter(name)) for name in (term.point, term.base)
    )
    if axes.coordinate(axis, term.base) != ZERO:
        return point - base
    return None if axes.coordinate(axis, term.point) == ZERO else point
