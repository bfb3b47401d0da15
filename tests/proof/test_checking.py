"""`kinegrade check` finds a wrong digit or sign in a published result, and says when nothing proves
a template.
"""

from __future__ import annotations

import math
import re
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from kinegrade.cli import main
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.library.starter import write_starter_text
from kinegrade.proof import searching
from kinegrade.proof.assemblies import close_otherwise, find_other_assemblies
from kinegrade.proof.checking import _list_remarks, check, choose_drawable
from kinegrade.proof.neighbours import list_probed
from kinegrade.proof.published import prove_published
from kinegrade.proof.reach import find_condition
from kinegrade.proof.report import Report
from kinegrade.proof.reporting import write_findings, write_verdict
from tests.problem.crank import crank, crank_text
from tests.said import all_said, said

SAMPLES = 8, 21  # draws of a template, until one of them may be dealt
SLIDER = load_template("slider-crank").file.text
UNPUBLISHED = crank_text(('[[published]]\nsource = "by hand"\ngives = { v_x = "-omega*h" }\n', ""))


def checked(old: str, new: str) -> Report:
    assert SLIDER.count(old) == 1
    return check(read_template("slider-crank", SLIDER.replace(old, new)), sample=6)


@pytest.mark.sampled(9)  # "sound templates" of `make prove` looks at each at more instances
@pytest.mark.parametrize("name", find_template_names())
def test_shipped_templates_are_sound(name: str) -> None:
    reports = (check(load_template(name), sample) for sample in SAMPLES)
    report = next((each for each in reports if each.instances), None)
    assert report is not None
    assert all_said(report.faults) == []
    assert report.proved >= 1
    remarks = all_said(report.remarks)
    assert not [each for each in remarks if "which are easier" in each or "tags that" in each]


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


def test_a_magnitude_that_is_negative_is_a_fault_with_its_values() -> None:
    negative = crank_text(('sign = "+x", points', 'sign = "magnitude", points'))
    [fault] = [
        each for each in all_said(check(read_template("crank", negative)).faults) if "v_x:" in each
    ]
    assert fault.startswith("asks.v_x: at r = ")
    assert fault.endswith(
        "v_x is negative, though papers would say that it is not - say in sign what a positive answer "
        'means ("ccw", "+x", "signed" ...), or ask for a size, abs(...)'
    )


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


def test_an_answer_that_is_always_zero_may_carry_points_where_its_author_says_so() -> None:
    at_rest = ('quantity = "x(velocity(A))"', 'quantity = "x(velocity(O))", vanishes = true')
    said_so = read_template("crank", crank_text(at_rest, ('"-omega*h"', '"0"')))
    assert not [each for each in all_said(check(said_so).faults) if "v_x" in each]
    silent = crank_text(at_rest, ('"-omega*h"', '"0"'), (", vanishes = true", ""))
    assert not check(read_template("crank", silent)).is_sound


def test_a_family_in_capitals_is_remarked_on() -> None:
    report = check(read_template("crank", crank_text(('family = "crank"', 'family = "Crank"'))))
    assert (
        'family: families are in small letters, and "Crank" is another one than "crank" to lists '
        'and banks - did you mean "crank"?' in all_said(report.remarks)
    )


def test_a_figure_that_marks_what_is_not_there_is_a_fault() -> None:
    radius = '[figure]\nradii = [{ symbol = "R", centre = "O" }]'
    [fault] = all_said(checked("[figure]", radius).faults)
    assert fault.startswith('figure.radii: no circle about "O"')


def test_the_fault_tells_the_instance() -> None:
    fault = all_said(checked('"2*sqrt(3)/3*omega*r"', '"2*sqrt(3)/5*omega*r"').faults)[0]
    assert fault.startswith("published (example 3, crank at 60 degrees) at r = ")
    assert ", k = sqrt(3), phi = 60, omega = " in fault


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


def test_a_radius_that_may_be_that_of_several_circles_is_a_fault() -> None:
    """It was drawn at the larger one, though the smaller one was meant, and nothing said so."""
    text = load_template("two-stage-belt-drive").file.text
    unnamed = text.replace(', through = "D"', "")
    assert unnamed != text
    report = check(read_template("two-stage-belt-drive", unnamed), sample=8)
    assert all_said(report.faults) == [
        'figure.radii: "r_2" may be the radius of several circles about "A", which are not alike - '
        'say which one, by of = "BODY" or through = "POINT"'
    ]


def test_a_point_that_the_statement_names_and_the_figure_does_not_letter_is_remarked() -> None:
    named = ("$A$ is {{ h.value }} above $O$.", "$A$ is {{ h.value }} above $O$, as $P$ is.")
    remarks = all_said(check(crank(named), sample=18).remarks)
    assert (
        "the statement names P, which has no letter in the figure: put it on a body that it "
        "belongs to"
    ) in remarks
    lettered = ('OA = "O A"', 'OA = "O A P"')
    assert not [
        each for each in all_said(check(crank(named, lettered), sample=18).remarks) if "P," in each
    ]


def test_a_point_that_the_statement_names_and_the_file_has_not_is_remarked() -> None:
    named = ("$A$ is {{ h.value }} above $O$.", r"$\angle OAW$: $A$ is {{ h.value }} above $V_1$.")
    remarks = all_said(check(crank(named), sample=18).remarks)
    for letter in ("W", "V_1"):
        assert (
            f"the statement names {letter}, which is no point or body of the file: correct the "
            "letter, or declare the point"
        ) in remarks
    assert not [each for each in remarks if "statement names A" in each]


def test_a_point_with_another_letter_in_the_figure_is_remarked() -> None:
    renamed = ("[asks]\n", '[figure]\nlabels = { A = "K_1" }\n[asks]\n')
    said = (
        "the figure calls A K_1, and worked solutions and feedback A: call the point K_1 in the "
        "file"
    )
    assert said in all_said(check(crank(renamed), sample=18).remarks)
    same = ("[asks]\n", '[figure]\nlabels = { A = "A" }\n[asks]\n')
    assert said[:12] not in "".join(all_said(check(crank(same), sample=18).remarks))


def test_a_given_on_which_nothing_depends_is_remarked_and_makes_no_further_instances() -> None:
    idle = (
        "[parameters]\n",
        '[parameters]\nq = { unit = "m", draw = [1, 2, 3], means = "none" }\n',
    )
    report = check(crank(idle, ("turns with", "{{ q }} turns with")), sample=54)
    assert (
        "nothing that is asked, moves or is drawn depends on the given q: leave it out, or use "
        "it; its values make no further instances"
    ) in all_said(report.remarks)
    assert (report.examined, report.distinct) == (54, 2)
    assert not [each for each in all_said(check(crank(), 18).remarks) if "depends on" in each]


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
    some = text.replace('draw = "20 .. 80 step 4"', "draw = [50, 60]")
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


def test_a_published_result_needs_no_value_where_the_answer_has_none() -> None:
    template = load_template("stepped-drum-on-two-ropes")
    report = Report(template, sound=("x_P",))
    prove_published(report, replace(template.published[0], given={"u": "20", "v": "20"}))
    assert (all_said(report.faults), report.proved) == ([], 5)


def test_faults_of_the_statement_are_faults_of_the_template() -> None:
    fault = all_said(check(crank(("{{ h.value }} above", "above")), sample=18).faults)[0]
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
    faults = all_said(check(crank(('[0, "1/2", 3]', "[0, 3]")), sample=200).faults)
    assert "no acceptable instance was found: widen the domains or relax the conditions" in faults


def test_a_template_that_seldom_has_an_accepted_draw_is_remarked_on() -> None:
    remark = "draws are accepted, less than a tenth: exams take long to generate: leave out the"
    report = check(crank(('[0, "1/2", 3]', '[0, "1/2", 3, 4, 5, 6]')), sample=200)
    assert f"only 2 of 36 {remark} values that are refused" in all_said(report.remarks)
    assert not any(remark in said for said in all_said(check(crank(), sample=200).remarks))


def test_a_sample_without_an_accepted_draw_is_no_fault_and_never_sound() -> None:
    report = check(load_template("slider-crank"), sample=1, secret="c")  # its draw is refused
    assert (report.instances, report.faults) == (0, [])
    assert not report.is_sound
    assert said(write_verdict(report)) == "slider-crank: undecided, no draw was accepted"
    assert all_said(report.remarks) == [
        "no published result for alpha_AB, a_B - [[published]] with values found otherwise would "
        "prove them",
        "accepted 0 of 1: too few draws to tell whether there are 500 distinct instances: "
        "examine 99 with --sample",
    ]


def test_the_report_says_what_was_found() -> None:
    report = check(crank(), sample=200)
    lines = [said(write_verdict(report)), *map(said, write_findings(report))]
    assert lines[:4] == [
        "crank: FAULTY",
        "complete in: en, zh",
        "published results proved exactly: 5",
        "drawable combinations: 18; examined: 18, accepted: 2, "
        "refused: absurd 2, condition 6, degenerate 4, mechanism 4",
    ]
    assert re.fullmatch(r"distinct instances: about 2; [\d.]+ ms each", lines[4])
    assert lines[5:7] == [
        "difficulty: 1 of 5; about 6 minutes",
        "refused, condition: omega < 10000000: 6 of 18, nearly all at omega = 20000000 rad/s: "
        "leave that value out",
    ]
    assert [line.partition(":")[0] for line in lines[7:10]] == [
        "refused, degenerate",
        "refused, mechanism",
        "refused, absurd",
    ]
    assert lines[10:] == [
        "v_x                  -1 .. -1         m/s     negative 100%, different 1",
        'A is "right"; with "left" it closes as well in 100% of the draws: -o FILE shows both',
        "fault: about 2 distinct instances: at least 500 are needed for a class: widen the domains",
        "fault: v_x has the same answer in all instances: a student guesses it: give it no points "
        "here (a bank may still ask for it), or ask for something else",
        "fault: breaks at r = 1, h = 3, omega = 2: crank: points.A: the circle about O of "
        "radius 1 does not reach the line y = 3: add the condition "
        '"distance(O, foot(O, line(P, 0))) < r" or narrow the domains',
    ]


def test_the_condition_that_is_named_keeps_out_what_breaks() -> None:
    condition = '"omega < 10000000", "distance(O, foot(O, line(P, 0))) < r"'
    text = crank_text(('"omega < 10000000"', condition))
    assert not [
        fault
        for fault in all_said(check(read_template("crank", text)).faults)
        if "breaks at" in fault
    ]


def test_what_breaks_is_shown_at_values_that_can_be_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    template = crank()
    near = {"r": ["1"], "h": ["3.01"], "omega": ["2"]}
    monkeypatch.setattr(searching, "list_probed", lambda _, given: near[given.name])
    found = searching.find_breaking_values(template, ("v_x",), 30, "check")
    assert found is not None
    assert all(value in template.parameters[name].choices for name, value in found[0].items())


@pytest.mark.parametrize(
    ("values", "condition"),
    [
        ({"r": "1", "h": "3"}, "distance(O, P) < r + r"),
        ({"r": "1", "h": "1"}, ""),
    ],
)
def test_two_circles_that_do_not_reach_each_other(values: dict[str, str], condition: str) -> None:
    circles = ("line(P, 0), right", "circle(P, r), right")
    assert find_condition(crank(circles), {**values, "omega": "2"}) == condition


def test_a_check_leaves_nothing_in_the_folder_where_it_is_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert all_said(check(load_template("slider-crank"), sample=20).faults) == []
    assert list(tmp_path.iterdir()) == []


def test_an_answer_that_copies_a_given_is_a_fault() -> None:
    """The speed of the crank's end is omega r; with h = 0 and r = 1 it is omega, signs apart."""
    copying = crank(
        ("draw = [1, 2]", "draw = [1]"),
        ('[0, "1/2", 3]', "[0]"),
        ("[2, 1000000, 20000000]", '"1 .. 600 step 1"'),
        (
            '"x(velocity(A))", unit = "m/s", sign = "+x"',
            '"y(velocity(A))", unit = "m/s", sign = "+y"',
        ),
        ('gives = { v_x = "-omega*h" }', 'gives = { v_x = "omega*r" }'),
    )
    report = check(copying, sample=40)
    assert all_said(report.faults) == [
        "v_x equals the given omega in almost all instances, signs apart, and is copied from it: "
        "give it no points"
    ]
    assert report.remarks == []
    assert report.distinct == 600


def test_a_given_that_is_zero_in_some_draws_alone_is_remarked() -> None:
    text = load_template("scotch-yoke-driven-by-guide").file.text
    some = text.replace("[-900, -600, -300, 300, 600, 900]", "[0, 600]")
    assert some != text
    report = check(read_template("yoke", some), 30)
    (remark,) = (each for each in all_said(report.remarks) if "easier" in each)
    share = re.fullmatch(
        "a is zero or a multiple of 90 degrees in ([0-9]+)% of the draws, which are easier: "
        "leave such values out, or give them to all",
        remark,
    )
    assert share is not None
    assert 20 <= int(share[1]) <= 80


@pytest.mark.parametrize(("choices", "remarked"), [('["0"]', False), ("[45, 90]", True)])
def test_what_is_special_in_all_draws_is_no_remark(choices: str, remarked: bool) -> None:
    text = crank_text(
        (
            'h     = { unit = "m", draw = [0, "1/2", 3]',
            f'h     = {{ unit = "deg", draw = {choices}',
        ),
        ('P = "(0, h)"\n', ""),
        ('A = "meet(circle(O, r), line(P, 0), right)"', 'A = "polar(O, r, h)"'),
        ('quantity = "x(velocity(A))"', 'quantity = "magnitude(velocity(A))"'),
        ('sign = "+x"', 'sign = "magnitude"'),
        ("{{ h.value }}", "{{ h }}"),
        ("-omega*h", "omega*r"),
    )
    report = check(read_template("crank", text), sample=200)
    assert report.instances
    assert any("easier" in each for each in all_said(report.remarks)) == remarked


def test_the_command_ends_with_status_1_for_a_faulty_template(tmp_path: Path) -> None:
    file = tmp_path / "crank.toml"
    file.write_text(UNPUBLISHED, encoding="utf-8")
    result = CliRunner().invoke(main, ["check", str(file)])
    assert result.exit_code == 1
    assert result.stdout.startswith("crank: FAULTY\n")
    assert "remark: no published result" in result.stdout
    assert CliRunner().invoke(main, ["check", "slider-crank"]).exit_code == 0


WIDE = (
    ("draw = [1, 2]", 'draw = "1 .. 2 step 0.1"'),
    ('[0, "1/2", 3]', '"0.1 .. 0.9 step 0.1"'),
    ("[2, 1000000, 20000000]", '"2 .. 9 step 1"'),
)


TWICE = (
    "\n[asks]\n",
    '\n[asks]\nw = { quantity = "-x(velocity(A))", unit = "m/s", sign = "-x", points = 1, means = '
    '{ en = "to the left", zh = "向左" } }\n',
)


def test_an_ask_that_pays_twice_for_one_answer_is_a_fault(tmp_path: Path) -> None:
    file = tmp_path / "crank.toml"
    file.write_text(crank_text(*WIDE, TWICE), encoding="utf-8")
    result = CliRunner().invoke(main, ["check", str(file)])
    assert result.exit_code == 1
    assert (
        "  fault: v_x equals w in almost all instances, signs apart, so that one answer earns points "
        "twice: give points to one of them\n"
    ) in result.stdout
    file.write_text(crank_text(*WIDE, (TWICE[0], TWICE[1].replace("points = 1, ", ""))), "utf-8")
    assert "equals" not in CliRunner().invoke(main, ["check", str(file)]).stdout


def test_two_equal_answers_in_a_few_instances_are_chance() -> None:
    assert all_said(check(crank(*WIDE, TWICE), sample=9).faults) == []


def on_request(quantity: str, unit: str, flags: str = "") -> tuple[str, str]:
    """A further ask without points."""
    line = (
        f'w = {{ quantity = "{quantity}", unit = "{unit}", {flags}means = {{ en = "w", zh = "w '
        f'量" }} }}'
    )
    return "\n[asks]\n", f"\n[asks]\n{line}\n"


def test_an_ask_on_request_that_fails_at_every_value_is_one_fault() -> None:
    report = check(crank(*WIDE, on_request("y(velocity(A))/(r - r)", "1/s")), sample=20)
    assert len(all_said(report.faults)) == 1
    assert all_said(report.faults)[0].startswith("asks.w: at r = ")
    assert all_said(report.faults)[0].endswith(": division by zero: check the values given")
    assert report.proved == 5


def test_an_ask_with_points_that_fails_is_one_fault() -> None:
    changed = ('quantity = "x(velocity(A))"', 'quantity = "x(velocity(A))*r/(h - h)"')
    (fault,) = all_said(check(crank(*WIDE, changed), sample=20).faults)
    assert fault.startswith("asks.v_x: at r = ")
    assert fault.endswith(": division by zero: check the values given")


def test_another_secret_looks_at_other_instances() -> None:
    template = load_template("slider-crank")
    first, again, other = (
        list(choose_drawable(template, 20, secret)) for secret in ("a", "a", "b")
    )
    assert first == again != other
    report = check(template, 20, "b")
    assert (report.secret, all_said(report.faults)) == ("b", [])


def test_an_ask_on_request_that_fails_at_one_drawn_value_is_a_fault() -> None:
    report = check(crank(*WIDE, on_request("omega(OA)/abs(r/h - 15)", "rad/s")), sample=1_000)
    assert [fault.split(": ", 1)[0] for fault in all_said(report.faults)] == ["asks.w"]
    assert "asks.w: at r = 1.5, h = 0.1, " in all_said(report.faults)[0]


def test_an_ask_on_request_without_any_answer_to_ask_for_is_a_fault() -> None:
    zero = on_request("alpha(OA)", "rad/s^2")
    assert all_said(check(crank(*WIDE, zero), sample=20).faults) == [
        "asks.w: no drawn instance has an answer to ask for: w is zero: "
        "ask for something else, or, where zero is a proper answer, write vanishes = true and leave "
        "its points to the bank"
    ]
    allowed = on_request("alpha(OA)", "rad/s^2", "vanishes = true, ")
    assert all_said(check(crank(*WIDE, allowed), sample=20).faults) == []


def test_a_mechanism_that_never_moves_is_one_fault() -> None:
    loose = crank(*WIDE, ('joints = ["pin O: ground OA"]', "joints = []"))
    (fault,) = all_said(check(loose, sample=20).faults)
    assert fault.startswith("no drawn instance can be solved: at r = ")
    assert fault.endswith("(2 degrees of freedom left): add a joint or a driver")


def test_a_template_whose_asks_are_all_on_request_is_checked(tmp_path: Path) -> None:
    text = crank_text(
        *WIDE, ("points = 2, ", ""), ('conditions = ["omega < 10000000"]', "conditions = []")
    )
    file = tmp_path / "crank.toml"
    file.write_text(text, encoding="utf-8")
    result = CliRunner().invoke(main, ["check", str(file), "--sample", "20"])
    assert (result.exit_code, result.exception) == (0, None)
    assert result.stdout.startswith("crank: sound\n")
    for arguments in (["show"], ["gallery"], ["solve", "--set", "h=1/2"]):
        output = str(tmp_path / f"{arguments[0]}.pdf")
        result = CliRunner().invoke(main, [*arguments, str(file), "-o", output])
        assert (result.exit_code, result.exception) == (0, None)
        assert Path(output).stat().st_size > 1000


@pytest.mark.parametrize(
    ("draw", "values"),
    [
        ('["0.002", "0.004"]', ["0.002", "0.004", "0.00225", "0.00375"]),
        ("[1, -1]", ["1", "-1"]),
        ("[3]", ["3"]),
        ('["1000000", "3000000"]', ["1000000", "3000000", "1250000", "2750000"]),
        ('["sqrt(2)", "1"]', ["sqrt(2)", "1", "1.052", "1.362"]),
    ],
)
def test_only_drawable_values_and_their_neighbours_are_probed(draw: str, values: list[str]) -> None:
    template = crank(("draw = [1, 2]", f"draw = {draw}"))
    assert list_probed(template, template.parameters["r"]) == values


def test_no_value_breaks_a_template_that_could_never_be_drawn() -> None:
    """A radius of 2 or 4 mm is no radius of 0.00 m, and a side of 1 or -1 is not 0."""
    small = crank(
        ("draw = [1, 2]", 'draw = ["0.002", "0.004"]'),
        ('[0, "1/2", 3]', "[1, -1]"),
        ('"(0, h)"', '"(0, r*h/(2*abs(h)))"'),
        ("[2, 1000000, 20000000]", '"2 .. 600 step 1"'),
        ('gives = { v_x = "-omega*h" }', 'gives = { v_x = "-omega*r*h/(2*abs(h))" }'),
    )
    assert not [fault for fault in all_said(check(small, sample=60).faults) if "breaks" in fault]


def test_the_report_is_in_the_language_of_the_terminal(tmp_path: Path) -> None:
    file = tmp_path / "crank.toml"
    file.write_text(crank_text(), encoding="utf-8")
    chinese = CliRunner(env={"LC_ALL": "zh_CN.UTF-8"})
    shown = chinese.invoke(main, ["check", str(file), "--sample", "18", "--jobs", "1"])
    assert shown.exit_code == 1
    assert shown.stdout.startswith("crank：有误\n  齐全的语言：en、zh\n")
    assert "拒绝：大小不合理 2、不合条件 6、退化 4、机构不成立 4\n" in shown.stdout
    assert (
        "  错误：v_x 在所有实例中答案相同：学生会猜到：请在此不给分（题库仍可要求），或改求别的量\n"
    ) in shown.stdout


def test_the_other_way_in_which_a_mechanism_closes_is_said() -> None:
    found = all_said(write_findings(check(load_template("slider-crank"), sample=40)))
    assert (
        'B is "right"; with "left" it closes as well in 100% of the draws: -o FILE shows both'
    ) in found


@pytest.mark.parametrize(
    ("taken", "other"),
    [
        ("right", "left"),
        ("left of A->O", "right of A->O"),
        ("right of A->O", "left of A->O"),
    ],
)
def test_the_other_assembly_takes_the_other_common_point(taken: str, other: str) -> None:
    template = read_template("slider-crank", SLIDER.replace(", right)", f", {taken})"))
    (assembly,) = find_other_assemblies(template)
    assert (assembly.point, assembly.taken, assembly.other) == ("B", taken, other)
    solution = solve_template(template, {"phi": "30", "r": "1/5", "k": "2"})
    closed = close_otherwise(solution, assembly)
    assert closed is not None
    here, there = (each.doubles.points["B"].x for each in (solution, closed))
    middle = solution.doubles.points["A"].x
    assert here - middle == pytest.approx(middle - there)
    assert here != there


def test_what_does_not_close_is_no_other_assembly() -> None:
    right_alone = ', right)"\nQ = "(sqrt(r*x(B)), 0)"'
    template = read_template("slider-crank", SLIDER.replace(', right)"', right_alone))
    (assembly,) = find_other_assemblies(template)
    solution = solve_template(template, {"phi": "30", "r": "1/5", "k": "2"})
    assert close_otherwise(solution, assembly) is None


def test_check_draws_both_assemblies(tmp_path: Path) -> None:
    sheet = tmp_path / "both.pdf"
    arguments = ["check", "slider-crank", "--sample", "8", "-o", str(sheet), "--lang", "en"]
    assert CliRunner().invoke(main, arguments).exit_code == 0
    printed = subprocess.run(["pdftotext", sheet, "-"], capture_output=True, text=True, check=True)
    assert "left" in printed.stdout


def test_check_draws_a_file_that_is_in_one_language(tmp_path: Path) -> None:
    text = re.sub(
        r', zh = "[^"]*"|\n?zh = (?:"[^"]*"|\'\'\'[\s\S]*?\'\'\')', "", write_starter_text()
    )
    path, sheet = tmp_path / "german.toml", tmp_path / "both.pdf"
    path.write_text(re.sub(r"\ben = ", "de = ", text), encoding="utf-8")
    arguments = ["check", str(path), "--sample", "4", "-o", str(sheet)]
    done = CliRunner().invoke(main, arguments, env={"LC_ALL": "en_GB.UTF-8"})
    assert "no text in" not in done.output
    assert sheet.exists()
