"""How far off a student may be who works correctly and writes every value down rounded: a bound for
every instance, whatever the roundings come to.

Every operation of `working` is written down. Textbooks also add the terms of a velocity or an
acceleration in another order, over other arms; a partial sum is then as large as the largest one in
the mechanism, at most, and half a unit of that is allowed for, twice.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from kinegrade.errors import KinegradeError
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.noting import Noting
from kinegrade.numbers.pad import DEGREE, Doubles, Noted, Pad
from kinegrade.problem.template.template import Ask, Template
from kinegrade.students.mistaking.mistake_outcomes import find_outcomes
from kinegrade.students.rounding.working import Working


def find_error_bounds(
    template: Template,
    asks: Mapping[str, Ask],
    values: Mapping[str, Any],
    plan: Plan,
    carry: int,
) -> dict[str, Doubles]:
    """For every ask how far off an answer may be, in its unit, in an array of instances, where
    `carry` significant figures are written of everything.

    `values` are the parameters in SI, arrays of instances. Infinite where an instance cannot be
    worked out. To first order in the roundings.
    """
    pad = Pad(carry, np.size(next(iter(values.values()), 0.0)))
    arithmetic = Noting(pad)
    with arithmetic.context():
        given = {
            name: pad.write(value, angle=template.parameters[name].unit.degrees)
            for name, value in values.items()
        }
        try:
            found = Working(arithmetic).answer(template, asks, given, plan)
        except (KinegradeError, Singular):
            return dict.fromkeys(asks, np.full(pad.count, np.inf))
        noted = {name: number for name, number in found.items() if isinstance(number, Noted)}
        errors = dict(zip(noted, pad.sum_errors(tuple(noted.values())), strict=True))
        scales = find_outcomes(template, asks, (), values, plan).scales
        sums = {name: pad.find_unit(scales[name]) for name in noted if _is_sum(asks[name])}
    return {
        name: _convert(errors[name], ask) + sums.get(name, 0.0)
        if name in errors
        else np.zeros(pad.count)
        for name, ask in asks.items()
    }


def _is_sum(ask: Ask) -> bool:
    """Whether an ask is of a velocity or an acceleration."""
    return bool(ask.unit.length and ask.unit.time)


def _convert(error: Doubles, ask: Ask) -> Doubles:
    """An error in SI in the unit of an ask; infinite where there is none."""
    size = DEGREE if ask.unit.degrees else Floats().scale(ask.unit.scale)
    return np.where(np.isfinite(error), error / size, np.inf)
