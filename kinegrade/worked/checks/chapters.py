"""The check at the end of a chapter."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import assert_never

from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.template.template import Ask
from kinegrade.worked.case import Case
from kinegrade.worked.checks.bodies import list_body_checks, list_new_body_checks
from kinegrade.worked.checks.carriers import list_carrier_checks
from kinegrade.worked.checks.check import Check, choose_check
from kinegrade.worked.checks.constraints import list_constraint_checks
from kinegrade.worked.checks.forms import Told, list_rates, list_solved
from kinegrade.worked.checks.laws.carried import list_carried_checks
from kinegrade.worked.checks.laws.pole_accelerations import list_pole_accelerations
from kinegrade.worked.checks.laws.relative_poles import list_relative_poles
from kinegrade.worked.checks.laws.turns import list_turn_checks
from kinegrade.worked.checks.laws.wheels import list_wheel_checks
from kinegrade.worked.checks.positions.places import list_place_checks
from kinegrade.worked.checks.positions.poles import list_pole_checks
from kinegrade.worked.checks.positions.sleeves import list_sleeve_checks
from kinegrade.worked.checks.second_derivatives import list_second_derivatives
from kinegrade.worked.checks.seen import list_seen_checks
from kinegrade.worked.checks.theorems import list_theorem_checks
from kinegrade.worked.checks.tracks import list_track_checks
from kinegrade.worked.document import Block
from kinegrade.worked.findings import Checked
from kinegrade.worked.vectors.needed_rates import find_needs, find_references
from kinegrade.worked.vectors.stage import Stage


def check_rates(
    stages: Mapping[Step, Stage], asked: Sequence[Ask], level: Level, case: Case, *, last: bool
) -> Iterator[Block]:
    """The check of a chapter that goes by another way than its steps, of those that there are the
    one that takes up most of what is asked; where all of them say again what a step has, one by
    another law, or in the last chapter, where none has had a check, one by positions.
    """
    if case.findings.places_alone:
        yield from _say_first(list_pole_checks(stages.values(), case), case)
        return
    solved = [form for item in stages.items() for form in list_solved(*item)]
    sought, told = _find_sought(asked, case), Told.by(solved, case.held_rates)
    groups = (_list_rate_checks(stages, level, case, told), list_body_checks(level, case))
    found = (sought.choose(group, told) for group in groups)
    chosen = next(filter(None, found), None)
    if chosen is not None:
        case.findings.checked.append(Checked(chosen.form, tuple(solved)))
        yield from chosen.say(case)
    else:
        yield from _say_first(_list_laws(level, case), case)
    if last and not case.findings.is_checked:
        yield from _say_first(_list_differentiated(stages, case), case)


def _list_laws(level: Level, case: Case) -> Iterator[Check]:
    """The checks by another law than the steps'."""
    match level:
        case "velocity":
            return _list_other_laws(case)
        case "acceleration":
            return list_pole_accelerations(case)
        case _:
            assert_never(level)


def check_places(asked: Sequence[Ask], case: Case) -> Iterator[Block]:
    """The check of answers that positions alone decide."""
    yield from _say_first(list_place_checks(asked, case), case)


def _say_first(checks: Iterable[Check], case: Case) -> Iterator[Block]:
    """The first short check of places, if there is one."""
    chosen = choose_check(checks)
    if chosen is not None:
        yield from chosen.say(case)


def _list_other_laws(case: Case) -> Iterator[Check]:
    """The checks of velocities by laws that no step has gone by."""
    yield from list_sleeve_checks(case)
    yield from list_turn_checks(case)
    yield from list_relative_poles(case)
    yield from list_carried_checks(case)
    yield from list_wheel_checks(case)


def _list_differentiated(stages: Mapping[Step, Stage], case: Case) -> Iterator[Check]:
    """The checks by positions, in coordinates, of what projections and angles have given."""
    for stage in reversed(tuple(stages.values())):
        for check in list_constraint_checks(stage, Told((), case.held_rates)):
            if list_rates(check.form):
                yield check


def _list_rate_checks(
    stages: Mapping[Step, Stage], level: Level, case: Case, told: Told
) -> Iterator[Check]:
    """All checks that a chapter has the numbers for, those of the last step first; most of those by
    constraints say what is told, which are left out.
    """
    last_first = tuple(reversed(tuple(stages.items())))
    for step, stage in last_first:
        yield from list_theorem_checks(step, stage)
    for step, stage in last_first:
        yield from list_track_checks(step, stage)
    yield from list_carrier_checks(level, case)
    for _, stage in last_first:
        yield from list_constraint_checks(stage, told)
    yield from list_new_body_checks(level, case)
    match level:
        case "velocity":
            yield from list_seen_checks(case)
        case "acceleration":
            yield from list_second_derivatives(stage for _, stage in last_first)
        case _:
            assert_never(level)


@dataclass(frozen=True)
class _Sought:
    """What is asked for: rates, and the motions of points."""

    rates: Collection[Rate]
    points: Collection[str]

    def choose(self, checks: Iterable[Check], told: Told) -> Check | None:
        """The check that serves best, of those that tell something, do not hold whatever the rates
        are, and have not been told.
        """
        others = (one for one in checks if not told.says(one.form) and one.is_telling)
        return max(others, key=self._rank, default=None)

    def _rank(self, check: Check) -> tuple[int, int]:
        """With much of what is asked and read at a glance, with all digits."""
        met = len(list_rates(check.form) & {*self.rates}) + len(check.points & {*self.points})
        return met - (not check.is_short), check.digits


def _find_sought(asked: Sequence[Ask], case: Case) -> _Sought:
    calls = [call for ask in asked for call in find_motion_calls(ask.quantity)]
    points = {point for call in calls for _, point in find_references(call, case.reader).points}
    rates = {rate for ask in asked for rate in find_needs(ask.quantity, case.reader).rates}
    return _Sought(rates, points)
