"""The forms of the sentences that name the points of the bodies and join the bodies."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from tests.description.reader.contacts import Contact
from tests.description.reader.deferred import position
from tests.description.reader.joints import OnCircle, OnLine, Pin, SameTurn, Sleeve, Train
from tests.description.reader.lines import MATH, pieces
from tests.description.reader.names import point_name
from tests.description.reader.sentences import Parts, Pattern
from tests.description.reader.vocabulary import GROUND, Vocabulary

Items = list[Any]


def points_of(part: Parts, words: Vocabulary) -> Items:
    """The points that belong to a body."""
    words.carried.setdefault(part["body"], []).extend(
        point_name(piece) for piece in pieces(part["points"])
    )
    return []


def remark(part: Parts, words: Vocabulary) -> Items:
    """A sentence that helps to imagine the body and adds no condition."""
    return []


def fixed_pin(part: Parts, words: Vocabulary) -> Items:
    """A body that turns about a point of the ground."""
    return [Pin(part["point"], GROUND, part["body"])]


def fixed_pins(part: Parts, words: Vocabulary) -> Items:
    """Bodies that turn about the same point of the ground."""
    return [Pin(part["point"], GROUND, body) for body in part["bodies"]]


def pins(part: Parts, words: Vocabulary) -> Items:
    """Bodies that share a point."""
    return [Pin(part["point"], first, second) for first, second in pairwise(part["bodies"])]


def translates(part: Parts, words: Vocabulary) -> Items:
    """A body that does not turn."""
    return [SameTurn(part["body"], GROUND)]


def turns_with(part: Parts, words: Vocabulary) -> Items:
    """A body that turns as much as another one."""
    return [SameTurn(part["body"], part["other"])]


def turn_together(part: Parts, words: Vocabulary) -> Items:
    """Bodies that turn as much as each other."""
    return [SameTurn(first, second) for first, second in pairwise(part["bodies"])]


def in_fixed_guide(part: Parts, words: Vocabulary) -> Items:
    """A point on a line of the ground."""
    name, body = part["mover"]
    return [OnLine(position(name), body, part["line"], GROUND)]


def in_slot(part: Parts, words: Vocabulary) -> Items:
    """A point on a line of another body."""
    name, body = part["mover"]
    return [OnLine(position(name), body, part["line"], part["guide"])]


def passes_through(part: Parts, words: Vocabulary) -> Items:
    """A line of a body that passes through a point of another one."""
    point = part["point"] or part["moving"]
    return [OnLine(point, part["holder"] or GROUND, part["line"], part["body"])]


def on_circle(part: Parts, words: Vocabulary) -> Items:
    """A point on a circle of another body."""
    name, body = part["mover"]
    return [OnCircle(position(name), body, part["circle"], part["guide"] or GROUND)]


def contact(part: Parts, words: Vocabulary) -> Items:
    """A circle that rolls or slips on a curve."""
    rolls = part.get("rolls") is not None
    return [
        Contact(
            part["circle"],
            part["body"],
            part["curve"],
            part["guide"],
            bool(part["inside"]),
            rolls,
        )
    ]


def mesh(part: Parts, words: Vocabulary) -> Items:
    """Two gears."""
    return train(part, bool(part["inside"]), belt=False)


def belt(part: Parts, words: Vocabulary) -> Items:
    """Two pulleys."""
    return train(part, part["shape"] == "open", belt=True)


def train(part: Parts, same_sense: bool, belt: bool) -> Items:
    """Two wheels that turn together as seen from the body with their centres."""
    circles = part["first"], part["one"], part["second"], part["two"]
    return [Train(*circles, part["carrier"], same_sense, belt)]


def sleeve(part: Parts, words: Vocabulary) -> Items:
    """A rod and a sleeve."""
    return [Sleeve(part["rod"], part["body"], part["line"])]


INSIDE = "(?P<inside>, one inside the other,)?"
JOINT_PATTERNS = [
    Pattern(f"points of {{body}}: (?P<points>{MATH}(?:, {MATH})*)", points_of),
    Pattern("{body} has teeth; its circle is the pitch circle", remark),
    Pattern("{body} is taut", remark),
    Pattern("{body} is taut and carries a load at its end", remark),
    Pattern("{body} is driven", remark),
    Pattern(
        f"{{body}} is a bent rod that runs through the points (?P<points>{MATH}(?:, {MATH})*) "
        "in this order",
        points_of,
    ),
    Pattern("a circle of {body} about {point} passes through {point:rim}", remark),
    Pattern("{body} is the slotted wheel of a Geneva drive", remark),
    Pattern("of the profile of {body} only the curvature at the contact is known", remark),
    Pattern("{body} turns about the fixed pin {point}", fixed_pin),
    Pattern("{bodies} turn about the fixed pin {point}", fixed_pins),
    Pattern("{bodies} are pinned together at {point}", pins),
    Pattern("{body} translates", translates),
    Pattern(
        "{body} (?:always )?turns (?:together with|with|as much as|like) {body:other}", turns_with
    ),
    Pattern("{bodies} turn together", turn_together),
    Pattern("{mover} slides in a fixed straight guide along {line}", in_fixed_guide),
    Pattern("{mover} slides in a straight slot or guide of {body:guide}, along {line}", in_slot),
    Pattern(
        "{line}, fixed to {body}, always passes through "
        "(?:the fixed point {point}|(?:the point )?{point:moving} of {body:holder})",
        passes_through,
    ),
    Pattern("{mover} stays on {circle}, fixed to {body:guide}", on_circle),
    Pattern(
        f"{{circle}}, fixed to {{body}}, (?P<rolls>rolls without slipping){INSIDE} on {{curve}}, "
        "fixed to {body:guide}",
        contact,
    ),
    Pattern(
        f"{{circle}}, fixed to {{body}}, touches{INSIDE} {{curve}}, fixed to {{body:guide}}, "
        "and may slip there",
        contact,
    ),
    Pattern(
        f"{{circle:first}}, fixed to {{body:one}}, meshes{INSIDE} with {{circle:second}}, "
        "fixed to {body:two}; {body:carrier} carries both centres",
        mesh,
    ),
    Pattern(
        "(?:a|an) (?P<shape>open|crossed) belt runs without slipping about {circle:first}, "
        "fixed to {body:one}, and {circle:second}, fixed to {body:two}; "
        "{body:carrier} carries both centres",
        belt,
    ),
    Pattern("{body:rod} slides through {body},? along {line},? and turns together with it", sleeve),
]
