"""Follow-through, for every template: the plan run on from own answers gives what the same errors
lead to.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import cache
from typing import Any

import pytest

from kinegrade.errors import MechanismError
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.numbers.doubles import convert_number
from kinegrade.numbers.elimination import Singular
from kinegrade.numbers.floats import Floats
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.students.following.connections import (
    choose_generic_values,
    find_connections,
    find_generic_plan,
    find_stages,
)
from kinegrade.students.following.follow_through import Follower, follow_through
from kinegrade.students.following.followed_quantities import (
    find_calls,
    find_level,
    find_name,
    find_share,
)
from kinegrade.students.mistaking.mistake_kinds import MISTAKES, Mistake
from kinegrade.students.mistaking.mistaken import make_mistaken_motion
from kinegrade.students.mistaking.mistakes import Mistakes
from kinegrade.students.mistaking.slips import Slips
from tests.laws.cases import moving_templates

MOVING = moving_templates()
POLES = {"wrong-pole", "centre-for-pole", "transport-for-absolute"}  # slips in the velocities alone
TERMS = {"coriolis-halved", "coriolis-reversed"}  # slips in the Coriolis terms alone
Answers = dict[str, float]


@cache
def followers(name: str) -> tuple[Follower, ...]:
    """Two instances of a template, drawn at large."""
    template, plan = load_template(name), find_generic_plan(load_template(name))
    found = []
    for number in range(1, 8):
        follower = Follower(template, choose_generic_values(template, number), plan)
        with suppress(MechanismError):
            if follower.right_motion is not None and len(found) < 2:
                found.append(follower)
    return tuple(found)


def near(found: float | None, expected: float) -> bool:
    return found is not None and abs(found - expected) <= 1e-9 * max(abs(expected), 1e-3)


@pytest.mark.parametrize("name", MOVING)
def test_from_the_right_answers_the_right_ones_follow(name: str) -> None:
    template = load_template(name)
    solution = solve_template(template, {})
    values = {
        given: convert_number(solution.assembly.values[given]) for given in template.parameters
    }
    right = {
        ask: answer.value for ask, answer in solution.answers.items() if not answer.at_infinity
    }
    answered = {ask: value for ask, value in right.items() if abs(value) > 1e-9}
    follower = Follower(template, values, solution.motion.plan)
    for ask, value in right.items():
        assert near(follower.right(ask), value), ask
        for other, own in answered.items():
            found = follower.consequences({other: own}, ask)
            assert all(near(each, value) for each in found), (other, ask)


def asked_of(follower: Follower) -> Iterator[tuple[str, Any]]:
    """The asks that are read off one moving thing, with what they call."""
    for ask, quantity in follower.quantities.items():
        calls = set(find_calls(quantity))
        if len(calls) == 1:
            yield ask, calls.pop()


def rates_asked_for(follower: Follower) -> dict[Rate, str]:
    """For the rates of the plan that an ask is about, and about nothing else, that ask."""
    motion, found = follower.equations.right, {}
    for ask, call in asked_of(follower):
        parts = [find_name(argument) for argument in call.arguments]
        if call.function == "omega" and len(parts) == 1:
            found[make_turning(parts[0])] = ask
        elif call.function == "relative_velocity":
            term = motion.reading.find_relative(parts[0], parts[2])
            if term:
                found[term.rate] = ask
        elif call.function == "velocity":
            chain = motion.chain(*follower.place(call))  # type: ignore[misc]
            if len(chain) == 1:
                found[chain[0].rate] = ask
    return found


def led_by_velocities(follower: Follower, mistake: Mistake, leads: Answers) -> Answers | None:
    """The answers through which alone a mistake in the velocities goes on: asks of all the rates
    that it changes.
    """
    floats, asked, right = Floats(), rates_asked_for(follower), follower.right_motion
    shares = {name: float(floats.number(share)) for name, share in mistake.shares.items()}
    with floats.context():
        try:
            wrong = make_mistaken_motion(
                follower.assembly.mechanism, floats, follower.plan, Slips(**shares)
            ).rates
        except Singular:
            return None
    rates = right.rates  # type: ignore[union-attr]
    if any(near(rates[rate], 0.0) and not near(float(value), 0.0) for rate, value in wrong.items()):
        return None  # no share of nothing
    changed = {
        rate: float(value) / rates[rate]
        for rate, value in wrong.items()
        if rates[rate] and not near(float(value), rates[rate])
    }
    led = {asked[rate]: leads.get(asked[rate], 0.0) for rate in changed if rate in asked}
    seen = all(
        near(leads.get(asked[rate], 0.0), ratio * (follower.right(asked[rate]) or 0.0))
        for rate, ratio in changed.items()
        if rate in asked and ratio > 1e-9
    )
    return (
        led
        if seen and len(led) == len(changed) and all(ratio > 1e-9 for ratio in changed.values())
        else None
    )


def led_by_coriolis(follower: Follower, leads: Answers) -> Answers | None:
    """The Coriolis accelerations through which alone a mistake in them goes on: all that the
    relations hold.
    """
    relations = follower.still.frames.relations
    terms = {
        (term.point, term.frame)
        for relation in relations
        for term in (*relation.left, *relation.right)
        if term.frame != GROUND
    }
    asked = {
        (find_name(call.arguments[0]), find_name(call.arguments[2])): ask
        for ask, call in asked_of(follower)
        if call.function == "coriolis"
    }
    if not terms <= asked.keys() or any(relation.frame != GROUND for relation in relations):
        return None
    return {asked[term]: leads[asked[term]] for term in terms}


def compared(follower: Follower) -> Iterator[tuple[str, str, tuple[float, ...], float, float]]:
    """Mistake, later ask, what follows from the mistaken earlier answers, what the mistake leads
    to, what is right.
    """
    all_leads = Mistakes(
        follower.template, follower.template.asks, follower.values, follower.plan
    ).leads
    for mistake in (each for each in MISTAKES if each.identifier in POLES | TERMS):
        leads = {
            ask: values[mistake.identifier]
            for ask, values in all_leads.items()
            if mistake.identifier in values
        }
        led = (
            led_by_velocities(follower, mistake, leads)
            if mistake.identifier in POLES
            else led_by_coriolis(follower, leads)
            if leads
            else None
        )
        if not led or any(near(value, follower.right(ask) or 0.0) for ask, value in led.items()):
            continue  # nothing to go on from, or a mistake that an unsigned answer does not show
        for later, call in asked_of(follower):
            read_with_slip = (
                mistake.identifier == "transport-for-absolute"
                and call.function.startswith("relative")
            )
            if (
                find_level(call) == "acceleration"
                and not find_share(call)
                and not read_with_slip
                and later in leads
            ):
                yield (
                    mistake.identifier,
                    later,
                    follower.consequences(led, later),
                    leads[later],
                    follower.right(later) or 0.0,
                )


def test_what_follows_from_a_mistaken_answer_is_what_the_mistake_leads_to() -> None:
    agreeing: dict[str, int] = {}
    templates = set()
    for follower in (each for name in MOVING for each in followers(name)):
        for mistake, later, found, expected, right in compared(follower):
            where = follower.template.name, mistake, later
            if near(expected, right) or near(expected, 0.0):
                continue  # does not depend on it, or vanishes
            assert any(near(value, expected) for value in found), where
            agreeing[mistake] = agreeing.get(mistake, 0) + 1
            templates.add(follower.template.name)
    assert len(templates) >= 20
    assert sum(agreeing.values()) >= 250
    assert min(agreeing[name] for name in (*TERMS, "wrong-pole", "transport-for-absolute")) >= 10


def crank(**earlier: float) -> Mapping[str, tuple[float, ...]]:
    """What may follow in a slider-crank at 60 degrees with AB at a right angle to OA: omega_AB is
    1/3, v_B 2/sqrt 3, a_B -2/9.
    """
    template = load_template("slider-crank")
    values = solve_template(template, {}).assembly.values
    given = {name: values[name] for name in template.parameters}
    return {later: follow_through(template, given, earlier, later) for later in template.asks}


def follows(found: tuple[float, ...], *expected: float) -> bool:
    return all(any(near(value, each) for value in found) for each in expected)


def test_a_slider_crank_worked_out_by_hand() -> None:
    # With an own omega: alpha = (1 - omega^2)/sqrt 3 and a_B = -2 omega^2; v_B = v_A + omega x AB
    # is sqrt 3/2 + omega sqrt 3/2 along the guide, and 2 sqrt 3 omega by the pole
    for omega in (0.5, -0.4, 1.0):
        found = crank(omega_AB=omega)
        assert follows(found["a_B"], -2 * omega**2)
        speeds = (abs(3**0.5 / 2 * (1 + omega)), abs(2 * 3**0.5 * omega))
        assert follows(found["v_B"], *speeds)
        assert found["omega_AB"] == ()
        if omega != 1:
            assert follows(found["alpha_AB"], (1 - omega**2) / 3**0.5)
    # With an own v_B: its third, from the pole
    assert follows(crank(v_B=3.0)["omega_AB"], 3.0 / 2 / 3**0.5)


def test_an_acceleration_worked_out_by_hand() -> None:
    # along the guide a_B = -1/2 + alpha sqrt 3/2 - omega^2 3/2, with omega = 1/3
    assert follows(crank(alpha_AB=2.0)["a_B"], -0.5 + 3**0.5 - 1 / 6)


def test_nothing_follows_from_nothing_or_where_that_would_vanish() -> None:
    assert set(crank(omega_AB=0.0).values()) == {()}
    assert set(crank().values()) == {()}
    assert not follows(crank(omega_AB=1.0)["alpha_AB"], 0.0)  # 1 - omega^2


def test_nothing_follows_in_a_pose_or_where_the_configuration_cannot_be() -> None:
    pose = load_template("pose-cam-tappet")
    values = choose_generic_values(pose, 0)
    asks = list(pose.asks)
    assert follow_through(pose, values, {asks[0]: 1.0}, asks[1]) == ()
    template = load_template("slider-crank")
    impossible = {**choose_generic_values(template, 0), "k": 0.1}
    assert follow_through(template, impossible, {"omega_AB": 1.0}, "a_B") == ()


def edges(name: str) -> set[tuple[str, str]]:
    """The pairs of asks of which the second follows from the first."""
    template = load_template(name)
    found = find_connections(template, list(template.asks))
    return {(earlier, later) for later, others in found.items() for earlier in others}


def test_relative_speed_of_two_points_of_a_body_is_its_rotation() -> None:
    assert ("omega_AB", "v_BA") in edges("elliptic-trammel-end-driven")


def test_which_asks_are_connected() -> None:
    rocker = edges("slotted-rocker-and-slider-two-drivers")
    assert {("v_rel", "a_cor"), ("a_cor", "alpha_AB"), ("omega_AB", "alpha_AB")} <= rocker
    assert not [
        pair for pair in rocker if pair[0].startswith("a") and pair[1].startswith(("v", "o"))
    ]
    assert edges("pose-cam-tappet") == set()


def test_the_plan_comes_to_velocities_first() -> None:
    template = load_template("slotted-rocker-and-slider-two-drivers")
    asks = ("alpha_AB", "a_cor", "v_rel", "omega_AB")
    assert find_stages(template, asks) == [["v_rel", "omega_AB"], ["a_cor"], ["alpha_AB"]]
