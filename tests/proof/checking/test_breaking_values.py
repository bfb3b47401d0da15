"""Values at which a template breaks are searched for among those that can be drawn and beside
them.
"""

from __future__ import annotations

import pytest

from kinegrade.problem.template.library.reading import read_template
from kinegrade.proof import searching
from kinegrade.proof.checking import check
from kinegrade.proof.neighbours import list_probed
from kinegrade.proof.reach import find_condition
from tests.problem.crank import crank, crank_text
from tests.said import all_said


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
    assert [
        (name, value)
        for name, value in found[0].items()
        if value not in template.parameters[name].choices
    ] == []


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
