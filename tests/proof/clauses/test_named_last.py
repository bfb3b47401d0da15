"""A sentence that is false of what it speaks of is a fault, even if what is named last before the
side happens to lie there.
"""

from __future__ import annotations

import pytest

from tests.proof.clauses.drum import find_all_faults


@pytest.mark.parametrize(
    ("mechanism", "right"),
    [
        # the slider B lies below O, the pin A above it
        ("slider", "The slider $B$, joined to the crank at $A$, lies below $O$."),
        ("slider", "The slider $B$ is driven by the pin $A$ and lies below $O$."),
        ("slider", "The slider $B$, which is driven by the pin $A$, is lower than $O$."),
        ("slider", "The slider $B$, whose rod has the end $A$, lies below $O$."),
        ("slider", "Das Gleitstück $B$, das am Zapfen $A$ hängt, liegt tiefer als $O$."),
        # the load A hangs on the left of the drum, the load B on its right
        ("drum", "The load $A$, on the same drum as the load $B$, is to the left of $O$."),
        ("drum", "The load $A$, which balances the load $B$, lies to the left of $O$."),
        ("drum", "The load $A$, which the load $B$ balances, hangs to the left of $O$."),
        ("drum", "The load $A$ balances the load $B$ and hangs to the left of $O$."),
        ("drum", "Die Last $A$, welche die Last $B$ hebt, hängt links von $O$."),
        ("drum", "Die Last $A$ hebt die Last $B$ und hängt links von $O$."),
    ],
)
def test_what_is_named_last_is_not_what_a_sentence_speaks_of(mechanism: str, right: str) -> None:
    assert find_all_faults(mechanism, right) == []
    assert len(find_all_faults(mechanism, _turn(right))) >= 1


def _turn(said: str) -> str:
    """The words with the other side."""
    for word, other in (
        ("left", "right"),
        ("links", "rechts"),
        ("below", "above"),
        ("lower", "higher"),
        ("tiefer", "höher"),
    ):
        if word in said:
            return said.replace(word, other)
    return said


def test_a_side_that_is_said_twice_is_held_against_each_part() -> None:
    both = "$A$ is to the left of $O$. The load $B$, above the floor, hangs to the SIDE of $O$."
    assert find_all_faults("drum", both.replace("SIDE", "right")) == []
    assert len(find_all_faults("drum", both.replace("SIDE", "left"))) >= 1


@pytest.mark.parametrize(
    "said",
    [
        "The crank is pinned at $O$ and $B$ lies to the right of $O$.",
        "The rod joins $A$ with $B$ to the right of $O$.",
        "The crank, of the shape in the figure, turns about $O$, and $B$, its slider, is below $O$.",
        "The pin $A$ drives the slider $B$, and $A$ is higher than $O$.",
        "In the figure, the slider $B$ lies, as drawn, to the right of $O$.",
    ],
)
def test_what_begins_a_new_clause_is_what_that_speaks_of(said: str) -> None:
    assert find_all_faults("slider", said) == []
