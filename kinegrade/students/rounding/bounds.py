"""How far off a student may be who works correctly and writes every value down rounded: a bound for
every instance, whatever the roundings come to; and the largest term that goes into an answer.

Every operation of `working` is written down. Textbooks also add the terms of a velocity or an
acceleration in another order, over other arms; a partial sum is then as large as the largest term,
at most, and half a unit of that is allowed for, twice.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import inf
from typing import Any

import numpy as np

from kinegrade.errors import KinegradeError
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.noting.noting import Noting
from kinegrade.numbers.noting.pad import DEGREE, Doubles, Noted, Pad, Swept
from kinegrade.problem.template.template import Ask, Template
from kinegrade.students.mistaking.mistake_outcomes import find_outcomes
from kinegrade.students.rounding.rounding import Rounding
from kinegrade.students.rounding.working import Working

_LEFT = 1e-8  # of the scale, at least: what a calculator leaves of a zero, 6e-17, is right


def find_roundings(
    template: Template,
    asks: Mapping[str, Ask],
    values: Mapping[str, Any],
    plan: Plan,
    carry: int,
) -> dict[str, Rounding[Doubles]]:
    """For every ask how far off an answer may be and what its largest term is, in an array of
    instances, where `carry` significant figures are written of everything.

    `values` are the parameters in SI, arrays of instances. The bound is infinite where an instance
    cannot be worked out. To first order in the roundings. An answer that is known in closed form
    is not worked out: its largest term is the mechanism's scale.
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
            return dict.fromkeys(asks, Rounding(np.full(pad.count, inf), np.zeros(pad.count)))
        noted = {
            name: _hand_in(number, asks[name])
            for name, number in found.items()
            if isinstance(number, Noted)
        }
        swept = pad.sweep_back(tuple(noted.values()))
        rows = {name: row for row, name in enumerate(noted)}
        outcomes = find_outcomes(template, asks, (), values, plan)
        scales = {name: np.nan_to_num(scale) for name, scale in outcomes.scales.items()}
        return {
            name: _round_swept(pad, ask, swept, rows[name], scales[name])
            if name in rows
            else Rounding(np.zeros(pad.count), scales[name])
            for name, ask in asks.items()
        }


def _hand_in(number: Noted, ask: Ask) -> Noted:
    """An answer as it is handed in."""
    if number.angle and not ask.unit.degrees:
        return number.convert_angle(Floats().scale(ask.unit.scale))
    return number


def _round_swept(pad: Pad, ask: Ask, swept: Swept, row: int, scale: Doubles) -> Rounding[Doubles]:
    """The rounding of an answer that was worked out on the pad."""
    bound = _convert(swept.errors[row], ask)
    largest = np.clip(_convert(swept.terms[row], ask), _LEFT * scale, scale)
    return Rounding(bound + pad.find_unit(largest) if _is_sum(ask) else bound, largest)


def _is_sum(ask: Ask) -> bool:
    """Whether an ask is of a velocity or an acceleration."""
    return bool(ask.unit.length and ask.unit.time)


def _convert(error: Doubles, ask: Ask) -> Doubles:
    """An error in SI in the unit of an ask; infinite where there is none."""
    size = DEGREE if ask.unit.degrees else Floats().scale(ask.unit.scale)
    return np.where(np.isfinite(error), error / size, inf)
