"""How a driven body or point goes, said with the true sense and positive numbers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from kinegrade.language.message import Message, Part
from kinegrade.problem.given import Given
from kinegrade.problem.template.driven import Driven, Imposed
from kinegrade.sign_conventions import Convention

_Pace = Literal["given", "constant", "faster", "slower", "from-rest"]

_SENSES: Mapping[tuple[Convention, int], Message] = {
    ("ccw", 1): Message("statement.counter-clockwise"),
    ("ccw", -1): Message("statement.clockwise"),
    ("+x", 1): Message("statement.right"),
    ("+x", -1): Message("statement.left"),
    ("-x", 1): Message("statement.left"),
    ("-x", -1): Message("statement.right"),
    ("+y", 1): Message("statement.up"),
    ("+y", -1): Message("statement.down"),
    ("-y", 1): Message("statement.down"),
    ("-y", -1): Message("statement.up"),
}


def describe_driven(driven: Driven, givens: Mapping[str, Given], *, changes: bool) -> Message:
    """What a body or a point does, for a sentence of which it is the subject.

    Without `changes` nothing is said of its acceleration.
    """
    velocity = _find_sign(driven.velocity, givens)
    change = driven.acceleration if changes else None
    acceleration = 0 if change is None else _find_sign(change, givens)
    sense = velocity or acceleration
    if not sense:
        return Message("statement.at-rest")
    pace = _find_pace(velocity, acceleration) if changes else "given"
    parts: dict[str, Part] = {
        "sense": _SENSES[driven.positive, sense],
        "velocity": givens[driven.velocity.given].size,
        "rate": _name_rate(givens[driven.velocity.given]),
        "acceleration": "" if change is None else givens[change.given].size,
    }
    return Message(f"statement.{driven.path}-{pace}", **parts)


def _name_rate(given: Given) -> Message:
    """What a rate of turning is called, which depends on its unit."""
    if given.quantity.measure.counts_turns:
        return Message("statement.rotational-speed")
    return Message("statement.angular-velocity")


def name_sense(driven: Driven, givens: Mapping[str, Given]) -> Message | None:
    """The way that a body or a point goes; None where it has no velocity."""
    velocity = _find_sign(driven.velocity, givens)
    return _SENSES[driven.positive, velocity] if velocity else None


def _find_sign(rate: Imposed, givens: Mapping[str, Given]) -> int:
    """1, 0 or -1: the sign of a rate at the values given."""
    quantity = givens[rate.given].quantity
    if quantity.is_zero:
        return 0
    return -1 if quantity.is_negative != rate.turned else 1


def _find_pace(velocity: int, acceleration: int) -> _Pace:
    """How the motion changes, by the signs of its rates."""
    match velocity * acceleration:
        case 1:
            return "faster"
        case -1:
            return "slower"
        case _:
            return "constant" if velocity else "from-rest"
