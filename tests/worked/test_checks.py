"""The check at the end of a chapter uses printed values alone, and agrees."""

from __future__ import annotations

import re

import pytest
from tests.worked.printed_values import worth

from kinegrade.problem.template.library.library import find_template_names
from kinegrade.worked.document import Prose
from tests.worked.draws import drawn, kept

CHECK = re.compile(r"^Check by the projection on (.*), which has not been used: \$(.*)\$\.$")


def read_checks(name: str, place: int = 0) -> list[tuple[str, str]]:
    """The axis and the equation of each check."""
    texts = [block.text for block in kept(name, place) if isinstance(block, Prose)]
    return [(found[1], found[2]) for text in texts if (found := CHECK.match(text))]


def test_a_rod_is_checked_along_the_axis_that_is_left() -> None:
    assert read_checks("slider-crank")[0] == (
        "the $x$ axis",
        r"\cos 30^\circ + 0.5774\cos 60^\circ \approx 1.155",
    )


@pytest.mark.parametrize("name", find_template_names())
def test_both_sides_of_a_check_agree(name: str) -> None:
    for place in range(len(drawn(name))):
        for _, equation in read_checks(name, place):
            left, right = (worth(side, {}) for side in equation.split(r"\approx"))
            assert left.value == pytest.approx(right.value, abs=left.room + right.room + 1e-9)


def test_most_templates_have_a_check() -> None:
    checked = [name for name in find_template_names() if read_checks(name)]
    assert len(checked) > 15
