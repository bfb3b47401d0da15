"""Published results at values that no small field holds: decimals, enclosures and full turns."""

from __future__ import annotations

import math
import re

import pytest

from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.checking import check
from kinegrade.proof.report import Report
from kinegrade.proof.reporting import write_findings
from tests.problem.crank import crank, crank_text
from tests.proof.checking.changed import SLIDER, checked
from tests.said import all_said

INEXACT = (
    ('phi = "60"', 'phi = "37"'),
    ('v_B = "2*sqrt(3)/3*omega*r"', 'v_B = "GIVEN"'),
    (', omega_AB = "0"', ""),
)


def at_37_degrees(*changes: tuple[str, str]) -> Report:
    """The slider-crank checked with a result that no small field holds."""
    text = SLIDER
    for old, new in (*INEXACT, *changes):
        assert old in text
        text = text.replace(old, new)
    return check(read_template("slider-crank", text), sample=2)


def test_a_root_that_a_printed_result_misses_has_its_decimal_behind_it() -> None:
    report = checked('v_B = "2*sqrt(3)/3*omega*r"', 'v_B = "2.32"')
    (fault,) = all_said(report.faults)
    assert re.search(r"v_B = 2\.32, but the engine gives \d+\.\d+ \(\S*sqrt\(3\)\S*\)$", fault)


def test_a_formula_at_values_that_no_field_holds_is_compared_by_enclosure() -> None:
    speed = "omega*r*sin(phi)*(1 + cos(phi)/sqrt(k**2 - sin(phi)**2))"
    assert all_said(at_37_degrees(("GIVEN", speed)).faults) == []
    (fault,) = all_said(at_37_degrees(("GIVEN", speed.replace("1 +", "1.000001 +"))).faults)
    assert ", but the engine gives " in fault


DATA = ('given = { phi = "37"', 'given = { phi = "37", r = "0.2", omega = "4"')


@pytest.mark.parametrize("right", [True, False])
def test_a_result_is_held_to_the_figures_that_are_printed(right: bool) -> None:
    # v_B = omega r sin(phi) (1 + cos(phi)/sqrt(k^2 - sin(phi)^2)) with k = sqrt(3), in floats
    sine, cosine = math.sin(math.radians(37)), math.cos(math.radians(37))
    speed = 0.8 * sine * (1 + cosine / math.sqrt(3 - sine**2))
    stated = f"{speed if right else speed + 0.001:.3f}"
    report = at_37_degrees(("GIVEN", stated), DATA)
    assert bool(report.faults) is not right
    assert report.rounded == right
    rounded = "published results met to their printed figures: 1"
    assert (rounded in all_said(write_findings(report))) is right


@pytest.mark.parametrize(("stated", "faults"), [("60", 0), ("61", 1)])
def test_a_whole_number_belongs_to_the_data_of_the_source(stated: str, faults: int) -> None:
    text = load_template("crank-bar-through-sleeve-with-arm").file.text
    head, _, rest = text.partition("[[published]]")
    stating, _, figure = rest.partition("[figure]")
    source = f'[[published]]\nsource = "by hand"\ngives = {{ v_A = "{stated}" }}\n'
    assert 'v_A = "60"' in stating
    template = read_template("crank", f"{head}{source}[figure]{figure}")
    assert len(check(template, sample=2).faults) == faults


def test_a_printed_angle_is_right_with_full_turns_more_or_less() -> None:
    text = crank_text(
        ('quantity = "x(velocity(A))"', 'quantity = "angle(A - O, velocity(A))"'),
        ('unit = "m/s", sign = "+x"', 'unit = "deg", sign = "ccw"'),
        ("-omega*h", "-270.0"),
    )
    assert not [
        each for each in all_said(check(read_template("c", text)).faults) if "engine" in each
    ]


def test_a_source_that_leaves_an_angle_open_is_proved_at_those_that_a_field_holds() -> None:
    text = load_template("rolling-wheel-pin-slotted-rocker").file.text
    some = text.replace("draw = [20, 30, 45, 60, 75]", "draw = [50, 60]")
    assert some != text
    assert all_said(check(read_template("wheel", some), sample=2).faults) == []
    wrong = some.replace('"abs(v_O)*(1 + cos(phi))"', '"abs(v_O)*(1 - cos(phi))"')
    fault = all_said(check(read_template("wheel", wrong), sample=2).faults)[0]
    assert ", phi = 60, " in fault
    assert "v_rel = abs(v_O)*(1 - cos(phi)), but the engine gives " in fault


def test_a_formula_that_no_field_holds_at_its_values_proves_nothing() -> None:
    inexact = crank(
        (
            'gives = { v_x = "-omega*h" }',
            'given = { r = "2", h = "1", omega = "2" }\ngives = { v_x = "-omega*h*cos(7*pi/180)" }',
        )
    )
    fault = all_said(check(inexact, sample=18).faults)[0]
    assert fault == (
        "published (by hand): no instance can be solved: the values lie in no small exact field"
    )
