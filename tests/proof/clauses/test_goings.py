"""`check` finds the senses of parts that statements name by nouns, driven by an input or not."""

from __future__ import annotations

import pytest

from tests.proof.clauses.drum import find_faults


@pytest.mark.parametrize(
    ("mechanism", "right", "wrong"),
    [
        ("drum", "The drum rotates counterclockwise.", ("counterclockwise", "clockwise")),
        ("drum", "Load $A$ is descending.", ("descending", "ascending")),
        ("drum", "The load $B$ is moving upward with the rope.", ("upward", "downward")),
        ("drum", "The drum is turning in the counter-clockwise sense.", ("counter-clock", "clock")),
        ("drum", "Load $A$ moves downwards; it is lowered.", ("lowered", "lifted")),
        ("slider", "The slider moves to the left.", ("left", "right")),
        ("slider", "Die Kurbel $OA$ dreht sich gegen den Uhrzeigersinn.", ("gegen den", "im")),
        ("slider", "The crank rotates anticlockwise.", ("anticlockwise", "clockwise")),
    ],
)
def test_a_sense_that_nothing_has_that_may_be_meant_is_a_fault(
    mechanism: str, right: str, wrong: tuple[str, str]
) -> None:
    assert find_faults(mechanism, right) == []
    [fault] = find_faults(mechanism, right.replace(*wrong))
    assert fault.startswith('statement: it says "')
    assert fault.endswith('", and all instances go the other way')


@pytest.mark.parametrize(
    "said",
    [
        "The thing rotates clockwise.",
        "Seen from the back, the drum rotates clockwise.",
        "If the load $A$ were ascending, the drum would turn clockwise.",
        "The drum does not rotate clockwise.",
        "The load $A$ moves up or down.",
        "Angular velocities are positive clockwise.",
        "The drum turns the wheel clockwise.",
        "The load $A$ moves along a line, which leads upwards.",
        "Load $A$ moves and is speeding up.",
    ],
)
def test_what_cannot_be_decided_is_no_fault(said: str) -> None:
    assert find_faults("drum", said) == []
