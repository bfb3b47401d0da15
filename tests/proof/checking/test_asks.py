"""Asks whose answers earn points too easily, cannot be had, or are not what papers would say."""

from __future__ import annotations

from pathlib import Path

from click.testing import CliRunner

from kinegrade.cli import main
from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof.checking import check
from tests.problem.crank import crank, crank_text
from tests.proof.checking.changed import WIDE
from tests.said import all_said


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


def test_an_answer_that_is_always_zero_may_carry_points_where_its_author_says_so() -> None:
    at_rest = ('quantity = "x(velocity(A))"', 'quantity = "x(velocity(O))", vanishes = true')
    said_so = read_template("crank", crank_text(at_rest, ('"-omega*h"', '"0"')))
    assert not [each for each in all_said(check(said_so).faults) if "v_x" in each]
    silent = crank_text(at_rest, ('"-omega*h"', '"0"'), (", vanishes = true", ""))
    assert not check(read_template("crank", silent)).is_sound


def test_an_answer_that_copies_a_given_is_a_fault() -> None:
    """The speed of the crank's end is omega r; with h = 0 and r = 1 it is omega, signs apart."""
    copying = crank(
        ("draw = [1, 2]", "draw = [1]"),
        ('[0, "1/2", 3]', "[0]"),
        ("[2, 1000000, 20000000]", '"1 .. 900 step 1"'),
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
    assert report.distinct == 900


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


def test_an_answer_of_which_the_sense_is_not_marked_is_a_fault() -> None:
    """Of the difference of two terms that are alike to a quarter of a per cent, 1 % of the larger
    is allowed, and the other sense is right.
    """
    alike = ('quantity = "x(velocity(A))"', 'quantity = "x(velocity(A)) + 399*omega*h/400"')
    heights = ('draw = [0, "1/2", 3]', 'draw = ["1/2", "3/4"]')
    report = check(
        crank(alike, heights, ('gives = { v_x = "-omega*h" }', 'gives = { v_x = "-omega*h/400" }')),
        4,
    )
    assert [each for each in all_said(report.faults) if "sense" in each] == [
        "v_x: in 100% of the instances zero and the other sense count as right, as larger terms "
        "cancel in the answer - ask for a quantity in which they do not, or give it no points"
    ]
