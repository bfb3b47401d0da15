"""The check says why draws are refused: which condition, symbol, ask and mistake, in how many, and
at which value of a given.
"""

from __future__ import annotations

from kinegrade.draws.examining import Refused
from kinegrade.language.message import Message
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.causes import find_causes, write_causes
from kinegrade.proof.checking import check, choose_drawable
from tests.problem.crank import crank
from tests.said import all_said, said


def test_each_condition_is_told_with_its_share_and_the_value_to_blame() -> None:
    said = all_said(check(crank(), sample=200).causes)
    blamed = "nearly all at omega = 20000000 rad/s: leave that value out"
    assert f"refused, condition: omega < 10000000: 6 of 18, {blamed}" in said


def test_a_number_that_stands_alone_beside_a_unit_that_is_none_of_si_is_told() -> None:
    millimetres = ('{ unit = "m", draw = [1, 2]', '{ unit = "mm", draw = [1000, 2000]')
    condition = ("omega < 10000000", "r >= h + 20")  # 20 mm are meant
    [told] = all_said(check(crank(millimetres, condition), sample=200).causes)
    meaning = "numbers in conditions are in SI, not in the unit of r"
    assert told == f"refused, condition: r >= h + 20: 18 of 18 ({meaning})"
    plain = all_said(check(crank(("omega < 10000000", "r >= h + 20")), sample=200).causes)
    assert plain == ["refused, condition: r >= h + 20: 18 of 18"]
    product = all_said(
        check(crank(millimetres, ("omega < 10000000", "r >= 20*h + 2*r")), 20).causes
    )
    assert product == ["refused, condition: r >= 20*h + 2*r: 18 of 18"]


def test_ask_and_mistake_are_named() -> None:
    said = all_said(check(load_template("slider-crank"), sample=60).causes)
    assert [
        line for line in said if line.startswith("refused, mistake: v_B: sine-for-cosine lands")
    ]
    zero = "refused, degenerate: omega_AB is zero: "
    [told] = [line for line in said if line.startswith(zero)]
    assert told.endswith(" of 60, nearly all at phi = 90 °: leave that value out")


def test_what_differs_in_its_numbers_alone_is_one_cause() -> None:
    said = all_said(check(crank(), sample=200).causes)
    assert [line.split(":")[0] for line in said].count("refused, mechanism") == 1
    assert [line.split(":")[0] for line in said].count("refused, absurd") <= 2  # two asks


def test_what_solving_takes_and_the_tags_that_it_lacks_are_said() -> None:
    text = load_template("rotary-engine").file.text
    report = check(read_template("engine", text.replace('"coriolis", "machine", ', "")), sample=5)
    assert said(report.demands) == "difficulty: 1 of 5; about 12 minutes"
    assert "tags that would let banks find it: coriolis" in all_said(report.remarks)


def test_tags_that_follow_from_joints_and_misspelt_ones_are_said() -> None:
    text = load_template("epicyclic-train-by-tooth-counts").file.text
    own = text.replace('tags = ["gears", "rolling"]', 'tags = ["gear", "rolling", "exam-2026"]')
    remarks = all_said(check(read_template("train", own), sample=5).remarks)
    listed = "kinegrade words tags does not list it"
    assert f'tag "gear": {listed} - did you mean "gears"?' in remarks
    assert "tags that would let banks find it: gears" in remarks
    assert not [each for each in remarks if "exam-2026" in each]


def test_values_that_do_not_go_together_by_default_are_remarked() -> None:
    report = check(
        crank(
            ("draw = [1, 2]", "draw = [1, 4]"),
            ('h     = { unit = "m", draw = [0', 'h     = { unit = "m", draw = [2'),
        ),
        sample=20,
    )
    assert [
        each
        for each in all_said(report.remarks)
        if each.startswith("it cannot be solved at its published")
    ]


def test_a_refused_figure_is_told_with_what_would_help() -> None:
    template = load_template("slider-crank")
    draws = list(choose_drawable(template, 4))
    refused = Refused("figure", Message("figure.symbol-crowded", symbol="A"))
    (line,) = write_causes(template, find_causes(draws, [refused] * 4), draws)
    assert said(line).endswith(
        " - fewer marks, a letter left out (labels = { A = false }) or values that keep points "
        "farther apart would help"
    )
