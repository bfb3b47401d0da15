"""The answers of one way through an instance that a mistake takes, or of many at once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from flint import arb, fmpq
from msgspec.structs import replace

from kinegrade.errors import AtInfinity, KinegradeError
from kinegrade.expressions.evaluation import evaluate
from kinegrade.expressions.tree import Expression
from kinegrade.mechanics.configuration import require_assembled
from kinegrade.mechanics.geometry import Round
from kinegrade.mechanics.motion import Motion, pose_mechanism, solve_motion
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.assembling.assemble import Assembly, assemble
from kinegrade.problem.centrode import Centrodes, find_circle
from kinegrade.problem.quantities.functions import make_quantities
from kinegrade.problem.quantities.reader import find_body_names
from kinegrade.problem.template.template import Ask, Template
from kinegrade.students.mistaking.mistaken import make_mistaken_motion
from kinegrade.students.mistaking.slips import Slips


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
    branch, the units; and what steps are taken for.
    """

    values: Mapping[str, Any]
    slips: Slips
    other_branch: Any = False
    plain_lengths: Any = False
    steps: Mapping[str, Expression] = field(default_factory=dict)


def solve_mistaken(
    template: Template, way: Way, plan: Plan, arithmetic: Arithmetic, *, perturbed: bool = False
) -> _Reader:
    """The motion as it comes out that way, to be read off; `perturbed` as `mistaken` takes it.

    Raises MechanismError or Singular where there is none, Inexact and Undecided as the arithmetic
    does.
    """
    template = _mistake_steps(template, way.steps)
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


def _mistake_steps(template: Template, steps: Mapping[str, Expression]) -> Template:
    """The template with steps taken for something else."""
    taken = {**template.scheme.steps, **steps}
    return replace(template, scheme=replace(template.scheme, steps=taken)) if steps else template


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
        converted = number / arithmetic.scale(ask.unit.scale)
        return (
            arithmetic.choose(self.plain_lengths, number, converted)
            if ask.unit.length
            else converted
        )
