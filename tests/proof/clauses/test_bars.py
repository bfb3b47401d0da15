"""`check` finds what statements say of bars, of guides and of points in a row."""

from __future__ import annotations

import pytest

from tests.proof.clauses.drum import find_faults

LIES = ", and the points of the mechanism lie otherwise: correct the words, or the points"


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("the upper end $A$ of the rod", ("upper", "lower")),
        ("das rechte Ende $B$", ("rechte", "linke")),
        ("$B$ lies on the line $AG$ extended beyond $G$", ("beyond $G$", "beyond $A$")),
        ("auf der Verlängerung von $AG$ über $G$ hinaus", ("über $G$", "über $A$")),
        ("$OA$ is pivoted at $O$", ("pivoted at $O$", "pivoted at $B$")),
        ("the points $O$, $G$, $B$ from left to right", ("left to right", "right to left")),
        ("von rechts nach links $B$, $G$ und $O$", ("rechts nach links", "links nach rechts")),
        ("$H$ and $O$ from bottom to top", ("bottom to top", "top to bottom")),
        ("it runs in a horizontal guide", ("horizontal", "vertical")),
        ("in einer waagrechten Führung", ("waagrechten", "lotrechten")),
        ("the slider is guided horizontally", ("horizontally", "vertically")),
        ("der Punkt $B$ bewegt sich waagrecht", ("waagrecht", "lotrecht")),
    ],
)
def test_what_lies_otherwise_is_a_fault(right: str, wrong: tuple[str, str]) -> None:
    assert find_faults("slider", right) == []
    [fault] = find_faults("slider", right.replace(*wrong))
    assert fault.endswith(LIES)


@pytest.mark.parametrize(
    "said",
    [
        "the upper end of the rod",
        "the end $H$",
        "$OA$ extended beyond $B$",  # no end of it
        "the angle from the extension of $OA$ beyond $A$ to $AB$",
        "der Winkel zwischen der Verlängerung von $OA$ über $A$ hinaus und $AB$",
        "$O$ and the rest from right to left",
        "a vertical bar",
        "it is not in a vertical guide",
        "something is guided vertically",
    ],
)
def test_what_cannot_be_decided_is_no_fault(said: str) -> None:
    assert find_faults("slider", said) == []


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("the crank $OA$, the rod $AB$, the link $OH$", ""),
        ("the link $OB$", "link $OB$"),
        ("die Kurbel $OB$", "Kurbel $OB$"),
        ("the line $OB$", ""),
    ],
)
def test_a_bar_between_points_of_no_body_is_a_fault(said: str, told: str) -> None:
    fault = f'statement: it says "{told}", and no body of the mechanism has both points: correct '
    assert find_faults("slider", said) == [f"{fault}the letters, or the bodies"] * bool(told)


def test_without_an_instance_nothing_is_a_fault() -> None:
    assert find_faults("slider", "a vertical guide, the link $OB$", phi=[]) == []
