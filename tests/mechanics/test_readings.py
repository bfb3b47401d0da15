"""The plain reading takes everything as it is; others change what is taken, never the motion."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.relations.reading import PLAIN, Reading
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.numbers.doubles import Doubles
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.students.following.departures import state_equations
from kinegrade.students.following.followed import follow_values
from kinegrade.students.following.own_values import OwnValue
from kinegrade.students.mistaking.mistaken_reading import read_with_slips
from kinegrade.students.mistaking.slips import Slips

NAMES = ("slider-crank", "pin-in-two-rings", "rolling-wheel-rim-points")


@pytest.mark.parametrize("name", NAMES)
def test_slips_of_which_none_is_made_leave_every_term_as_it_is(name: str) -> None:
    motion = solve_template(load_template(name), {}).motion
    reading = read_with_slips(motion.frames, Slips(), motion.plan, Doubles())
    for relation in motion.frames.relations:
        assert reading.relation(relation) == PLAIN.relation(relation) == relation
        for term in (*relation.left, *relation.right):
            for taken, plain in zip(parts(term, motion, reading), parts(term, motion), strict=True):
                assert taken == plain


def parts(term: Term, motion: Motion, reading: Reading = PLAIN) -> Iterator[Vector]:
    yield term.velocity(motion.rates)
    yield term.normal(motion.rates, reading)
    yield term.coriolis(motion.rates, reading)
    yield term.acceleration(motion.rates, motion.changes, reading)


def test_a_motion_is_not_changed_by_those_who_read_it_otherwise() -> None:
    motion = solve_template(load_template("slider-crank"), {}).doubles
    before = dict(motion.rates), dict(motion.changes), motion.frames
    speed = OwnValue(lambda other: float(other.velocity("A", "OA").x), 2.0, "velocity", ("OA", "A"))
    equations = state_equations(motion.frames, motion.plan, [("OA", "A")])
    (followed, *_) = follow_values(equations, [speed])
    assert followed.frames is motion.frames
    assert (dict(motion.rates), dict(motion.changes), motion.frames) == before
    assert followed.velocity("A", "OA").x == pytest.approx(2.0)
    assert motion.velocity("A", "OA").x != pytest.approx(2.0)


def test_a_mapped_motion_is_read_as_the_first_one_is() -> None:
    template = load_template("slider-crank")
    right = solve_template(template, {}).doubles
    (motion, *_) = follow_values(state_equations(right.frames, right.plan, []), [])
    assert motion.map(abs).reading is motion.reading
