"""A projection in letters holds for other numbers too, or says by which lines of this paper it does
not.
"""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.document import Prose
from tests.worked.draws import kept, told
from tests.worked.telling import proses


def _list_alignments(name: str, given: dict[str, str], language: Language = "en") -> list[str]:
    start = {"en": "At this instant $", "de": "In diesem Augenblick gilt", "zh": "此瞬时 $"}[
        language
    ]
    blocks = told(solve_template(load_template(name), given), language=language)
    return [one.text for one in blocks if isinstance(one, Prose) and one.text.startswith(start)]


def test_lines_along_the_axes_by_the_numbers_alone_are_named() -> None:
    """The formulas have no sine of delta in them where OB is upright."""
    assert _list_alignments("bar-pushing-rolling-disc", {}) == [
        r"At this instant $OB \perp x$ and $CB \parallel x$."
    ]


def test_lines_at_right_angles_to_the_axis_of_projection_are_named() -> None:
    """With delta = phi and gamma = phi - 90 degrees the rocker is normal to the link."""
    given = {"phi": "75", "delta": "75", "gamma": "-15"}
    (line,) = _list_alignments("bar-pushing-rolling-disc", given)
    assert r"OB \perp CB" in line


def test_lines_that_lie_so_with_any_numbers_are_not_named() -> None:
    """The coupler is parallel to the ground by its construction, and a projection goes along it."""
    name = "four-bar-parallel-coupler"
    points = solve_template(load_template(name), {}).motion.points
    assert points["B"].y == points["D"].y
    assert "on the direction from $D$ to $B$" in "\n".join(proses(kept(name)))
    assert _list_alignments(name, {}) == []


def test_a_pair_of_lines_is_named_once() -> None:
    """By the velocities from one of them, by the accelerations from the other."""
    lines = _list_alignments("stone-crusher", {})
    assert sum("AB" in line and "GB" in line for line in lines) == 1


@pytest.mark.parametrize(
    ("language", "line"),
    [
        ("de", r"In diesem Augenblick gilt $OB \perp x$ und $CB \parallel x$."),
        ("zh", r"此瞬时 $OB \perp x$ 和 $CB \parallel x$。"),
    ],
)
def test_alignments_are_named_in_each_language(language: Language, line: str) -> None:
    assert _list_alignments("bar-pushing-rolling-disc", {}, language) == [line]
