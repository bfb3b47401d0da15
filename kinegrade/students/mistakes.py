"""What known mistakes lead to, for the answers of one instance or of thousands: the same plan, run
on after each.

All mistakes of all instances go through one run in doubles, `find_outcomes`; `work_out` follows a
single one in any arithmetic, and tests hold the one against the other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cached_property, reduce
from math import isfinite
from typing import Any

import numpy as np
from flint import arb, fmpq

from kinegrade.errors import AtInfinity, ExpressionError, KinegradeError
from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.reading import read_expression
from kinegrade.mechanics.configuration import require_assembled
from kinegrade.mechanics.geometry import Round
from kinegrade.mechanics.motion import Motion, pose_mechanism, solve_motion
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.assemble import Assembly, assemble, read_parameter
from kinegrade.problem.centrode import Centrodes, find_circle
from kinegrade.problem.quantities.functions import make_quantities
from kinegrade.problem.quantities.reader import find_body_names
from kinegrade.problem.scale import list_sizes
from kinegrade.problem.template.template import Ask, Parameter, Template
from kinegrade.students.mistake_kinds import Mistake, find_candidates, list_answer_factors
from kinegrade.students.mistaken import make_mistaken_motion
from kinegrade.students.slips import Slips

RIGHT = Mistake("")
SAME = 1e-9  # relative, below one absolute: closer than this a value is not changed, only rounded
_LARGEST = 1e9  # in the ask's unit: what is larger is a division by zero that rounding hides
Values = Mapping[str, Sequence[str]]  # for each parameter the texts of an array of instances
_SHARES = tuple(field.name for field in fields(Slips))


@dataclass(frozen=True)
class _Misread:
    """An arithmetic in which the other one of two common points is chosen where `other` holds."""

    arithmetic: Arithmetic
    other: Any

    def __getattr__(self, name: str) -> Any:
        return getattr(self.arithmetic, name)

    def choose(self, condition: Any, yes: Any, no: Any) -> Any:
        """`yes` where the condition holds, else `no`; the other way round where a branch is
        mistaken.
        """
        choose = self.arithmetic.choose
        return choose(self.other, choose(condition, no, yes), choose(condition, yes, no))


@dataclass(frozen=True)
class Way:
    """One way through an instance, or many at once in arrays: the givens as taken, the slips, the
    branch, the units.
    """

    values: Mapping[str, Any]
    slips: Slips
    other_branch: Any = False
    plain_lengths: Any = False


def _solve_mistaken(
    template: Template, way: Way, plan: Plan, arithmetic: Arithmetic, *, perturbed: bool = False
) -> _Reader:
    """The motion as it comes out that way, to be read off; `perturbed` as `mistaken` takes it.

    Raises MechanismError or Singular where there is none, Inexact and Undecided as the arithmetic
    does.
    """
    assembly = assemble(template, way.values, _Misread(arithmetic, way.other_branch))
    motion: Motion
    if template.scheme.drivers:
        if arithmetic.certified:
            require_assembled(assembly.mechanism, arithmetic)
        motion = make_mistaken_motion(
            assembly.mechanism, arithmetic, plan, way.slips, perturbed=perturbed
        )
    else:
        motion = pose_mechanism(assembly.mechanism, arithmetic)
    centrodes = Centrodes if arithmetic.certified else CloseCentrodes
    return _Reader(assembly, motion, centrodes(template, way.values, plan), way.plain_lengths)


def work_out(
    template: Template, asks: Mapping[str, Ask], way: Way, plan: Plan, arithmetic: Arithmetic
) -> dict[str, Any]:
    """The answers in the asks' units, without those that the mistake leaves without a value. Raises
    as `_solve_mistaken`.
    """
    reader = _solve_mistaken(template, way, plan, arithmetic)
    found = {name: reader.answer(ask, arithmetic) for name, ask in asks.items()}
    return {name: value for name, value in found.items() if value is not None}


@dataclass(frozen=True)
class CloseCentrodes(Centrodes):
    """Centrodes in doubles, for arrays of instances: through three poles close together, whatever
    the curve.
    """

    def find(self, body: str, parameter: str, arithmetic: Arithmetic) -> Round:
        """The circle through the poles at the instant and 3 degrees to both sides of it; NaN where
        out of reach.
        """
        poles = []
        for step in (0, 1, -1):
            changed = self.values[parameter] + step * arithmetic.turns(fmpq(1, 60))
            mechanism = assemble(
                self.template, {**self.values, parameter: changed}, arithmetic
            ).mechanism
            poles.append(solve_motion(mechanism, arithmetic, self.plan).pole(body, arithmetic))
        return find_circle(poles[0], poles[1], poles[2], arithmetic)


@dataclass(frozen=True)
class _Reader:
    """Reads answers off a motion, in the asks' units."""

    assembly: Assembly
    motion: Motion
    centrodes: Centrodes
    plain_lengths: Any

    def answer(self, ask: Ask, arithmetic: Arithmetic) -> Any:
        """The answer of one ask, None where there is no value."""
        forked = arithmetic.fork()
        values = {**find_body_names(self.assembly.mechanism), **self.assembly.values}
        functions = {
            **self.assembly.functions,
            **make_quantities(self.motion, forked),
            **self.centrodes.functions(forked),
        }
        try:
            number = evaluate(ask.quantity, values, functions, forked)
        except (KinegradeError, AtInfinity):
            return None
        return self._in_unit(number, ask, arithmetic)

    def _in_unit(self, number: Any, ask: Ask, arithmetic: Arithmetic) -> Any:
        """A number of SI as it is written in the ask's unit; a length as it stands where no unit
        was thought of.
        """
        if isinstance(number, Angle):
            return number
        if ask.unit.degrees:
            return number * 180 / (arb.pi() if isinstance(number, arb) else np.pi)
        number = fmpq(number) if isinstance(number, int) and arithmetic.certified else number
        converted = number / arithmetic.number(ask.unit.factor)
        return (
            arithmetic.choose(self.plain_lengths, number, converted)
            if ask.unit.length
            else converted
        )


def choose_way(
    mistake: Mistake, template: Template, values: Mapping[str, Any], arithmetic: Arithmetic
) -> Way:
    """The way of one mistake at the parameters `values` (SI), for `work_out` in any arithmetic."""
    shares = {name: arithmetic.number(share) for name, share in mistake.shares.items()}
    return Way(
        mistake.givens(template, values, arithmetic),
        Slips(**shares),
        mistake.other_branch,
        mistake.plain_lengths,
    )


@dataclass(frozen=True)
class Outcomes:
    """What mistakes lead to in an array of instances.

    `answers` has for every ask a row for the right answer, then one for each mistake, in the ask's
    unit; NaN where there is no value. `scales` has for every ask each instance's scale of such
    quantities, in the ask's unit.
    """

    answers: Mapping[str, Any]
    scales: Mapping[str, Any]


def find_outcomes(
    template: Template,
    asks: Mapping[str, Ask],
    mistakes: Sequence[Mistake],
    values: Mapping[str, Any],
    plan: Plan,
    *,
    perturbed: bool = False,
) -> Outcomes:
    """What the mistakes lead to; `values` are parameters in SI, numbers or arrays of instances.

    `perturbed` as `mistaken` takes it: what then differs depends on the mistaken term, even where
    it is zero.
    """
    floats, ways = Floats(), (RIGHT, *mistakes)
    shape = np.broadcast_shapes(*(np.shape(value) for value in values.values()))
    nothing = np.full(shape, np.nan)
    with floats.context():
        way = _join_ways(template, ways, values, shape)
        try:
            reader = _solve_mistaken(template, way, plan, floats, perturbed=perturbed)
        except (KinegradeError, Singular):
            return Outcomes(
                {name: _require_finite(nothing, (len(ways), *shape)) for name in asks},
                dict.fromkeys(asks, nothing),
            )
        found = {name: reader.answer(ask, floats) for name, ask in asks.items()}
        answers = {
            name: _require_finite(nothing if value is None else value, (len(ways), *shape))
            for name, value in found.items()
        }
        return Outcomes(
            answers,
            {
                name: _find_right_scale(reader.motion, ask, (len(ways), *shape))
                for name, ask in asks.items()
            },
        )


def find_known_mistakes(
    template: Template, asks: Mapping[str, Ask], values: Values, plan: Plan
) -> dict[str, dict[str, Any]]:
    """For every ask and mistake an array of what it leads to in each instance, as
    `Quantity.mistakes` does in one.

    NaN where a mistake has no value; those that change nothing in an instance have the right answer
    there.
    """
    kinds = tuple(find_candidates(template, asks))
    rows = find_outcomes(template, asks, kinds, convert_parameters(template, values), plan).answers
    return {
        name: {
            **dict(zip((kind.identifier for kind in kinds), rows[name][1:], strict=True)),
            **{
                written: rows[name][0] * convert_number(factor)
                for written, factor in list_answer_factors(ask).items()
            },
        }
        for name, ask in asks.items()
    }


def convert_parameters(template: Template, values: Values) -> dict[str, Any]:
    """The parameters (SI, radians) as arrays of doubles; NaN for a text that is no number."""
    arrays = {}
    for name, texts in values.items():
        known = {text: convert_parameter(template.parameters[name], text) for text in set(texts)}
        arrays[name] = np.array([known[text] for text in texts])
    return arrays


def convert_parameter(parameter: Parameter, text: str) -> float:
    """A parameter's value (SI, radians) as a double; NaN where the text is no number."""
    floats = Floats()
    try:
        with floats.context():
            return float(read_parameter(parameter, read_expression(text), floats))
    except ExpressionError:
        return float("nan")


def _find_right_scale(motion: Motion, ask: Ask, shape: tuple[int, ...]) -> Any:
    """The scale of the right motion, the first row of all, for the quantity that an ask is of."""
    largest = reduce(np.fmax, list_sizes(motion, ask.unit), np.float64(0))
    return np.broadcast_to(largest, shape)[0]


def _join_ways(
    template: Template, ways: Sequence[Mistake], values: Mapping[str, Any], shape: tuple[int, ...]
) -> Way:
    """All ways through the instances at once, one along the first axis for each."""
    floats = Floats()
    taken = [way.givens(template, values, floats) for way in ways]
    rows = {name: np.stack([np.broadcast_to(one[name], shape) for one in taken]) for name in values}
    column = (len(ways), *(1 for _ in shape))
    thought = {name for way in ways for name in way.shares}
    shares = {
        name: np.array([float(floats.number(way.shares.get(name, 1))) for way in ways]).reshape(
            column
        )
        for name in _SHARES
        if name in thought
    }
    branch, lengths = (
        np.array([getattr(way, name) for way in ways]).reshape(column)
        for name in ("other_branch", "plain_lengths")
    )
    return Way(rows, Slips(**shares), branch, lengths)


def _require_finite(found: Any, shape: tuple[int, ...]) -> Any:
    """An array of that shape, NaN for what is no proper number, zero for what rounding leaves of
    it.
    """
    rows = np.array(np.broadcast_to(found, shape), dtype=float)
    rows[~(np.abs(rows) < _LARGEST)] = np.nan
    rows[np.abs(rows) < SAME] = 0.0
    return rows


def convert_number(number: Any) -> float:
    """A number of any arithmetic as a double, angles in radians."""
    return float(number.ball() if isinstance(number, Angle) else number)


@dataclass(frozen=True)
class Mistakes:
    """What mistakes lead to at one instance, worked out when it is first asked for.

    `values` are the instance's parameters in SI, in any arithmetic.
    """

    template: Template
    asks: Mapping[str, Ask]
    values: Mapping[str, Any]
    plan: Plan

    @cached_property
    def leads(self) -> Mapping[str, Mapping[str, float]]:
        """For each ask and mistake the value in the ask's unit; a mistake without value is not
        there.
        """
        kinds = tuple(find_candidates(self.template, self.asks))
        values = {name: convert_number(self.values[name]) for name in self.template.parameters}
        rows = find_outcomes(self.template, self.asks, kinds, values, self.plan).answers
        return {
            name: {
                kind.identifier: value
                for kind, value in zip((RIGHT, *kinds), rows[name].tolist(), strict=True)
                if isfinite(value)
            }
            for name in self.asks
        }

    def of(self, ask: str, right: float) -> dict[str, float]:
        """The values of an ask that differ from the right one, by the mistakes' identifiers."""
        values = {
            name: value
            for name, value in self.leads[ask].items()
            if name and _differs(value, right)
        }
        written = {
            name: right * convert_number(factor)
            for name, factor in list_answer_factors(self.asks[ask]).items()
            if right
        }
        return {**values, **written}


def _differs(value: float, right: float) -> bool:
    """Whether a value is another one, and not the same one rounded."""
    return abs(value - right) > SAME * max(abs(value), abs(right), 1.0)
