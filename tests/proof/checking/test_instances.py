"""The draws at which a template is looked at: how many are accepted, and what is special in
some.
"""

from __future__ import annotations

import re

import pytest

from kinegrade.problem.template.library.library import (
    find_shipped,
    find_template_names,
    load_template,
)
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.checking import check, choose_drawable
from kinegrade.proof.reporting import write_verdict
from tests.problem.crank import crank, crank_text
from tests.proof.checking.changed import WIDE
from tests.said import all_said, said

# Draws of a template, until one of them may be dealt; those of `kinegrade check` are the most
SAMPLES = 8, 21, 55, 200


@pytest.mark.sampled(27)  # "sound templates" of `make prove` looks at each at more instances
@pytest.mark.parametrize("name", find_template_names())
def test_shipped_templates_are_sound(name: str) -> None:
    reports = (check(load_template(name), sample) for sample in SAMPLES)
    report = next((each for each in reports if each.instances), None)
    assert report is not None
    assert all_said(report.faults) == []
    assert report.proved >= 1
    remarks = all_said(report.remarks)
    assert not [each for each in remarks if "which are easier" in each or "tags that" in each]


def test_two_instances_of_many_with_one_answer_are_no_fault() -> None:
    """Two gears happen to have the same numbers of teeth in the first two draws that are accepted:
    in the others the answer differs.
    """
    report = check(load_template("epicyclic-train-by-tooth-counts"), sample=8)
    first, second = report.spreads["v_P"].values
    assert first == pytest.approx(second)
    assert all_said(report.faults) == []


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
    assert [said for said in all_said(check(crank(), sample=200).remarks) if remark in said] == []


def test_a_sample_without_an_accepted_draw_is_no_fault_and_never_sound() -> None:
    looks = (check(load_template("slider-crank"), sample=1, secret=each) for each in "abcdefghij")
    report = next(each for each in looks if not each.instances)
    assert report.faults == []
    assert not report.is_sound
    assert said(write_verdict(report)) == "slider-crank: undecided, no draw was accepted"
    assert all_said(report.remarks) == [
        "no published result for alpha_AB, a_B - [[published]] with values found otherwise would "
        "prove them",
        "accepted 0 of 1: too few draws to tell whether there are 500 distinct instances: "
        "examine 200 with --sample",
    ]


@pytest.mark.parametrize(("most", "enough", "secret"), [(480, False, "a"), (520, True, "b")])
def test_the_verdict_on_the_number_of_instances_is_that_of_all_of_them(
    most: int, enough: bool, secret: str
) -> None:
    """Of 700 combinations as many are accepted; a sample of 200 alone may tell either way."""
    counted = crank(
        ("draw = [1, 2]", "draw = [1]"),
        ('[0, "1/2", 3]', '["1/2"]'),
        ("[2, 1000000, 20000000]", '"1 .. 700 step 1"'),
        ("omega < 10000000", f"omega <= {most}"),
    )
    report = check(counted, sample=200, secret=secret)
    fault = (
        f"about {most} distinct instances: at least 500 are needed for a class: widen the domains"
    )
    assert (fault in all_said(report.faults)) != enough
    assert [each for each in all_said(report.remarks) if "too few draws to tell" in each] == []


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
    assert ("easier" in "\n".join(all_said(report.remarks))) == remarked


def test_another_secret_looks_at_other_instances() -> None:
    template = load_template("slider-crank")
    first, again, other = (
        list(choose_drawable(template, 20, secret)) for secret in ("a", "a", "b")
    )
    assert first == again != other
    report = check(template, 20, "b")
    assert (report.secret, all_said(report.faults)) == ("b", [])


def test_a_mechanism_that_never_moves_is_one_fault() -> None:
    loose = crank(*WIDE, ('joints = ["pin O: ground OA"]', "joints = []"))
    (fault,) = all_said(check(loose, sample=20).faults)
    assert fault.startswith("no drawn instance can be solved: at r = ")
    assert fault.endswith("(2 degrees of freedom left): add a joint or a driver")


def test_a_family_in_capitals_is_remarked_on() -> None:
    report = check(read_template("crank", crank_text(('family = "crank"', 'family = "Crank"'))))
    assert (
        'family: families are in small letters, and "Crank" is another one than "crank" to lists '
        'and banks - did you mean "crank"?' in all_said(report.remarks)
    )


def test_a_statement_is_held_against_draws_of_which_none_is_accepted() -> None:
    """A guide said to be vertical went through without a word, as nothing was there to compare."""
    text = (find_shipped("templates") / "slider-crank.toml").read_text(encoding="utf-8")
    false = read_template("slider-crank", text.replace("horizontal guide", "vertical guide"))
    looks = (check(false, sample=2, secret=each) for each in "abcdefghijklmnop")
    report = next(each for each in looks if not each.instances)
    assert any('"vertical guide"' in each for each in all_said(report.faults)), report.refused
