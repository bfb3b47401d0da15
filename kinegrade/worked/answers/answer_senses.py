"""In words, to which side an answer points: beside its box, where no step has said so."""

from __future__ import annotations

from typing import assert_never

from kinegrade.expressions.tree import Call, Expression, Name, Operation
from kinegrade.language.math.tree import Row
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.kinds.dimension import ACCELERATION, CHANGE, RATE, SPEED, find_dimension
from kinegrade.problem.template.template import Ask
from kinegrade.problem.template.translated import Translated
from kinegrade.sign_conventions import Convention
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.senses import (
    state_rotation_sense,
    state_sense_along,
    state_way,
    state_way_round,
)

_RIGHT, _UP = Vector(1, 0), Vector(0, 1)


def state_answer_sense(ask: Ask, case: Case) -> Row:
    """Where a velocity or an acceleration points, or in which sense a body turns, by the sign of
    the answer and the convention of the question; nothing for zero and for what has no sign.
    """
    answer = case.solution.answers[ask.name]
    dimension = find_dimension(ask.unit)
    value = 0.0 if answer.at_infinity else double(answer.value)
    if not value or dimension not in (SPEED, ACCELERATION, RATE, CHANGE):
        return ()
    if isinstance(ask.sign, Translated):
        return _state_own_sense(ask.quantity, value, case)
    return _state_usual_sense(ask.sign, value, case)


def _state_usual_sense(sign: Convention, value: float, case: Case) -> Row:
    match sign:
        case "ccw":
            return state_rotation_sense(value, case)
        case "cw":
            return state_rotation_sense(-value, case)
        case "+x":
            return state_way(_RIGHT * value, case)
        case "-x":
            return state_way(_RIGHT * -value, case)
        case "+y":
            return state_way(_UP * value, case)
        case "-y":
            return state_way(_UP * -value, case)
        case "magnitude" | "unsigned" | "signed":
            return ()
        case _:
            assert_never(sign)


def _state_own_sense(quantity: Expression, value: float, case: Case) -> Row:
    """The sense of a component along the line from one point to another, or across it, by which the
    vector's point goes round the other one; nothing for others.
    """
    match quantity:
        case Call("along", (Call(_, (Name(point), *_)), Call("turned", (line,)))):
            return _state_way_across(point, line, value, case)
        case Call("along", (_, Operation("-", Name(end), Name(start)))):
            positive = case.motion.points[end] - case.motion.points[start]
            return state_sense_along(value, positive, (start, end), case)
        case _:
            return ()


def _state_way_across(point: str, line: Expression, value: float, case: Case) -> Row:
    match line:
        case Operation("-", Name(end), Name(centre)) if end == point:
            return state_way_round(centre, value, case)
        case Operation("-", Name(centre), Name(start)) if start == point:
            return state_way_round(centre, -value, case)
        case _:
            return ()
