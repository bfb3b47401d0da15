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
from kinegrade.students.comparison import collect_columns, measure_distance
from kinegrade.students.following.connections import find_generic_plan
from kinegrade.students.mistaking.mistake_outcomes import find_outcomes
from kinegrade.students.mistaking.mistakes import convert_parameters
from kinegrade.students.rounding.bounds import find_roundings
from kinegrade.students.rounding.working import Working
from tests.problem.crank import crank

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
    """The answers of many students who round at random, in the units that are asked for."""
    jotting = Jotting(figures, np.random.default_rng(20_261_122))
    with jotting.context():
        given = {
            name: jotting.write(
                np.full(STUDENTS, value), angle=template.parameters[name].unit.degrees
            )
            for name, value in values.items()
        }
        asks = {name: template.asks[name] for name in template.asked()}
        found = Working(jotting).answer(template, asks, given, find_plan(template))
        return {name: hand_in(value, asks[name].unit, jotting) for name, value in found.items()}


def hand_in(value: object, unit: Unit, jotting: Jotting) -> object:
    """An answer in its unit; an angle, found in degrees, is rounded once more in another one."""
    if unit.degrees:
        return np.degrees(plain(value))
    shown = plain(value) / Floats().scale(unit.scale)
    return plain(jotting.write(shown)) if getattr(value, "angle", False) else shown


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
    roundings = find_roundings(template, asks, arrays, plan, figures)
    bounds = {ask: each.bound for ask, each in roundings.items()}
    good = np.all([np.isfinite(right[ask][0]) & np.isfinite(bounds[ask]) for ask in asks], axis=0)
    good &= np.all([bounds[ask] <= WELL * np.abs(right[ask][0]) for ask in asks], axis=0)
    place = np.flatnonzero(good)[0]
    givens = {each: values[place] for each, values in arrays.items()}
    for ask, value in work_at_random(template, givens, figures).items():
        off = measure_distance(value, right[ask][0][place], asks[ask])
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
    found = find_roundings(template, asks, arrays, find_plan(template), 4)["a_BC_y"]
    assert abs(student - right) <= found.bound[0]


@pytest.mark.parametrize(("unit", "size", "bound"), [("rad", 1, 0.005), ("deg", 57.3, 0)])
def test_an_angle_of_whole_degrees_is_rounded_in_radians(
    unit: str, size: float, bound: float
) -> None:
    """135 degrees: nothing is lost of them, but of 2.356 radians three figures leave 2.36. No term
    is larger than the answer, nor taken for larger than a radian.
    """
    template = crank(
        ('"meet(circle(O, r), line(P, 0), right)"', '"(-r, h)"'),
        (
            '"x(velocity(A))", unit = "m/s", sign = "+x"',
            f'"angle((1, 0), A - O)", unit = "{unit}", sign = "ccw"',
        ),
        ('gives = { v_x = "-omega*h" }', 'gives = { v_y = "-omega*r" }'),
    )
    arrays = convert_parameters(template, {"r": ["1"], "h": ["1"], "omega": ["2"]})
    asks = {"v_x": template.asks["v_x"]}
    found = find_roundings(template, asks, arrays, find_plan(template), 3)["v_x"]
    assert found.bound[0] == pytest.approx(bound)
    assert found.largest[0] == pytest.approx(size)


@pytest.mark.parametrize(
    ("quantity", "size"),
    [
        ("x(velocity(A))", 6),  # omega h alone
        ("x(velocity(A)) + 5*omega*h/6", 6),  # a sixth is left of it
    ],
)
def test_the_largest_term_of_an_answer_by_hand(quantity: str, size: float) -> None:
    """A crank of 5 m turns at 2 rad/s with A 3 m above the pivot and 4 m beside it."""
    template = crank(
        ('quantity = "x(velocity(A))"', f'quantity = "{quantity}"'),
        ('gives = { v_x = "-omega*h" }', 'gives = { v_y = "omega*sqrt(r**2 - h**2)" }'),
    )
    arrays = convert_parameters(template, {"r": ["5"], "h": ["3"], "omega": ["2"]})
    plan = find_plan(template)
    found = find_roundings(template, {"v_x": template.asks["v_x"]}, arrays, plan, 4)["v_x"]
    assert found.largest[0] == pytest.approx(size)


@pytest.mark.sampled(8, first=2)
@pytest.mark.parametrize("name", find_template_names())
def test_the_largest_term_lies_between_the_answer_and_the_scale_of_its_kind(name: str) -> None:
    template = load_template(name)
    plan, asks = find_plan(template), {ask: template.asks[ask] for ask in template.asked()}
    arrays = convert_parameters(
        template, collect_columns(make_deck(template, "largest", name).first(60))
    )
    right = find_outcomes(template, asks, (), arrays, plan)
    for ask, found in find_roundings(template, asks, arrays, plan, 4).items():
        answers, scale = np.abs(right.answers[ask][0]), right.scales[ask]
        known = np.isfinite(found.bound) & np.isfinite(answers)
        assert np.all(found.largest[known] <= scale[known])
        assert np.all(found.largest[known] >= np.fmin(answers, scale)[known] * (1 - 1e-9))
