"""No rounding puts an answer further off than the bound says: ten thousand students of each
instance, who are off by anything within half a unit of every value they write down.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, radians, sin

import numpy as np
import pytest

from benchmarks.jotting import Jotting, plain
from kinegrade.draws.deck import make_deck
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.units import Unit
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.template import Template
from kinegrade.students.following.connections import find_generic_plan
from kinegrade.students.mistaking.mistake_outcomes import find_outcomes
from kinegrade.students.mistaking.mistakes import convert_parameters
from kinegrade.students.rounding.bounds import find_error_bounds
from kinegrade.students.rounding.working import Working
from kinegrade.students.separation import collect_columns, measure_distance

STUDENTS = 10_000
# Of the bound, to first order, that second orders may exceed
FIRST_ORDER = 1.02
# Of the answers: where they may be further off, second orders count
WELL = 0.25


def find_plan(template: Template) -> Plan:
    """The plan; none for a pose."""
    return find_generic_plan(template) or Plan(())


def work_at_random(
    template: Template, values: Mapping[str, float], figures: int
) -> dict[str, object]:
    """The answers in SI of many students who round at random."""
    jotting = Jotting(figures, np.random.default_rng(20_261_122))
    with jotting.context():
        given = {
            name: jotting.write(
                np.full(STUDENTS, value), angle=template.parameters[name].unit.degrees
            )
            for name, value in values.items()
        }
        asks = {name: template.asks[name] for name in template.asked()}
        return Working(jotting).answer(template, asks, given, find_plan(template))


def convert(value: object, unit: Unit) -> object:
    return np.degrees(plain(value)) if unit.degrees else plain(value) / Floats().scale(unit.scale)


@pytest.mark.sampled(8)
@pytest.mark.parametrize("name", find_template_names())
def test_no_student_of_three_figures_is_further_off_than_the_bound(name: str) -> None:
    require_bounds(name, 3)


@pytest.mark.sampled(8, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_no_student_of_four_figures_is_further_off_than_the_bound(name: str) -> None:
    require_bounds(name, 4)


def require_bounds(name: str, figures: int) -> None:
    """That nobody is further off than the bound says, at a draw at which first orders count."""
    template = load_template(name)
    plan, asks = find_plan(template), {ask: template.asks[ask] for ask in template.asked()}
    deck = make_deck(template, "bounds", name)
    arrays = convert_parameters(template, collect_columns(deck.first(60)))
    right = find_outcomes(template, asks, (), arrays, plan).answers
    bounds = find_error_bounds(template, asks, arrays, plan, figures)
    good = np.all([np.isfinite(right[ask][0]) & np.isfinite(bounds[ask]) for ask in asks], axis=0)
    good &= np.all([bounds[ask] <= WELL * np.abs(right[ask][0]) for ask in asks], axis=0)
    place = np.flatnonzero(good)[0]
    givens = {each: values[place] for each, values in arrays.items()}
    for ask, value in work_at_random(template, givens, figures).items():
        off = measure_distance(convert(value, asks[ask].unit), right[ask][0][place], asks[ask])
        assert np.max(off) <= FIRST_ORDER * bounds[ask][place] + 1e-12


def test_a_partial_sum_of_a_textbook_is_allowed_for() -> None:
    """a = (epsilon r sin theta - omega^2 r cos theta) + rho omega^2: with four figures -11.26 and
    10.8 leave -0.46 of -0.4648.
    """
    template = load_template("flat-faced-follower-curvature-radius")
    given = {"r": "0.35", "theta": "-15", "rho": "0.3", "omega": "-6", "eps": "-10"}
    asks = {"a_BC_y": template.asks["a_BC_y"]}
    arrays = convert_parameters(template, {name: [text] for name, text in given.items()})
    right = 10 * 0.35 * sin(radians(15)) - 36 * 0.35 * cos(radians(15)) + 0.3 * 36
    student = round(10 * 0.35 * 0.2588 - round(36 * 0.35 * 0.9659, 2), 2) + 10.8
    assert (round(right, 4), round(student, 2)) == (-0.4648, -0.46)
    bounds = find_error_bounds(template, asks, arrays, find_plan(template), 4)
    assert abs(student - right) <= bounds["a_BC_y"][0]
