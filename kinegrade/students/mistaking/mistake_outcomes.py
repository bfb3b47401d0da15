"""What all mistakes of many instances lead to, in one run in doubles."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import reduce
from typing import Any

import numpy as np

from kinegrade.errors import KinegradeError
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.floats import Floats
from kinegrade.problem.scale import list_sizes
from kinegrade.problem.template.template import Ask, Template
from kinegrade.students.mistaking.mistake_kinds import Mistake
from kinegrade.students.mistaking.mistaken_answers import Way, solve_mistaken
from kinegrade.students.mistaking.slips import Slips

RIGHT = Mistake("")
SAME = 1e-9  # relative, below one absolute: closer than this a value is not changed, only rounded
_LARGEST = 1e9  # in the ask's unit: what is larger is a division by zero that rounding hides
_SHARES = tuple(field.name for field in fields(Slips))


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
    ways = (RIGHT, *mistakes)
    joined = _find_joined(
        template, asks, [way for way in ways if not way.steps], values, plan, perturbed=perturbed
    )
    if all(not way.steps for way in ways):
        return joined
    apart = [
        _find_joined(template, asks, [way], values, plan, perturbed=perturbed).answers
        for way in ways
        if way.steps
    ]
    answers = {}
    for name, rows in joined.answers.items():
        together, own = iter(rows), (one[name][0] for one in apart)
        answers[name] = np.stack([next(own if way.steps else together) for way in ways])
    return replace(joined, answers=answers)


def _find_joined(
    template: Template,
    asks: Mapping[str, Ask],
    ways: Sequence[Mistake],
    values: Mapping[str, Any],
    plan: Plan,
    *,
    perturbed: bool,
) -> Outcomes:
    """What several ways lead to, in one run, a row for each; a way that takes steps for something
    else goes alone.
    """
    floats = Floats()
    shape = np.broadcast_shapes(*(np.shape(value) for value in values.values()))
    nothing = np.full(shape, np.nan)
    with floats.context():
        way = _join_ways(template, ways, values, shape)
        try:
            reader = solve_mistaken(template, way, plan, floats, perturbed=perturbed)
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
    return Way(rows, Slips(**shares), branch, lengths, ways[0].steps)


def _require_finite(found: Any, shape: tuple[int, ...]) -> Any:
    """An array of that shape, NaN for what is no proper number, zero for what rounding leaves of
    it.
    """
    rows = np.array(np.broadcast_to(found, shape), dtype=float)
    rows[~(np.abs(rows) < _LARGEST)] = np.nan
    rows[np.abs(rows) < SAME] = 0.0
    return rows
