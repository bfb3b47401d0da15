"""`kinegrade check` finds a wrong digit or sign in a published result, and says when nothing proves a template."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from kinegrade.cli import main
from kinegrade.problem.checking import Report, check
from kinegrade.problem.library import load_template, template_names
from kinegrade.problem.reading import read_template
from kinegrade.problem.reporting import report_lines
from tests.problem.crank import crank, crank_text

SLIDER = load_template("slider-crank").text
UNPUBLISHED = crank_text(('[[published]]\nsource = "by hand"\ngives = { v_x = "-omega*h" }\n', ""))


def checked(old: str, new: str) -> Report:
    assert SLIDER.count(old) == 1
    return check(read_template("slider-crank", SLIDER.replace(old, new)), sample=2)


@pytest.mark.parametrize("name", template_names())
def test_shipped_templates_are_sound(name: str) -> None:
    report = check(load_template(name), sample=40)
    assert report.faults == []
    assert report.proved >= 1
    assert report.instances >= 1


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
    assert len(report.faults) == 5
    assert all(f"{ask} = {wrong}, but the engine gives " in fault for fault in report.faults)
    assert report.proved == 15  # of 20, at five instances each


def test_the_fault_tells_the_instance() -> None:
    fault = checked('"2*sqrt(3)/3*omega*r"', '"2*sqrt(3)/5*omega*r"').faults[0]
    assert fault.startswith("published (example 3, crank at 60 degrees) at r = ")
    assert ", k = sqrt(3), phi = 60, omega = " in fault


def test_a_template_without_published_results_is_not_finished() -> None:
    assert check(read_template("crank", UNPUBLISHED), sample=18).faults[0] == (
        "no published result: a template is finished when [[published]] proves it"
    )


def test_a_published_result_that_cannot_be_worked_out_is_a_fault() -> None:
    unreachable = crank(
        ('gives = { v_x = "-omega*h" }', 'given = { h = "3" }\ngives = { v_x = "-omega*h" }')
    )
    fault = check(unreachable, sample=18).faults[0]
    assert fault.startswith("published (by hand): no instance can be solved: crank: points.A: ")
    strange = crank(
        ('gives = { v_x = "-omega*h" }', 'given = { h = "x" }\ngives = { v_x = "-omega*h" }')
    )
    assert 'unknown name "x"' in check(strange, sample=18).faults[0]
    divided = crank(('v_x = "-omega*h"', 'v_x = "omega*h*r/(r - r)"'))
    assert "v_x: division by zero: check the values given" in check(divided, sample=18).faults[0]


def test_a_result_that_no_field_holds_must_be_stated_otherwise() -> None:
    (fault,) = check(
        read_template("slider-crank", SLIDER.replace('phi = "60"', 'phi = "37"')), sample=2
    ).faults[:1]
    assert fault.endswith(
        "the stated values lie in no small exact field: state values that prove it exactly"
    )


def test_faults_of_the_statement_are_faults_of_the_template() -> None:
    fault = check(crank(("{{ h.value }} above", "above")), sample=18).faults[0]
    assert (
        fault
        == "crank.toml: statement.en: the parameter h is not given to the student: write {{ h }}"
    )


def test_every_combination_is_examined_where_there_are_few() -> None:
    report = check(crank(), sample=200)
    assert report.instances + sum(report.refused.values()) == 18
    assert dict(report.refused) == {"condition": 6, "mechanism": 4, "degenerate": 4, "absurd": 2}
    assert report.spreads["v_x"].values == [-1.0, -1.0]


def test_no_acceptable_instance_is_a_fault() -> None:
    faults = check(crank(('[0, "1/2", 3]', "[0, 3]")), sample=200).faults
    assert "no acceptable instance was found: widen the domains or relax the conditions" in faults


def test_the_report_says_what_was_found() -> None:
    lines = list(report_lines(check(crank(), sample=200)))
    assert lines[:3] == [
        "crank: FAULTY",
        "  published results proved exactly: 5",
        "  drawable combinations: 18; examined: 18, accepted: 2, "
        "refused: absurd 2, condition 6, degenerate 4, mechanism 4",
    ]
    assert re.fullmatch(r"  distinct instances: about 2; [\d.]+ ms each", lines[3])
    assert lines[4:] == [
        "  v_x                  -1 .. -1         m/s     negative 100%, different 1",
        "  remark: some drawable combinations cannot be solved: a condition would say why",
        "  fault: about 2 distinct instances: at least 500 are needed for a class: widen the domains",
        "  fault: v_x has the same answer in all instances: a student guesses it",
        "  fault: breaks at r = 1.00, h = 1.01, omega = 2.00: crank: points.A: the circle about O of radius 1 does not "
        "reach the line y = 1.01: add a condition or narrow the domains",
    ]


def test_a_check_leaves_nothing_in_the_folder_where_it_is_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert check(load_template("slider-crank"), sample=20).faults == []
    assert list(tmp_path.iterdir()) == []


def test_an_answer_that_copies_a_given_is_remarked() -> None:
    """The speed of the crank's end is omega r; with h = 0 and r = 1 it is omega, signs apart."""
    copying = crank(
        ("draw = [1, 2]", "draw = [1]"),
        ('[0, "1/2", 3]', "[0]"),
        ("[2, 1000000, 20000000]", '"1 .. 600 step 1"'),
        ('"x(velocity(A))"', '"y(velocity(A))"'),
        ('gives = { v_x = "-omega*h" }', 'gives = { v_x = "omega*r" }'),
    )
    report = check(copying, sample=40)
    assert report.faults == []
    assert report.remarks == ["v_x equals the given omega in almost all instances"]
    assert report.distinct == 600


def test_the_command_ends_with_status_1_for_a_faulty_template(tmp_path: Path) -> None:
    file = tmp_path / "crank.toml"
    file.write_text(UNPUBLISHED, encoding="utf-8")
    result = CliRunner().invoke(main, ["check", str(file)])
    assert result.exit_code == 1
    assert result.stdout.startswith("crank: FAULTY\n")
    assert "  fault: no published result" in result.stdout
    assert CliRunner().invoke(main, ["check", "slider-crank"]).exit_code == 0
