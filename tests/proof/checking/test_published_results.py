"""A wrong digit or sign in a published result is found; without any, a template is unproved."""

from __future__ import annotations

import re

import pytest
from msgspec.structs import replace

from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.checking import _list_remarks, check
from kinegrade.proof.published import prove_published
from kinegrade.proof.report import Report
from kinegrade.proof.reporting import write_verdict
from tests.problem.crank import crank, crank_text
from tests.proof.checking.changed import SLIDER, checked
from tests.said import all_said, said


@pytest.mark.parametrize(
    ("ask", "right", "wrong"),
    [
        ("v_B", "2*sqrt(3)/3*omega*r", "2*sqrt(3)/5*omega*r"),
        ("v_B", "2*sqrt(3)/3*omega*r", "-2*sqrt(3)/3*omega*r"),
        ("v_B", "2*sqrt(3)/3*omega*r", "1.154700538379251529*omega*r"),
        ("omega_AB", "0", "1e-30"),
    ],
)
def test_a_wrong_published_result_is_found(ask: str, right: str, wrong: str) -> None:
    report = checked(f'{ask} = "{right}"', f'{ask} = "{wrong}"')
    [fault] = all_said(report.faults)  # one cause, though it shows at five instances
    assert f"{ask} = {wrong}, but the engine gives " in fault
    assert report.proved == 15  # of 20, at five instances each


def test_the_fault_tells_the_instance() -> None:
    fault = all_said(checked('"2*sqrt(3)/3*omega*r"', '"2*sqrt(3)/5*omega*r"').faults)[0]
    assert fault.startswith("published (example 3, crank at 60 degrees) at r = ")
    assert ", k = sqrt(3), phi = 60, omega = " in fault


def test_a_whole_number_beside_an_answer_with_pi_is_told_with_the_answer() -> None:
    rpm = crank_text(
        ('unit = "rad/s", draw = [2, 1000000, 20000000]', 'unit = "rpm", draw = ["60"]'),
        ('h     = { unit = "m", draw', 'h     = { unit = "m", published = "1/2", draw'),
        ('conditions = ["omega < 10000000"]', ""),
        ('gives = { v_x = "-omega*h" }', 'gives = { v_x = "-3" }'),
    )
    faults = all_said(check(read_template("crank", rpm)).faults)
    assert [each for each in faults if "published" in each] == [
        "published (by hand) at r = 2, h = 1/2, omega = 60: v_x = -3, but the engine gives "
        '-3.141592654 (-pi) - a whole number is held exactly: write "-3." where the source has '
        "rounded"
    ]


def test_asks_that_no_source_gives_are_named() -> None:
    both = crank(('sign = "+y", means', 'sign = "+y", points = 3, means'))
    unproved = [each for each in all_said(_list_remarks(both)) if "no published result" in each]
    assert unproved == [
        "no published result for v_y - [[published]] with values found otherwise would prove them"
    ]
    assert not [each for each in all_said(_list_remarks(crank())) if "no published" in each]


def test_a_template_without_published_results_is_unproved_and_can_be_used() -> None:
    text = re.sub(r"(?s)\[\[published\]\].*?\n(?=\[figure\])", "", SLIDER)
    report = check(read_template("slider-crank", text), sample=18)
    assert (said(write_verdict(report)), report.faults) == ("slider-crank: unproved", [])
    asked_for = [each for each in all_said(report.remarks) if "no published result" in each]
    assert asked_for == [
        "no published result: the template can be used, and is proved once [[published]] states "
        'one, as the source prints it: gives = { v_B = "4.08" }'
    ]


def test_a_published_result_that_cannot_be_worked_out_is_a_fault() -> None:
    unreachable = crank(
        ('gives = { v_x = "-omega*h" }', 'given = { h = "3" }\ngives = { v_x = "-omega*h" }')
    )
    fault = all_said(check(unreachable, sample=18).faults)[0]
    assert fault.startswith("published (by hand): no instance can be solved: crank: points.A: ")
    strange = crank(
        ('gives = { v_x = "-omega*h" }', 'given = { h = "x" }\ngives = { v_x = "-omega*h" }')
    )
    assert 'unknown name "x"' in all_said(check(strange, sample=18).faults)[0]
    divided = crank(('v_x = "-omega*h"', 'v_x = "omega*h*r/(r - r)"'))
    assert (
        "v_x: division by zero: check the values given"
        in all_said(check(divided, sample=18).faults)[0]
    )


def test_a_condition_that_the_source_itself_does_not_meet_is_remarked() -> None:
    given = ("gives = { v_x", 'given = { r = "1", h = "1/2" }\ngives = { v_x')
    unmet = ('["omega < 10000000"]', '["omega < 10000000", "h < r/4"]')
    remarks = all_said(check(crank(given, unmet), sample=18).remarks)
    assert (
        "published (by hand): the condition h < r/4 does not hold at the source's values, which no "
        "paper will have: see whether it says what you mean"
    ) in remarks
    assert not [each for each in remarks if "omega < 10000000 does not hold" in each]


def test_a_whole_number_that_the_source_has_rounded_is_told_how_to_be_written() -> None:
    stated = (
        'gives = { v_x = "-omega*h" }',
        'given = { r = "1", h = "1/2", omega = "2" }\ngives = { v_y = "2" }',
    )
    fault, *_ = all_said(check(crank(stated), sample=18).faults)
    assert "v_y = 2, but the engine gives 1.732050808 (sqrt(3))" in fault
    assert fault.endswith('a whole number is held exactly: write "2." where the source has rounded')
    other = (stated[0], stated[1].replace('v_y = "2"', 'v_y = "3"'))
    fault, *_ = all_said(check(crank(other), sample=18).faults)
    assert "v_y = 3, but the engine gives " in fault
    assert "whole number" not in fault


def test_a_published_expression_tells_its_own_value_and_the_units_in_which_it_counts() -> None:
    millimetres = (
        ('r     = { unit = "m", draw = [1, 2]', 'r     = { unit = "mm", draw = [1000, 2000]'),
        ('h     = { unit = "m", draw = [0, "1/2", 3]', 'h     = { unit = "mm", draw = [500]'),
        ("[2, 1000000, 20000000]", "[2]"),
    )
    fault, *_ = all_said(check(crank(*millimetres), sample=18).faults)
    assert fault.endswith(
        "v_x = -omega*h, but the engine gives -1; the expression is -1000 - numbers count in their "
        "own units here: v_x in m/s, h in mm and omega in rad/s"
    )


def test_a_published_result_needs_no_value_where_the_answer_has_none() -> None:
    template = load_template("stepped-drum-on-two-ropes")
    report = Report(template, sound=("x_P",))
    prove_published(report, replace(template.published[0], given={"u": "20", "v": "20"}))
    assert (all_said(report.faults), report.proved) == ([], 5)
