"""What positions fulfil, in letters, and what says that a check differentiates it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import AxisName
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case, write_row
from kinegrade.worked.checks.amounts import Amount, Multiplier
from kinegrade.worked.checks.arms import point_from_base
from kinegrade.worked.formulas.atoms import AXES, TWO, ZERO, add_terms
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.formulas.formula import Formula, Product
from kinegrade.worked.formulas.functions import Function
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.symbols import name_coordinate
from kinegrade.worked.positions.algebra import ZERO as ORIGIN
from kinegrade.worked.positions.axes import choose_axes
from kinegrade.worked.vectors.summands import PLACES


@dataclass(frozen=True)
class Condition:
    """The way of a check, and the formulas that stand in it."""

    way: Message
    formulas: tuple[Equation, ...] = ()


def differentiate_coordinate(
    axis: AxisName, chains: tuple[Sequence[Term], Sequence[Term]], level: Level, case: Case
) -> Condition:
    """The coordinate of the point at the end of two chains, by way of other points where there are
    such.
    """
    for chain, other in (chains, chains[::-1]):
        if len(chain) == 1 and _keeps_arm(axis, other, case):
            return _differentiate_constant(axis, other, level, case)
    first, second = (_add_arms(axis, chain, case) for chain in chains)
    if first is None or second is None or len(first) == len(second) == 1:
        return _differentiate_twice_over(axis, chains, level, case)
    left, right = map(add_terms, (first, second))
    equation = Equation(left, equate(right))
    way = Message(f"solution.sum-derivative-{level}", condition=_show(equation, case))
    return Condition(way, (equation,))


def _keeps_arm(axis: AxisName, chain: Sequence[Term], case: Case) -> bool:
    """Whether a chain goes from a point over an arm of a body that does not turn to the end, which
    moves in that body across the axis at most.
    """
    if len(chain) < 2 or chain[1].kind != "rotation" or chain[1].rate not in case.held_rates:
        return False
    arm, place = chain[1], PLACES[axis]
    slides = all(not double(term.vector[place]) for term in chain[2:])
    return arm.base == chain[0].point and bool(double(arm.vector[place])) and slides


def _differentiate_constant(
    axis: AxisName, chain: Sequence[Term], level: Level, case: Case
) -> Condition:
    """The difference of two coordinates, whose derivatives are zero."""
    part = point_from_base(chain[1], case).pair[axis]
    difference = Equation(part.letters.signed(part.sign), ())
    way = Message(f"solution.constant-derivative-{level}", condition=_show(difference, case))
    return Condition(way, (difference,))


def _differentiate_twice_over(
    axis: AxisName, chains: tuple[Sequence[Term], Sequence[Term]], level: Level, case: Case
) -> Condition:
    """One coordinate in two ways: its motion relative to a frame gives the one of them."""
    frames = [end.frame for *_, end in chains if end.kind != "rotation" and end.frame != GROUND]
    letters = {"axis": axis, "point": case.naming.point(chains[0][-1].point)}
    if len(frames) != 1:
        return Condition(Message(f"solution.coordinate-derivative-{level}", **letters))
    frame = case.naming.body(frames[0])
    return Condition(Message(f"solution.relative-derivative-{level}", **letters, frame=frame))


def _add_arms(axis: AxisName, chain: Sequence[Term], case: Case) -> list[Formula] | None:
    """A coordinate of the first point that moves, and from point to point what the bodies add; None
    where one is zero, or a point moves in a body and another one follows.
    """
    first, *others = chain
    fixed = choose_axes(case.construction).coordinate(axis, first.point) == ORIGIN
    if fixed or (first.frame != GROUND and first.kind != "rotation"):
        return None
    found: list[Formula] = [name_coordinate(axis, case.naming.letter(first.point))]
    for before, term in pairwise(chain):
        match term.kind:
            case "rotation":
                part = point_from_base(term, case).pair.get(axis)
                if part is None or term.base != before.point:
                    return None
                found.append(_enclose(part))
            case "sliding" | "arc":
                if term is not others[-1]:
                    return None
            case _:
                assert_never(term.kind)
    return found


def _enclose(part: Amount) -> Formula:
    """A difference of coordinates in brackets, in which it is differentiated as a whole."""
    letters = part.letters
    if letters.kind == "sum":
        letters = Product((letters,))
    return letters.signed(part.sign)


def differentiate_direction(arm: Multiplier, turn: Term, level: Level, case: Case) -> Condition:
    """The angle of an arm from the x axis, by its two coordinates."""
    angle = Equation(Function("arctan", _divide(arm.pair["y"], arm.pair["x"])), ())
    first, second = map(case.naming.point, (turn.base, turn.point))
    letters = {"condition": _show(angle, case), "first": first, "second": second}
    way = Message(f"solution.direction-derivative-{level}", **letters)
    return Condition(way, (angle,))


def differentiate_length(arm: Multiplier, far: Formula, level: Level, case: Case) -> Condition:
    """The square of an arm, which is as long as it was."""
    squares = add_terms(one.letters**TWO for one in arm.pair.values())
    fixed = Equation(squares, equate(far**TWO))
    way = Message(f"solution.length-derivative-{level}", condition=_show(fixed, case))
    return Condition(way, (fixed,))


def differentiate_distance(
    normal: Multiplier, turn: Term, slide: Term, level: Level, case: Case
) -> Condition:
    """The distance of an axis from the line of a body along which a point slides."""
    x, y = parts = tuple(_state_component(normal, axis) for axis in AXES)
    letters = {
        "axis": case.naming.point(turn.base),
        "slider": case.naming.point(slide.point),
        "x": _show(x, case),
        "y": _show(y, case),
    }
    way = Message(f"solution.distance-derivative-{level}", **letters)
    return Condition(way, parts)


def _show(formula: Equation, case: Case) -> str:
    """A formula in letters, as a part of what is said."""
    return f"${write_row(formula.print_inline(case.notation))}$"


def _state_component(vector: Multiplier, axis: AxisName) -> Equation:
    """A component of a vector in letters."""
    part = vector.pair.get(axis)
    return Equation(_sign(part) if part else ZERO, ())


def _divide(above: Amount, below: Amount) -> Formula:
    """The quotient of two components, without two signs that cancel."""
    return (above.letters / below.letters).signed(above.sign * below.sign)


def _sign(amount: Amount) -> Formula:
    return amount.letters.signed(amount.sign)
