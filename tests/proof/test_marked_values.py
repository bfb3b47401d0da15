"""`check` says where a dimension, a radius or an arc carries the letter of a given and shows another
value.
"""

from __future__ import annotations

from dataclasses import replace

import pytest
from msgspec import structs

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.library.starter import write_starter_text
from kinegrade.problem.template.template import Template
from kinegrade.proof.checking import check
from kinegrade.proof.marked_values import find_wrong_marks
from tests.said import all_said

OWN = "mark the points that it measures, or give the mark another letter"
AT = {"r": "3/10", "b": "1/2", "phi": "30", "omega": "2"}


def starter(before: str, after: str) -> Template:
    """The starter, a crank OA whose block slides in the slot CB, with other marks."""
    text = write_starter_text()
    assert before in text
    return read_template("rocker", text.replace(before, after))


def find(template: Template, values: dict[str, str]) -> list[str]:
    """What is wrong with the marks of an instance."""
    return all_said(find_wrong_marks(template, [solve_template(template, values, ())]))


@pytest.mark.parametrize(
    ("before", "after", "said"),
    [
        (
            'symbol = "r", from = "O", to = "A"',
            'symbol = "r", from = "C", to = "A"',
            "figure: r stands at CA, which is 0.7 m where r is 0.3 m",
        ),
        (
            'symbol = "b", from = "C", to = "O"',
            'symbol = "b", from = "C", to = "A", along = "horizontal"',
            "figure: b stands at CA, which is 0.2598 m where b is 0.5 m",
        ),
        (
            'at = "O", from = "right", to = "A"',
            'at = "O", from = "up", to = "A"',
            "figure: phi stands at up, O, A, which is 60° where phi is 30°",
        ),
    ],
)
def test_a_mark_at_another_place_is_a_fault(before: str, after: str, said: str) -> None:
    assert find(starter(before, after), AT) == [f"{said} - {OWN}"]


@pytest.mark.parametrize(("phi", "shown"), [("30", "330°"), ("-30", "")])
def test_an_arc_the_other_way_round_than_its_given_is_a_fault(phi: str, shown: str) -> None:
    arc = 'at = "O", from = "right", to = "A"'
    said = [f"figure: phi stands at right, O, A, which is {shown} where phi is 30° - {OWN}"]
    turned = starter(arc, f'{arc}, sense = "cw"')
    assert find(turned, {**AT, "phi": phi}) == (said if shown else [])


def test_an_arc_as_its_given_is_counted_is_none() -> None:
    for phi in ("-30", "30", "210"):
        assert find(starter("", ""), {**AT, "phi": phi}) == []


def test_a_fault_of_a_mark_is_one_of_the_check() -> None:
    wrong = starter('symbol = "r", from = "O", to = "A"', 'symbol = "r", from = "C", to = "A"')
    assert "r stands at CA" in "\n".join(all_said(check(wrong, sample=12).faults))


def test_a_radius_of_another_wheel_is_a_fault() -> None:
    template = load_template("crossed-belt-drive")
    values = {name: given.choices[0] for name, given in template.parameters.items()}
    first, second = template.figure.radii
    swapped = (replace(first, centre=second.centre), replace(second, centre=first.centre))
    figure = replace(template.figure, radii=swapped)
    assert find(template, values) == []
    assert find(structs.replace(template, figure=figure), values) == [
        f"figure: r1 stands at A, which is {values['r2']} m where r1 is {values['r1']} m - {OWN}",
        f"figure: r2 stands at O, which is {values['r1']} m where r2 is {values['r2']} m - {OWN}",
    ]


@pytest.mark.parametrize("angle", ["-30", "210", "180"])
def test_angles_count_with_any_sense_and_number_of_turns(angle: str) -> None:
    assert find(read_template("rocker", write_starter_text()), {**AT, "phi": angle}) == []
