"""The figure of another student is another picture, for every template."""

from __future__ import annotations

from pathlib import Path

from tests.figures.likeness import list_alike
from tests.figures.sheet import deal_figures
from tests.figures.svg_shapes import read_picture
from tests.prove.draws import seeded_template

PAPERS = 8  # of which every two are compared


def hold(seed: int, _: Path) -> None:
    """Compare the figures of the papers that are dealt at a seed."""
    name = seeded_template(seed).name
    figures = deal_figures(name, f"prove {seed}", PAPERS)
    assert list_alike(name, list(map(read_picture, figures))) == []
