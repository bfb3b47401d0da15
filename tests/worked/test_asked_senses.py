"""What a question counts downwards has one sign from its first table to its box."""

from __future__ import annotations

from kinegrade.worked.document import TermTable
from tests.worked.draws import stated
from tests.worked.telling import boxed, displayed, proses

PRESS = {"l": "290", "m": "280", "beta": "-35", "v": "140"}


def test_a_guided_point_moves_positive_in_the_sense_of_the_question() -> None:
    """v_D was 196.1 mm/s upwards, then stood with a minus before the box."""
    blocks = stated("toggle-press", **PRESS)
    directions = [
        term.direction
        for block in blocks
        if isinstance(block, TermTable)
        for term in block.terms
        if term.direction in ("$+y$", "$-y$")
    ]
    assert directions == ["$-y$", "$-y$"]
    (line,) = (line for line in displayed(blocks) if line.startswith("v_{D} &="))
    assert line.endswith(r"\approx -196.1\,\unit{mm/s}\quad\text{(upwards)}")
    assert r"-196.1\,\unit{mm/s}" in boxed(blocks)
    assert not any("asked for" in text for text in proses(blocks))
