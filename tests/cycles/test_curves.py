"""Curves over a cycle: what is asked has its exact value at the instant, and cannot be followed where
it names an angle of the instant.
"""

from __future__ import annotations

import numpy as np
import pytest

from kinegrade.cycles.curves import find_followed
from kinegrade.cycles.cycle import make_cycle
from kinegrade.cycles.graphs import draw_graphs
from kinegrade.errors import TemplateError
from kinegrade.language import ENGLISH, Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.public.cycles import describe_cycle
from tests.cycles.test_gaps import GAPS

TEMPLATES = [name for name in find_template_names() if load_template(name).scheme.drivers]


@pytest.mark.sampled(16)
@pytest.mark.parametrize("name", TEMPLATES)
def test_every_curve_is_drawn_and_goes_through_the_exact_value_at_the_instant(name: str) -> None:
    template = load_template(name)
    solution = solve_template(template, {})
    cycle = make_cycle(solution, find_followed(solution))
    assert "<svg" in draw_graphs(cycle, ENGLISH)
    assert {curve.ask.name for curve in cycle.curves if curve.gaps} == set(GAPS.get(name, {}))
    for curve, instant in zip(cycle.curves, cycle.instant, strict=True):
        quantity = solution[curve.ask.name]
        if quantity.at_infinity:
            assert not np.isfinite(instant)
        elif not curve.ask.cyclic:
            assert instant == pytest.approx(float(quantity.decimal(15)), rel=1e-9, abs=1e-9)


def test_what_names_an_angle_of_the_instant_has_no_curve() -> None:
    solution = solve_template(load_template("guide-tube-rod-fixed-centrode"), {})
    with pytest.raises(TemplateError, match='"rho" has no curve over the cycle: choose from '):
        make_cycle(solution, ("rho",))


def test_what_is_said_of_a_cycle() -> None:
    solution = solve_template(load_template("slider-crank"), {"r": "1/5", "k": "3"})
    assert describe_cycle(make_cycle(solution, ("v_B",)), ENGLISH) == [
        "full turns of the input until the mechanism is as at the instant: 1",
        "stroke of B: 0.4 m, its ends at 120° and 300°; time ratio 1",
        "v_B: least 0 m/s at 120°, greatest 0.2109 m/s at 13.18°",
    ]


@pytest.mark.parametrize(("crank", "rod"), [(0.2, 3.0), (0.35, 1.75)])
def test_extremes_are_those_between_positions(crank: float, rod: float) -> None:
    """The slider is fastest where its acceleration is zero: Newton on the closed form of the speed."""
    given = {"r": str(crank), "k": str(rod), "phi": "10", "omega": "1"}
    cycle = make_cycle(solve_template(load_template("slider-crank"), given), ("v_B",))
    _, greatest = cycle.extremes["v_B"]
    angles = np.radians(np.linspace(45, 135, 900_001))
    lag = np.arcsin(np.sin(angles) / rod)
    speeds = crank * np.sin(angles + lag) / np.cos(lag)
    top = speeds.argmax()
    assert greatest.value == pytest.approx(speeds[top], rel=1e-9)
    assert np.degrees(greatest.displacement) == pytest.approx(
        np.degrees(angles[top]) - 10, abs=1e-3
    )


def test_what_comes_to_zero_between_positions_is_zero_there() -> None:
    solution = solve_template(load_template("wheel-inside-circular-track"), {"beta": "100.1"})
    least, _ = make_cycle(solution, ("v_B",)).extremes["v_B"]
    assert least.value == 0


@pytest.mark.parametrize(
    ("tag", "name", "said"),
    [
        ("en", "wheel-inside-circular-track", "v_O: 1.44 m/s throughout"),
        ("de", "pin-in-two-rings", "a_M_x: überall 0 m/s²"),
        ("zh", "guided-rack-and-gear", "a_rel_O：始终为 0 cm/s²"),
    ],
)
def test_one_value_is_said_once(tag: str, name: str, said: str) -> None:
    cycle = make_cycle(
        solve_template(load_template(name), {}), (said.partition(":")[0].partition("：")[0],)
    )
    assert said in describe_cycle(cycle, Language(tag))


def test_dead_points_are_said_and_extremes_there_are_not() -> None:
    solution = solve_template(load_template("four-bar-parallel-coupler"), {})
    assert describe_cycle(make_cycle(solution), ENGLISH) == [
        "dead point of the input at -135.5°: B, D and E are in line",
        "dead point of the input at 15.52°: B, D and E are in line",
        "angle of swing of DE: 104.5°, its ends at -31.04° and -135.5°",
    ]
