"""The forms of the sentences that tell what moves, and of what is given."""

from __future__ import annotations

import re
from typing import Any

from tests.description.reader.drives import Circling, Moving, Turning
from tests.description.reader.lines import MATH
from tests.description.reader.phrases import quantity_of
from tests.description.reader.sentences import Parts, Pattern
from tests.description.reader.vocabulary import GROUND, Vocabulary

Items = list[Any]


def given(part: Parts, words: Vocabulary) -> Items:
    """Numbers by their names, each of which may use those before it."""
    for piece in re.findall(MATH, part["list"]):
        quantity_of(piece, words)
    return []


def change_of(part: Parts) -> float:
    """How fast the rate grows, positive where it speeds up."""
    if part["pace"] is None:
        return 0.0
    change = float(part["change"])
    return change if part["pace"] == "speeding up" else -change


def turning(part: Parts, words: Vocabulary) -> Items:
    """A body that turns."""
    sign = -1 if part["sense"] == "clockwise" else 1
    frame = part["frame"] or GROUND
    return [Turning(sign * part["rate"], sign * change_of(part), part["body"], frame)]


def moving(part: Parts, words: Vocabulary) -> Items:
    """A point that moves in a direction."""
    name, body = part["mover"]
    frame = part["frame"] or GROUND
    return [Moving(part["rate"], change_of(part), name, body, frame, part["heading"])]


def turning_signed(part: Parts, words: Vocabulary) -> Items:
    """A body that turns at a rate with a sign."""
    frame = part["frame"] or GROUND
    return [Turning(part["rate"], part["change"] or 0.0, part["body"], frame)]


def moving_signed(part: Parts, words: Vocabulary) -> Items:
    """A point that moves in a direction at a rate with a sign."""
    name, body = part["mover"]
    frame = part["frame"] or GROUND
    rates = part["rate"], part["change"] or 0.0
    return [Moving(*rates, name, body, frame, part["heading"])]


def circling(part: Parts, words: Vocabulary) -> Items:
    """A point that moves on a circle."""
    name, body = part["mover"]
    sign = -1 if part["sense"] == "clockwise" else 1
    rate, change = sign * part["rate"], sign * change_of(part)
    return [Circling(rate, change, name, body, part["centre"])]


def circling_signed(part: Parts, words: Vocabulary) -> Items:
    """A point that moves on a circle at a rate with a sign."""
    name, body = part["mover"]
    return [Circling(part["rate"], part["change"] or 0.0, name, body, part["centre"])]


def starting(part: Parts, words: Vocabulary) -> Items:
    """A body that begins to turn."""
    sign = -1 if part["sense"] == "clockwise" else 1
    return [Turning(0.0, sign * part["change"], part["body"], part["frame"] or GROUND)]


def convention(part: Parts, words: Vocabulary) -> Items:
    """How axes and directions are meant; the reader means the same."""
    return []


def pace(noun: str) -> str:
    """How the rate changes."""
    return f"(?:, (?P<pace>speeding up|slowing down) with the {noun} {{quantity:change}})?"


SENSE = "(?P<sense>clockwise|counter-clockwise)"
RELATIVE = "(?:relative to {body:frame}, )?"
SEEN_FROM = "(?: relative to {body:frame})?"
RATE = "(?:angular velocity|rotational speed)"
TURNS = f"(?:with the|at the|with the constant|at the constant) {RATE} {{quantity:rate}}"
SPEED = "(?:at|with) the (?:constant )?speed {quantity:rate}"
GIVEN = "(?:given|lengths that follow|angles that follow|numbers that follow)"
DRIVE_PATTERNS = [
    Pattern(r"the \$x\$ axis points to the right, the \$y\$ axis upwards", convention),
    Pattern(
        r"directions are given by their angle with the \$x\$ axis, counter-clockwise",
        convention,
    ),
    Pattern(f"{GIVEN}: (?P<list>{MATH}(?:, {MATH})*)", given),
    Pattern(f"{RELATIVE}{{body}} turns {SENSE} {TURNS}{pace('angular acceleration')}", turning),
    Pattern(f"{RELATIVE}{{mover}} moves {{heading}} {SPEED}{pace('acceleration')}", moving),
    Pattern(
        f"{{body}} turns{SEEN_FROM} with the angular velocity {{quantity:rate}}"
        "(?: and the angular acceleration {quantity:change})?, positive counter-clockwise",
        turning_signed,
    ),
    Pattern(
        f"{{mover}} moves {{heading}}{SEEN_FROM} with the velocity {{quantity:rate}}"
        "(?: and the acceleration {quantity:change})?, positive in this direction",
        moving_signed,
    ),
    Pattern(
        f"on its circle about {{point:centre}}, {{mover}} moves {SENSE} {SPEED}"
        f"{pace('tangential acceleration')}",
        circling,
    ),
    Pattern(
        "on its circle about {point:centre}, {mover} moves with the velocity {quantity:rate}"
        "(?: and the (?:tangential )?acceleration {quantity:change})?, positive counter-clockwise",
        circling_signed,
    ),
    Pattern(
        f"{RELATIVE}{{body}} starts (?:turning )?from rest,? {SENSE},? "
        "with the angular acceleration {quantity:change}",
        starting,
    ),
]
