"""A sentence that is true in some way in which it can be read is no fault; the same sentence is one
where it is so in none.
"""

from __future__ import annotations

import pytest

from tests.proof.clauses.drum import find_all_faults, find_faults


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("The pin $A$ turns about $O$, and $A$ lies above $O$.", ("above", "below")),
        ("The crank is pinned at $O$, and $B$ lies to the right of $O$.", ("right", "left")),
        ("The crank is pinned at $O$, and $G$ lies to the right of $O$.", ("right", "left")),
        ("The crank turns about the point $O$, above the guide.", ("above", "below")),
        ("It drives the rod, whose end $B$ slides in a guide, lower than $O$.", ("low", "high")),
        ("The crank turns about $O$, which lies above the guide.", ("above", "below")),
        ("Die Kurbel ist in $O$ gelagert, und $A$ liegt über $O$.", ("über", "unter")),
    ],
)
def test_a_side_of_what_is_named_last(right: str, wrong: tuple[str, str]) -> None:
    assert find_all_faults("slider", right) == []
    assert len(find_all_faults("slider", right.replace(*wrong))) >= 1


@pytest.mark.parametrize(
    "said",
    [
        "The guide of $B$ passes below $O$, and $A$ lies above $O$, $OA$ being 1.",
        "Its pin $A$ drives the rod, which is guided at $B$, to the right of $O$.",
        "The rod joins $A$ with $B$, to the right of $O$.",
        "The guide of $B$ ends at $H$, at the distance {{ e }} below $O$.",
        "The crank turns about $O$, and the rod, pinned to it at $A$, above $O$, ends at $B$.",
        "Its end slides in the guide through $H$, at the distance {{ e }} vertically below $O$.",
        "Die Stange endet im Gleitstück $B$, rechts von $O$.",
        "Die Führung endet in $H$, im Abstand {{ e }} senkrecht unter $O$.",
        "曲柄绕 $O$ 转动，$A$ 在 $O$ 的上方。",
        "导路过 $H$，$H$ 在 $O$ 的正下方，相距 {{ e }}。",
    ],
)
def test_a_side_that_may_be_that_of_another_part_is_no_fault(said: str) -> None:
    assert find_all_faults("slider", said) == []


@pytest.mark.parametrize(
    "said",
    [
        "The end $B$ slides in a straight guide that rises from $O$ to the right.",
        "The end $B$ slides in a guide which rises to the right.",
        "The slider $B$ runs in a straight guide that falls towards $O$.",
        "The rod $AB$ rises from $A$ to the right.",
        "$B$ is guided by a rail that is rising at an angle.",
        "The pin $B$ slides in a slot that descends from $A$.",
        "The crank $OA$ is driven by a wheel that turns clockwise.",
        "The slider $B$ hangs on a rope that moves to the right.",
        "Its end $B$ is driven by a belt which turns counter-clockwise.",
        "Das Ende $B$ gleitet in einer Führung, die von $O$ nach rechts steigt.",
        "Das Ende $B$ gleitet in einer Führung, welche unter 30° steigt.",
        "Die Stange $AB$ fällt von $A$ nach rechts.",
    ],
)
def test_a_verb_of_another_subject_is_no_sense_of_a_part(said: str) -> None:
    assert find_faults("slider", said) == []


@pytest.mark.parametrize(
    "said",
    [
        "The slider $B$ moves to the right.",
        "The slider $B$, which moves to the right, is driven.",
        "It has a slider that moves to the right.",
        "The crank $OA$, which turns clockwise, drives the rod.",
    ],
)
def test_a_sense_that_its_own_subject_has_not_is_a_fault(said: str) -> None:
    assert len(find_faults("slider", said)) == 1


def test_a_load_that_goes_the_other_way_is_a_fault() -> None:
    assert len(find_faults("drum", "The drum carries load $A$, which rises.")) == 1
    assert len(find_faults("drum", "The load $A$ rises.")) == 1
    assert find_faults("drum", "The drum carries load $B$, which rises.") == []
