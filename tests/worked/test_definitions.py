"""Words of the composition of motions are defined where they are first used."""

from __future__ import annotations

from tests.worked.draws import kept
from tests.worked.telling import proses


def find_rules(name: str) -> list[str]:
    """What the solution of a template says of directions by the right-hand rule."""
    return [text for text in proses(kept(name)) if text.startswith("Right-hand rule")]


def test_a_frame_that_turns_clockwise_turns_the_relative_velocity_clockwise() -> None:
    # the cam turns with -8 rad/s; seen from it the contact moves left, so a_C points upwards
    assert find_rules("flat-faced-follower-curvature-radius") == [
        r"Right-hand rule: $\boldsymbol{a}_{\mathrm{C}}$ has the direction of "
        r"$\boldsymbol{v}_{\mathrm{r}}$ turned through $90^\circ$ clockwise, with $\omega_{OK}$."
    ]


def test_the_directions_of_two_frames_are_said_in_one_sentence() -> None:
    first, *_ = find_rules("bent-rod-two-sleeves")
    assert first == (
        r"Right-hand rule: $\boldsymbol{a}_{\mathrm{C}1}$ has the direction of "
        r"$\boldsymbol{v}_{\mathrm{r}1}$ turned through $90^\circ$ counter-clockwise, with "
        r"$\omega_{AE}$; $\boldsymbol{a}_{\mathrm{C}2}$ has the direction of "
        r"$\boldsymbol{v}_{\mathrm{r}2}$ turned through $90^\circ$ counter-clockwise, with "
        r"$\omega_{CMD}$."
    )
