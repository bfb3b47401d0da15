"""An instance in the letters of its statement: what is printed without a minus is positive."""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import replace
from typing import Any

from msgspec import structs

from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.negating import negate_arguments, negate_names
from kinegrade.expressions.signs import fold_signs
from kinegrade.expressions.tree import Call, Expression
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.balls import PRECISIONS, Balls
from kinegrade.problem.quantity import Quantity
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.sentences import DriverSentence, JointSentence
from kinegrade.problem.template.template import Scheme, Template
from kinegrade.problem.template.texts import find_unsigned_givens


def restate(solution: Solution) -> Solution:
    """The same motion and answers in the givens as the statement prints them: the size of those
    whose sign its words say, with a minus in the template's expressions; and the mechanism to that
    side to which these numbers lay it out.
    """
    solution = _lay_out(solution)
    unsigned = find_unsigned_givens(solution.template)
    turned = {name for name in unsigned if solution.parameters[name].is_reversed}
    if not turned:
        return solution
    sizes = {name: solution.parameters[name].size for name in turned}
    values = {
        name: _turn_value(solution.assembly.values[name], size) for name, size in sizes.items()
    }
    return replace(
        solution,
        template=_turn_template(solution.template, turned),
        parameters={**solution.parameters, **sizes},
        assembly=replace(solution.assembly, values={**solution.assembly.values, **values}),
    )


def _lay_out(solution: Solution) -> Solution:
    """The solution with the signs of this draw in the places of the template."""
    values, functions = solution.assembly.values, solution.assembly.functions

    def is_negative(tree: Expression) -> bool:
        return float(evaluate(tree, values, functions, solution.arithmetic)) < 0

    scheme = solution.template.scheme
    points, lengths = (
        {name: fold_signs(tree, is_negative) for name, tree in trees.items()}
        for trees in (scheme.points, scheme.lengths)
    )
    if points == scheme.points and lengths == scheme.lengths:
        return solution
    laid_out = structs.replace(
        solution.template, scheme=structs.replace(scheme, points=points, lengths=lengths)
    )
    return replace(solution, template=laid_out)


def _turn_value(value: Any, size: Quantity) -> Any:
    """The value of a given by its printed size; that of an angle beyond half a turn, 195 degrees,
    is 165 degrees the other way round.
    """
    if isinstance(value, Angle):
        return size.number
    if float(value) < 0:
        return -value
    with Balls(PRECISIONS[0]).context():
        return size.number.ball()


def _turn_template(template: Template, names: Set[str]) -> Template:
    asks = {
        name: structs.replace(ask, quantity=negate_names(ask.quantity, names))
        for name, ask in template.asks.items()
    }
    return structs.replace(template, scheme=_turn_scheme(template.scheme, names), asks=asks)


def _turn_scheme(scheme: Scheme, names: Set[str]) -> Scheme:
    return structs.replace(
        scheme,
        lengths=_turn_all(scheme.lengths, names),
        points=_turn_all(scheme.points, names),
        steps=_turn_all(scheme.steps, names),
        joints=tuple(_turn_joint(joint, names) for joint in scheme.joints),
        drivers=tuple(_turn_driver(driver, names) for driver in scheme.drivers),
    )


def _turn_all(trees: Mapping[str, Expression], names: Set[str]) -> dict[str, Expression]:
    return {name: negate_names(tree, names) for name, tree in trees.items()}


def _turn_joint(joint: JointSentence, names: Set[str]) -> JointSentence:
    return replace(joint, circle=_turn_shape(joint.circle, names), on=_turn_shape(joint.on, names))


def _turn_shape(shape: Call | None, names: Set[str]) -> Call | None:
    return shape and negate_arguments(shape, names)


def _turn_driver(driver: DriverSentence, names: Set[str]) -> DriverSentence:
    return replace(
        driver,
        velocity=negate_names(driver.velocity, names),
        acceleration=negate_names(driver.acceleration, names),
        along=driver.along and negate_names(driver.along, names),
    )
