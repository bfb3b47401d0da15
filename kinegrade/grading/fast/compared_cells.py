"""Cells compared with the right answers of their papers."""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.exam.folder.columns.gathering import find_decimals, read_centres
from kinegrade.exam.folder.keys import Keys
from kinegrade.grading.fast.bounds import Flags, Places, Rules
from kinegrade.grading.fast.comparison import Comparison, compare
from kinegrade.grading.fast.typed_cells import TypedCells


def compare_cells(cells: TypedCells, papers: Sequence[Keys], rules: Rules) -> Comparison:
    """Compares the cells of rows with the keys of the paper of each row."""
    centres = read_centres(papers)

    def are_decimals(places: Places) -> Flags:
        found = cells.decimals[places]
        found[found] = find_decimals(papers, places[found], len(cells.reader.asks))
        return found

    return compare(cells.compared, centres.reshape(-1), rules, are_decimals)
