"""The coordinates that are zero where a point of the mechanism is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.problem.solution import Solution
from kinegrade.problem.template.notation import write_point_symbol
from kinegrade.worked.case import write_row
from kinegrade.worked.document import Block
from tests.worked.reader.equations import Line, read_page
from tests.worked.reader.formula_reader import name_symbol


def find_rounded_away(blocks: Sequence[Block], solution: Solution) -> Iterator[str]:
    """The lines that find a coordinate of a point to be about 0, where its track says that it is."""
    points = [write_point_symbol(name) for name in solution.template.scheme.points]
    coordinates = {f"{axis}_{{{letter}}}" for axis in "xy" for letter in points}
    for part in read_page(blocks):
        if isinstance(part, Line) and part.sides and name_symbol(part.left) in coordinates:
            end = part.sides[-1]
            if end.relation == r"\approx" and write_row(end.row) == "0":
                yield part.text
