"""The check at the end of a chapter uses printed values alone, and agrees."""

from __future__ import annotations

import re
from dataclasses import dataclass

import pytest

from kinegrade.language.math.reading import read_math
from kinegrade.problem.template.library.library import find_template_names
from kinegrade.worked.document import Prose
from tests.worked.draws import drawn, kept
from tests.worked.reader.amounts import Amount, Unreadable
from tests.worked.reader.formula_reader import read_formula

CHECK = re.compile(
    r"^Check by the projection on (?P<axis>.*), which has not been used: "
    r"left side \$(?P<left>.*)\$, right side \$(?P<right>.*)\$; they agree\.$"
)
RELATION = re.compile(r"=|\\approx")
CHECKED = (
    "bar-through-swivelling-sleeve",
    "five-bar-two-driven-cranks",
    "pin-in-disc-slot-and-rod",
    "rocker-driven-by-two-slider-link",
    "slotted-rocker-and-slider-two-drivers",
)


@dataclass(frozen=True)
class Check:
    """The axis, and each side with its value."""

    axis: str
    left: str
    right: str


def read_checks(name: str, place: int = 0) -> list[Check]:
    texts = [block.text for block in kept(name, place) if isinstance(block, Prose)]
    return [Check(**found.groupdict()) for text in texts if (found := CHECK.match(text))]


def read_side(side: str) -> list[Amount]:
    """What a side is worth as it is printed: the sum, and the value said of it."""
    return [read_formula(read_math(part.strip(), "test"), refuse) for part in RELATION.split(side)]


def refuse(symbol: str) -> Amount:
    """A check has no symbols."""
    raise Unreadable(symbol)


def test_a_rod_is_checked_along_the_axis_that_is_left() -> None:
    assert read_checks("slider-crank")[0] == Check(
        "the $x$ axis",
        r"1.155\,\unit{m/s}",
        r"1\,\unit{m/s} \cdot \sin 60^\circ + 0.5774\,\unit{m/s} \cdot \sin 30^\circ"
        r" \approx 1.155\,\unit{m/s}",
    )


@pytest.mark.parametrize("name", find_template_names())
def test_all_that_a_check_says_of_both_sides_agrees(name: str) -> None:
    for place in range(len(drawn(name))):
        for check in read_checks(name, place):
            said = [*read_side(check.left), *read_side(check.right)]
            for one in said[1:]:
                assert one.value == pytest.approx(said[0].value, abs=said[0].room + one.room + 1e-9)


@pytest.mark.parametrize("name", find_template_names())
def test_a_check_ends_with_the_same_value_on_both_sides(name: str) -> None:
    for check in read_checks(name):
        left, right = (RELATION.split(side)[-1].strip() for side in (check.left, check.right))
        assert left == right


@pytest.mark.parametrize("name", CHECKED)
def test_relations_with_an_axis_to_spare_have_a_check(name: str) -> None:
    assert read_checks(name)


def test_a_check_that_nobody_reads_at_a_glance_is_left_out() -> None:
    (only,) = read_checks("five-bar-two-driven-cranks", 1)
    assert r"\unit{m/s}" in only.left
