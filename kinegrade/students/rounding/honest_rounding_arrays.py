"""Honest work with rounded numbers for many instances at once: for which of them all answers surely
come out right.

The ways of working are those of `honest_rounding`, in arithmetic that gives every instance what it
gives alone, to the last bit; so it does not matter which instances are looked at together. What is
not settled here, or not right, is left to `find_stray`.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinegrade.expressions.tree import Expression, Operation, walk
from kinegrade.mechanics.motion_arrays import (
    stack_motions,
    stack_numbers,
    stack_vectors,
)
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.rounded_arrays import RoundedArrays
from kinegrade.numbers.tolerance import Tolerance
from kinegrade.problem.quantities.functions import needs_configurations
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.students.rounding.honest_rounding import (
    convert_value,
    work_by_arms,
    work_by_coordinates,
)
from kinegrade.students.rounding.targets import (
    Target,
    find_nearest_turn,
    find_targets,
    list_carried_figures,
    safe_room,
)

_FEW = 4  # so few instances are worked out sooner one by one
_Flags = NDArray[np.bool_]


@dataclass(frozen=True)
class _Instance:
    """An instance solved, and what is right in it."""

    solution: Solution
    targets: Mapping[str, Target]

    @property
    def kind(self) -> Hashable:
        """What instances that are worked out together have in common; the motions of one template
        that have one plan differ in their numbers alone.
        """
        figures = tuple((name, aim.figures) for name, aim in self.targets.items())
        return (
            self.solution.motion.plan,
            tuple(self.solution.assembly.values),
            figures,
        )


def surely_honest(solutions: Sequence[Solution], tolerances: Mapping[str, Tolerance]) -> list[bool]:
    """For each solution of a template whether all honest work surely comes out right; else
    `find_stray` decides.
    """
    sure = [False] * len(solutions)
    if not solutions or not _can_be_stacked(solutions[0].template, solutions[0].answers):
        return sure
    kinds: dict[Hashable, list[int]] = defaultdict(list)
    instances = [_Instance(solution, find_targets(solution, tolerances)) for solution in solutions]
    for place, instance in enumerate(instances):
        kinds[instance.kind].append(place)
    for places in kinds.values():
        for place, flag in zip(
            places, _find_passed([instances[place] for place in places]), strict=True
        ):
            sure[place] = bool(flag)
    return sure


def _can_be_stacked(template: Template, asks: Iterable[str]) -> bool:
    """Whether a template's instances can be worked out together: powers of arrays may differ in the
    last bit, and a centrode is known alone.
    """
    quantities = [template.asks[name].quantity for name in asks]
    sentences = [
        getattr(sentence, part)
        for sentence in (*template.scheme.joints, *template.scheme.drivers)
        for part in ("on", "circle", "velocity", "acceleration", "along")
        if hasattr(sentence, part)
    ]
    trees = (
        *template.scheme.lengths.values(),
        *template.scheme.points.values(),
        *quantities,
        *sentences,
    )
    return not (any(map(_has_power, trees)) or any(map(needs_configurations, quantities)))


def _has_power(tree: Expression | None) -> bool:
    """Whether something in an expression is raised to a power."""
    if tree is None:
        return False
    return any(isinstance(part, Operation) and part.sign == "**" for part in walk(tree))


def _find_passed(instances: Sequence[_Instance]) -> _Flags:
    """Which instances of one kind surely come out right. Where one that is not settled leads to
    what is no number, the others are looked at again without it.
    """
    sure = np.zeros(len(instances), dtype=bool)
    places = np.arange(len(instances))
    while len(places) >= _FEW:
        chosen = [instances[place] for place in places.tolist()]
        settled: _Flags = np.ones(len(places), dtype=bool)
        try:
            for right, arithmetic in _judge_ways(chosen):
                settled &= right & ~arithmetic.unsettled
        except FloatingPointError as error:
            doubtful = getattr(error, "unsettled", None)
            if doubtful is None or not doubtful.any():
                return sure
            places = places[~doubtful]
            continue
        sure[places] = settled
        return sure
    return sure


def _judge_ways(instances: Sequence[_Instance]) -> Iterator[tuple[_Flags, RoundedArrays]]:
    """For every way of working the instances in which all answers are right, and its arithmetic.

    Raises FloatingPointError with the instances that are `unsettled` so far.
    """
    whole = _stack_solutions([instance.solution for instance in instances])
    aims = {
        name: [instance.targets[name] for instance in instances] for name in instances[0].targets
    }
    for figures, every in list_carried_figures(instances[0].targets):
        concerned = {
            name: same for name, same in aims.items() if same[0].figures in (figures, figures - 1)
        }
        for sparing, by in ((False, "arms"), (True, "arms"), (False, "coordinates"))[
            : 3 if every else 1
        ]:
            arithmetic = RoundedArrays(figures, len(instances), sparing=sparing)
            try:
                with arithmetic.context():
                    worked = (
                        work_by_arms(whole, whole.motion, arithmetic)
                        if by == "arms"
                        else work_by_coordinates(whole, arithmetic)
                    )
            except FloatingPointError as error:
                error.unsettled = arithmetic.unsettled  # type: ignore[attr-defined]
                raise
            yield (
                np.all(
                    [
                        _find_met(same, worked.get(name), figures)
                        for name, same in concerned.items()
                    ],
                    axis=0,
                ),
                arithmetic,
            )


def _find_met(aims: Sequence[Target], worked: Any, figures: int) -> _Flags:
    """Where an answer is right, as it came out and however it is written; next to its bounds one by
    one.
    """
    if worked is None:
        return np.zeros(len(aims), dtype=bool)
    worked = np.broadcast_to(worked, len(aims))
    low, high, exact = np.array([(aim.low, aim.high, aim.exact) for aim in aims]).T
    near, room = find_nearest_turn(worked, exact, aims[0].turn), safe_room(np.abs(worked), figures)
    right: _Flags = (low + room <= near) & (near <= high - room)
    for place in np.flatnonzero(~right).tolist():
        right[place] = aims[place].met(float(worked[place]), figures)
    return right


def _stack_solutions(solutions: Sequence[Solution]) -> Solution:
    """The solutions, in doubles, as one whose numbers are arrays; answers are the first one's."""
    first = solutions[0]
    values = {
        name: _stack_values(
            [convert_value(solution.assembly.values[name]) for solution in solutions]
        )
        for name in first.assembly.values
    }
    return replace(
        first,
        motion=stack_motions([solution.doubles for solution in solutions]),
        assembly=replace(first.assembly, values=values),
    )


def _stack_values(values: Sequence[Any]) -> Any:
    """Numbers, points or words (which are the same in all) as one."""
    if isinstance(values[0], str):
        return values[0]
    return stack_vectors(values) if isinstance(values[0], Vector) else stack_numbers(values)
