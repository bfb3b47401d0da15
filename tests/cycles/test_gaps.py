"""What has no value at some position breaks off there, and says so: a component along a direction
that has no length, a pole of a body at rest, an angle to a velocity that vanishes.
"""

from __future__ import annotations

import csv
import math

import numpy as np
import pytest

from kinegrade.cycles.curves import find_followed
from kinegrade.cycles.cycle import Cycle, make_cycle
from kinegrade.cycles.graphs import draw_graphs
from kinegrade.cycles.table import write_table
from kinegrade.language import ENGLISH, Language
from kinegrade.motion.path import Array, MotionPath, find_path
from kinegrade.practice.poses import write_motion
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.public.cycles import describe_cycle
from tests.practice.node import trace_in_node

RODS, SLEEVES, TUBE = (
    "two-rods-driven-ends",
    "bent-rod-two-sleeves",
    "guide-tube-rod-fixed-centrode",
)
GEAR, LINK = "planetary-gear-external-rim-velocities", "slotted-rocker-and-slider-two-drivers"
LINKED = "crank-slider-in-floating-link"
UPRIGHT, FLAT = [75, 255], [206.8103, 303.1897]  # degrees: M is at E, or at B
CHANGE = [-0.5]  # m: the rods are in line
GAPS: dict[str, dict[str, list[float]]] = {
    SLEEVES: {
        "v_rel_A": UPRIGHT,
        "v_rel_B": FLAT,
        "v_M_2": UPRIGHT,
        "a_rel_A": UPRIGHT[:1],  # at the other one it is zero whichever way it is counted
        "a_rel_B": FLAT,
        "a_M_2": UPRIGHT,
    },
    TUBE: {
        **{ask: [300, 660] for ask in ("AS", "x_S", "y_S", "omega_ratio")},
        # O, A and B are in line at 120
        **{ask: [120, 300, 480, 660] for ask in ("S_bis", "S_perp")},
    },
    GEAR: {"angle_vB_vA": [72, 360, 648, 936, 1224]},
    # The link translates, with its pole at infinity, or is at rest, with a pole anywhere
    LINKED: {
        "ic_x": [168.8186, 235.3326, 319.8636],
        **{ask: [235.3326] for ask in ("ic_y", "l_AP", "l_BP", "l_CP")},
    },
    "stone-crusher": {ask: [88.9130, 272.2750] for ask in ("BC2", "GC2")},  # the jaw is at rest
    "rod-ground-and-incline": {"v_B_down": [0.8453], "a_B_down": [0.8453]},  # m
    "scissor-lift": {ask: [1.7321] for ask in ("omega_AD", "v_C", "a_C")},  # m: C and D meet
    "guided-rack-and-gear": {  # m: the rack lies along the track
        ask: [-0.0866] for ask in ("SA", "SC", "omega_1", "v_C", "v_rel_O", "alpha_1", "a_rel_O")
    },
    LINK: {"v_rel": [-96.2238, 6.9086], "a_rel": [-96.2238, 6.9086]},
    RODS: {
        "omega_AC": CHANGE,
        "omega_BC": CHANGE,
        "v_C_x": CHANGE,
        "v_C_y": CHANGE,
        "v_C": CHANGE,
        "alpha_AC": CHANGE,
        "alpha_BC": CHANGE,
        "a_C_x": CHANGE,
        "a_C_y": CHANGE,
        "a_C": CHANGE,
    },
}


def follow(name: str, *asks: str) -> Cycle:
    solution = solve_template(load_template(name), {})
    return make_cycle(solution, asks or find_followed(solution))


@pytest.mark.parametrize("name", GAPS)
def test_values_break_off_where_there_is_none(name: str) -> None:
    cycle = follow(name)
    found = {curve.ask.name: [gap.displacement for gap in curve.gaps] for curve in cycle.curves}
    unit = math.degrees(1) if cycle.path.input.is_angle else 1.0
    places = {ask: [gap * unit for gap in gaps] for ask, gaps in found.items() if gaps}
    expected = GAPS[name]
    assert places.keys() == expected.keys()
    for ask, gaps in places.items():
        assert gaps == pytest.approx(expected[ask], abs=1e-3), ask
    for curve in cycle.curves:
        for gap in curve.gaps:
            (place,) = np.flatnonzero(curve.moved == gap.displacement)
            assert np.isfinite(curve.values[place - 1 : place + 2]).tolist() == [True, False, True]


def find_components(moved: Array) -> Array:
    """By hand: of the velocity of the corner along MC, which points the other way behind E."""
    phi = np.radians(15) + moved
    given = {"d": 0.5, "e": 0.4, "omega": 2.0}
    return np.sign(np.cos(phi)) * (given["e"] + given["d"] * np.sin(phi)) * given["omega"]


def test_values_on_both_sides_are_those_of_the_formula() -> None:
    given = {"d": "1/2", "e": "2/5", "phi": "15", "omega": "2", "alpha": "3"}
    cycle = make_cycle(solve_template(load_template(SLEEVES), given), ("v_M_2", "x_M"))
    curve, other = cycle.curves
    known = np.isfinite(curve.values)
    assert np.count_nonzero(~known) == 2
    np.testing.assert_allclose(curve.values[known], find_components(curve.moved)[known], atol=1e-9)
    assert np.isfinite(other.values).all()


@pytest.mark.parametrize(
    ("tag", "name", "said"),
    [
        ("en", SLEEVES, "v_M_2: no value at 75° and 255°, where M and E coincide"),
        ("de", SLEEVES, "v_M_2: kein Wert bei 75° und 255°, dort fallen M und E zusammen"),
        ("zh", SLEEVES, "v_M_2：在 75° 和 255° 处无值，此时 M 和 E 重合"),
        ("en", RODS, "v_C: no value at -0.5 m, where it is undetermined"),
        ("de", RODS, "v_C: kein Wert bei -0,5 m, dort ist die Größe unbestimmt"),
        ("zh", RODS, "v_C：在 -0.5 m 处不确定，无值"),
    ],
)
def test_it_is_said(tag: str, name: str, said: str) -> None:
    ask = said.partition(":")[0].partition("：")[0]
    assert said in describe_cycle(follow(name, ask), Language(tag))


def test_a_table_has_an_empty_cell_there() -> None:
    rows = csv.DictReader(write_table(follow(SLEEVES, "a_M_2")).splitlines())
    empty = [row["input (deg)"] for row in rows if not row["a_M_2 (m/s^2)"]]
    assert empty == ["75", "255"]


def test_a_small_jump_is_a_gap_too() -> None:
    """At -96 degrees the acceleration along OA, which turns round, is a hundredth of its range."""
    curve = follow(LINK, "a_rel").curves[0]
    (place,) = np.flatnonzero(curve.moved == curve.gaps[0].displacement)
    before, _, after = curve.values[place - 1 : place + 2]
    assert before == pytest.approx(-after, rel=0.02)
    assert 0 < abs(after - before) < 0.02 * np.ptp(curve.values[np.isfinite(curve.values)])


def test_what_is_not_determined_has_a_gap_whatever_rounding_makes_of_it() -> None:
    """Where B is at O the rod may turn freely: its pole may be anywhere on the crank."""
    said = describe_cycle(follow(TUBE, "AS"), ENGLISH)
    assert "change point at 300°" in said
    assert "AS: no value at 300° and 660°, where it is undetermined" in said


@pytest.mark.parametrize(
    ("name", "ask"),
    [
        (SLEEVES, "EM"),
        (SLEEVES, "v_M_1"),
        ("two-wheels-on-cylinder", "alpha_AB"),
        ("parallelogram-with-sliding-rod", "omega_BD"),
        ("rotary-engine", "alpha_AB"),
    ],
)
def test_what_rounding_leaves_of_zero_is_zero(name: str, ask: str) -> None:
    cycle = follow(name, ask)
    assert (cycle.curves[0].values == 0).any()
    for row in csv.DictReader(write_table(cycle).splitlines()):
        numbers = (float(cell) for cell in row.values() if cell)
        assert all(number == 0 or abs(number) > 1e-9 for number in numbers), row


@pytest.mark.parametrize(
    ("tag", "said"),
    [
        ("en", "S_bis: least -0.1 m near 300°, greatest 0 m near 120°"),
        ("de", "S_bis: am kleinsten -0,1 m nahe 300°, am größten 0 m nahe 120°"),
        ("zh", "S_bis：最小 -0.1 m（在 300° 附近），最大 0 m（在 120° 附近）"),
    ],
)
def test_nothing_divided_by_nothing_is_a_gap_though_both_sides_agree(tag: str, said: str) -> None:
    """At 120 degrees the bisector has no direction; beside it the component along it is almost 0,
    and what rounding leaves of it there is no value.
    """
    cycle = follow(TUBE, "S_bis")
    assert said in describe_cycle(cycle, Language(tag))
    rows = csv.DictReader(write_table(cycle).splitlines())
    empty = [float(row["input (deg)"]) for row in rows if not row["S_bis (m)"]]
    assert empty == pytest.approx([120, 300, 480, 660], abs=1e-6)
    assert draw_graphs(cycle, ENGLISH).count('stroke-width="0.4"') == 5


def test_a_graph_is_in_parts() -> None:
    def count(*asks: str) -> int:
        return draw_graphs(follow(SLEEVES, *asks), ENGLISH).count('stroke-width="0.4"')

    assert [count("x_M"), count("v_M_2"), count("v_rel_B")] == [1, 3, 3]


@pytest.mark.parametrize(
    ("name", "ask"), [(SLEEVES, "v_M_2"), (SLEEVES, "v_rel_B"), (TUBE, "x_S"), (TUBE, "S_bis")]
)
def test_graphs_of_practice_sheets_break_off_too(name: str, ask: str) -> None:
    solution = solve_template(load_template(name), {})
    path = find_path(solution.motion)
    assert isinstance(path, MotionPath)
    motion = write_motion(path, solution, (ask,))
    (least, greatest, _, _), *_ = motion.curves
    curve = follow(name, ask).curves[0]
    (parts,) = trace_in_node(motion)
    ends = [-np.inf, *(gap.displacement for gap in curve.gaps), np.inf]
    assert len(parts) == len(ends) - 1
    for part, start, end in zip(parts, ends, ends[1:], strict=False):
        inputs, shares = np.array(part).T
        beside = np.isfinite(curve.values) & (curve.moved > start) & (curve.moved < end)
        expected = np.interp(np.radians(inputs), curve.moved[beside], curve.values[beside])
        values = least + (greatest - least) * shares
        assert np.abs(values - expected).max() < 0.02 * (greatest - least)
