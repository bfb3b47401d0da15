"""`check` finds the places of parts that statements name by nouns."""

from __future__ import annotations

import pytest

from tests.proof.clauses.drum import find_faults

LIES = ", and the points of the mechanism lie otherwise: correct the words, or the points"


@pytest.mark.parametrize(
    ("mechanism", "right", "wrong", "said"),
    [
        ("drum", "The load $A$ hangs on the left of the drum.", ("left", "right"), ""),
        (
            "drum",
            "The point $P$ of the rim lies on it, vertically above $O$.",
            ("above", "below"),
            "",
        ),
        ("drum", "It carries load $B$, which hangs to the right of $O$.", ("right", "left"), ""),
        ("drum", "$P$ and the axis $O$ lie above the load $A$.", ("above", "below"), ""),
        ("slider", "The slider lies to the right of $O$.", ("right", "left"), ""),
        ("slider", "The guide passes a distance {{ e }} below $O$.", ("below", "above"), ""),
        ("slider", "It runs at the distance {{ e }} below $O$.", ("$O$", "$A$"), "below $A$"),
        ("slider", "It joins $A$ to the point $H$, {{ e }} below $O$.", ("below", "above"), ""),
        ("slider", "$A$ is higher than the guide.", ("higher", "lower"), ""),
        ("slider", "Der Punkt $A$ liegt höher als $O$.", ("höher", "tiefer"), ""),
        ("slider", "Eine Führung im Abstand {{ e }} lotrecht unter $O$.", ("unter", "über"), "lot"),
    ],
)
def test_a_side_on_which_nothing_lies_that_may_be_meant_is_a_fault(
    mechanism: str, right: str, wrong: tuple[str, str], said: str
) -> None:
    assert find_faults(mechanism, right) == []
    [fault] = find_faults(mechanism, right.replace(*wrong))
    assert fault.startswith('statement: it says "')
    assert said in fault
    assert fault.endswith(LIES)


@pytest.mark.parametrize(
    "said",
    [
        "A strange thing lies above $P$.",  # which may be anywhere
        "The axis of the wheel lies to the left of $A$.",
        "The rope touches the load to the left of $A$.",
        "Half a turn later $P$ lies below $O$.",
        "The load $B$ is not to the left of $O$.",
        "$P$ does not lie below the drum.",
        "Die Achse der Trommel liegt links von $A$.",
        "滚筒在 $A$ 的左侧。",
    ],
)
def test_what_cannot_be_decided_is_no_fault(said: str) -> None:
    assert find_faults("drum", said) == []


def test_another_side_of_the_same_part_is_held_against_it() -> None:
    right = "It stands with $A$ above $O$ and to its right."
    assert find_faults("slider", right) == []
    [fault] = find_faults("slider", right.replace("its right", "its left"))
    assert fault.startswith('statement: it says "$A$ above $O$ and to its left"')


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("A rope is wound on the hub, on its right side.", ("right", "left")),
        ("A second rope leaves the rim on the left.", ("left", "right")),
        ("It hangs from the left side of the rim.", ("left", "right")),
    ],
)
def test_the_other_side_of_a_rope_is_a_fault(right: str, wrong: tuple[str, str]) -> None:
    assert find_faults("drum", right) == find_faults("drum", f"{right} A rope leaves it.") == []
    [fault] = find_faults("drum", right.replace(*wrong))
    assert fault.endswith(LIES)
