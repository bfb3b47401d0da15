"""What known mistakes lead to, for the answers of one instance or of thousands: the same plan, run
on after each.

All mistakes of all instances go through one run, `find_outcomes`; `work_out` follows a single one
in any arithmetic, and tests hold the one against the other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import isfinite
from typing import Any

import numpy as np

from kinegrade.errors import ExpressionError
from kinegrade.expressions.reading import read_expression
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.doubles import convert_number
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.assembling.parameters import read_parameter
from kinegrade.problem.template.template import Ask, Parameter, Template
from kinegrade.students.mistaking.mistake_kinds import Mistake, find_candidates
from kinegrade.students.mistaking.mistake_outcomes import RIGHT, SAME, find_outcomes
from kinegrade.students.mistaking.mistaken_answers import Way, solve_mistaken
from kinegrade.students.mistaking.slips import Slips
from kinegrade.students.mistaking.written_mistakes import list_answer_factors

Values = Mapping[str, Sequence[str]]  # for each parameter the texts of an array of instances


def work_out(
    template: Template, asks: Mapping[str, Ask], way: Way, plan: Plan, arithmetic: Arithmetic
) -> dict[str, Any]:
    """The answers in the asks' units, without those that the mistake leaves without a value. Raises
    as `solve_mistaken`.
    """
    reader = solve_mistaken(template, way, plan, arithmetic)
    found = {name: reader.answer(ask, arithmetic) for name, ask in asks.items()}
    return {name: value for name, value in found.items() if value is not None}


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
        mistake.steps,
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
            **dict(zip((kind.label for kind in kinds), rows[name][1:], strict=True)),
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
                kind.label: value
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
