"""The polygon of a step follows the table above it, and is there where vectors are added."""

from __future__ import annotations

from collections.abc import Sequence

from kinegrade.worked.case import write_row
from kinegrade.worked.document import Block, Pictures, TermTable
from tests.worked.draws import stated


def list_tables(blocks: Sequence[Block]) -> list[list[str]]:
    return [
        [write_row(term.symbol) for term in block.terms]
        for block in blocks
        if isinstance(block, TermTable)
    ]


def test_vectors_that_change_places_in_a_polygon_do_so_in_the_table() -> None:
    # a_B^n would lie on a_A^n, as the crank and the rocker are parallel
    table = list_tables(stated("bent-coupler-instant-translation"))[-1]
    assert table == [
        r"\boldsymbol{a}_{B}^{\mathrm{t}}",
        r"\boldsymbol{a}_{B}^{\mathrm{n}}",
        r"\boldsymbol{a}_{A}^{\mathrm{n}}",
        r"\boldsymbol{a}_{BA}^{\mathrm{t}}",
    ]


def test_a_point_of_two_bodies_has_one_acceleration_and_no_polygon() -> None:
    blocks = stated("planetary-gear-external-rim-accelerations")
    assert [block for block in blocks if isinstance(block, Pictures)] == []
