"""The plan: the textbook's order, in which each step is the smallest set of relations determined by
what is known.

One vector equation with two unknowns where possible, two or three together only where nothing
smaller works. The plan is structure: it is found once at one configuration, and run in any
arithmetic, for velocities and then, with the same coefficients, for accelerations.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.number import Number, Solver

Row = Mapping[Rate, Number]
Equations = Sequence[Sequence[Row]]
_MAX_TOGETHER = 3


@dataclass(frozen=True)
class Step:
    """The relations (by index) solved together and the rates they give; no rates: a surplus
    relation, which is checked.
    """

    relations: tuple[int, ...]
    unknowns: tuple[Rate, ...]


@dataclass(frozen=True)
class Plan:
    """The steps in order."""

    steps: tuple[Step, ...]


def find_plan(relations: Sequence[Relation], equations: Equations, arithmetic: Solver) -> Plan:
    """The plan at this configuration. Raises Singular when the relations leave something
    undetermined.
    """
    known: set[Rate] = set()
    pending = list(range(len(relations)))
    steps: list[Step] = []
    while pending:
        step = next(_find_determined(relations, equations, pending, known, arithmetic), None)
        if step is None:
            raise Singular
        steps.append(step)
        known.update(step.unknowns)
        pending = [index for index in pending if index not in step.relations]
    return Plan(tuple(steps))


def _find_determined(
    relations: Sequence[Relation],
    equations: Equations,
    pending: Sequence[int],
    known: set[Rate],
    arithmetic: Solver,
) -> Iterator[Step]:
    """The sets of pending relations that determine their unknowns, the smallest first."""
    open_rates = {
        index: [rate for rate in relations[index].unknowns() if rate not in known]
        for index in pending
    }
    sizes = [*range(1, min(_MAX_TOGETHER, len(pending)) + 1), len(pending)]
    for group in (group for size in sizes for group in combinations(pending, size)):
        unknowns = tuple(dict.fromkeys(rate for index in group for rate in open_rates[index]))
        rows = [row for index in group for row in equations[index]]
        if len(unknowns) <= len(rows) and _has_full_rank(rows, unknowns, arithmetic):
            yield Step(group, unknowns)


def _has_full_rank(rows: Sequence[Row], unknowns: Sequence[Rate], arithmetic: Solver) -> bool:
    """Whether the rows determine the unknowns."""
    if not unknowns:
        return True
    try:
        arithmetic.solve([[row.get(rate, 0) for rate in unknowns] for row in rows], [0] * len(rows))
    except Singular:
        return False
    return True


def run_steps(
    plan: Plan, equations: Equations, right: Sequence[Sequence[Number]], arithmetic: Solver
) -> dict[Rate, Number]:
    """The rates that the plan gives; `right` gives a relation's right-hand sides.

    Raises Singular at a dead point of a step, Contradiction when surplus equations do not agree.
    """
    rates: dict[Rate, Number] = {}
    for step in plan.steps:
        rates.update(solve_step(step, equations, right, rates, arithmetic))
    return rates


def solve_step(
    step: Step,
    equations: Equations,
    right: Sequence[Sequence[Number]],
    known: Mapping[Rate, Number],
    arithmetic: Solver,
) -> dict[Rate, Number]:
    """The rates that one step gives from those that are known; a surplus relation is checked.

    Raises as `run_steps`.
    """
    rows = [row for index in step.relations for row in equations[index]]
    sides = [
        side - sum((row[rate] * known[rate] for rate in row if rate in known), 0)
        for row, side in zip(rows, (s for i in step.relations for s in right[i]), strict=True)
    ]
    if step.unknowns:
        matrix = [[row.get(rate, 0) for rate in step.unknowns] for row in rows]
        return dict(zip(step.unknowns, arithmetic.solve(matrix, sides), strict=True))
    for side in sides:
        arithmetic.require_zero(side)
    return {}
