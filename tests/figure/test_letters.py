"""Every letter that a statement gives stands in the figure of every shipped template."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from kinegrade.figure.scene import Scene
from kinegrade.figure.sketch import sketch
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Fenced, Row
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.given_marks import mark_givens
from kinegrade.problem.template.library.library import find_template_names, load_template
from tests.problem.draws import draw_filter, drawn


def list_rows(scene: Scene) -> Iterator[Row]:
    """The labels of a scene, and what stands between bars in them."""
    for label in scene.labels:
        row = read_math(label.symbol, "figure")
        yield row
        yield from (node.row for node in row if isinstance(node, Fenced))


def occurs(row: Row, rows: list[Row]) -> bool:
    """Whether a symbol is a label, or a factor of one."""
    return any(
        whole[first : first + len(row)] == row for whole in rows for first in range(len(whole))
    )


# A module is no distance between two points
NOT_DRAWN = {("epicyclic-train-by-tooth-counts", "m")}


def list_missing(solution: Solution) -> list[str]:
    """The symbols of the givens other than zero that the figure lacks; a length like AB is named by
    its points.
    """
    template = solution.template
    rows = list(list_rows(sketch(solution.assembly.mechanism.map(float), mark_givens(template))))
    symbols = [
        read_math(template.parameters[name].symbol, "figure")
        for name, given in solution.parameters.items()
        if float(given.value) and (template.name, name) not in NOT_DRAWN
    ]
    return [
        str(symbol)
        for symbol in symbols
        if not occurs(symbol, rows)
        and (len(symbol) == 1 or any(not occurs((letter,), rows) for letter in symbol))
    ]


@pytest.mark.sampled(8)
@pytest.mark.parametrize("name", find_template_names())
def test_every_given_has_its_letter_in_the_figure(name: str) -> None:
    [draw] = drawn(draw_filter(load_template(name)), 1)
    assert list_missing(draw.solution) == []
