"""Printed figures have no flaw at any draw: the SVG is read and measured by geometry of its own."""

from __future__ import annotations

from pathlib import Path

from tests.figures.known import drop_known
from tests.figures.printed import read_printed
from tests.prove.draws import seeded_solution, seeded_template


def hold(seed: int, _: Path) -> None:
    """Print the figure of the instance of a seed and look for flaws."""
    name = seeded_template(seed).name
    found = drop_known(name, read_printed(seeded_solution(seed)).find_all_flaws())
    assert found == [], f"{name}: {'; '.join(found)}"
