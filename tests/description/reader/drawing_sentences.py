"""The forms of the sentences by which points can be drawn."""

from __future__ import annotations

from typing import Any

from tests.description.reader.deferred import Deferred, combined, known, position
from tests.description.reader.formulas import rotated
from tests.description.reader.geometry import (
    beside,
    common_points,
    cross,
    extreme,
    foot,
    polar,
    toward,
    unit,
)
from tests.description.reader.places import WAYS, Construction, Side
from tests.description.reader.sentences import Parts, Pattern
from tests.description.reader.vocabulary import Vocabulary

Items = list[Any]
ANYWHERE = 1.0  # m
SIDES = {"right-hand": "right", "left-hand": "left", "upper": "upper", "lower": "lower"}


def drawn(part: Parts, place: Deferred[complex]) -> Items:
    """The named point is at that place."""
    return [Construction(part["name"], place)]


def origin(part: Parts, words: Vocabulary) -> Items:
    """The origin."""
    return drawn(part, known(0j))


def at_coordinates(part: Parts, words: Vocabulary) -> Items:
    """A point by its coordinates."""
    return drawn(part, combined(complex, part["x"], part["y"]))


def in_direction(part: Parts, words: Vocabulary) -> Items:
    """A point at a distance in a direction."""
    return drawn(part, combined(polar, part["point"], part["length"], part["angle"]))


def seen_in_direction(part: Parts, words: Vocabulary) -> Items:
    """A point in a direction; how far away it is makes no difference."""
    return drawn(part, combined(polar, part["point"], known(ANYWHERE), part["angle"]))


def against_direction(part: Parts, words: Vocabulary) -> Items:
    """A point at a distance, opposite to a direction."""
    back = combined(lambda length: -length, part["length"])
    return drawn(part, combined(polar, part["point"], back, part["angle"]))


def along_vector(part: Parts, words: Vocabulary) -> Items:
    """A point at a distance in the direction of a vector."""
    way = turned_vector(part)
    place = combined(lambda p, v, length: p + length * unit(v), part["point"], way, part["length"])
    return drawn(part, place)


def at_side(part: Parts, words: Vocabulary) -> Items:
    """A point straight above, below or beside another one."""
    way = complex(WAYS[part["way"]])
    return drawn(part, combined(lambda p, length: p + way * length, part["point"], part["length"]))


def towards(part: Parts, words: Vocabulary) -> Items:
    """A point at a distance towards another one."""
    return drawn(part, combined(toward, part["point"], part["goal"], part["length"]))


def on_ray(part: Parts, words: Vocabulary) -> Items:
    """A point at a distance on a ray, measured from where the ray starts."""
    if part["start"].needs != part["point"].needs:
        raise ValueError("the distance is not measured from the start of the ray")
    return towards(part, words)


def away_from(part: Parts, words: Vocabulary) -> Items:
    """A point at a distance away from another one."""
    back = combined(lambda length: -length, part["length"])
    return drawn(part, combined(toward, part["point"], part["goal"], back))


def extreme_meeting(part: Parts, words: Vocabulary) -> Items:
    """The outermost of the common points of two curves."""
    side = SIDES[part["side"]]
    first, second = part["first"] or part["third"], part["second"] or part["other"]
    return drawn(
        part,
        combined(lambda a, b: extreme(common_points(a, b), side), first, second),
    )


def meeting(part: Parts, words: Vocabulary) -> Items:
    """The common point of two lines."""
    second = part["second"] or part["other"]
    return drawn(part, combined(lambda a, b: common_points(a, b)[0], part["first"], second))


def meeting_beside(part: Parts, words: Vocabulary) -> Items:
    """The common point of two curves on one side of a line."""
    side = part["side"]
    place = combined(
        lambda a, b, start, end: beside(common_points(a, b), start, end, side),
        part["first"],
        part["second"],
        part["start"],
        part["end"],
    )
    sign = 1 if side == "left" else -1
    margin = combined(
        lambda point, start, end: sign * cross(end - start, point - start),
        position(part["name"]),
        part["start"],
        part["end"],
    )
    return [*drawn(part, place), Side(margin)]


def foot_of(part: Parts, words: Vocabulary) -> Items:
    """The foot of a perpendicular."""
    return drawn(part, combined(foot, part["point"], part["line"]))


def middle(part: Parts, words: Vocabulary) -> Items:
    """The midpoint of two points."""
    return drawn(part, combined(lambda a, b: (a + b) / 2, part["start"], part["end"]))


def middle_of_pair(part: Parts, words: Vocabulary) -> Items:
    """The midpoint of two points named side by side."""
    first, second = part["pair"]
    return drawn(part, combined(lambda a, b: (a + b) / 2, position(first), position(second)))


def by_vector(part: Parts, words: Vocabulary) -> Items:
    """A point to which a vector leads."""
    return drawn(part, combined(lambda p, v: p + v, part["start"], turned_vector(part)))


def turned_vector(part: Parts) -> Deferred[complex]:
    """The vector of the sentence, turned where the sentence says so."""
    angle = part["angle"] or known(0.0)
    sign = -1 if part["sense"] == "clockwise" else 1
    return combined(lambda v, turn: rotated(v, sign * turn), part["vector"], angle)


STRAIGHT = "above|below|to the right of|to the left of"
PERHAPS_TURNED = "(?: turned through {number:angle} (?P<sense>clockwise|counter-clockwise))?"
FAR = "{name} lies at the distance {number:length} from {point}"
ONE_SIDE = "(?P<side>right|left) of the line from {point:start} to {point:end}"
DRAWING_PATTERNS = [
    Pattern("{name} is the origin", origin),
    Pattern("{name} has the coordinates {number:x} and {number:y}", at_coordinates),
    Pattern(f"{FAR} in the direction {{bearing:angle}}", in_direction),
    Pattern("seen from {point}, {name} lies in the direction {bearing:angle}", seen_in_direction),
    Pattern(f"{FAR}, opposite to the direction {{bearing:angle}}", against_direction),
    Pattern(f"{FAR} in the direction of the vector {{vector}}{PERHAPS_TURNED}", along_vector),
    Pattern(f"{FAR},? towards {{point:goal}}", towards),
    Pattern(f"{FAR},? away from {{point:goal}}", away_from),
    Pattern(
        "{name} lies at the distance {number:length} (?:vertically |horizontally )?"
        f"(?P<way>{STRAIGHT}) {{point}}",
        at_side,
    ),
    Pattern(
        "{name} lies on the ray from {point} through {point:goal}, "
        "at the distance {number:length} from {point:start}",
        on_ray,
    ),
    Pattern(
        "{name} is the (?P<side>right-hand|left-hand|upper|lower) "
        "(?:intersection of {curve:first} and {curve:second}"
        "|one of the points in which {curve:third} and {curve:other} meet)",
        extreme_meeting,
    ),
    Pattern(
        "{name} is the point in which {line:first} (?:meets {line:second}|and {line:other} meet)",
        meeting,
    ),
    Pattern(
        f"{{name}} lies on {{curve:first}} and on {{curve:second}}, on the {ONE_SIDE}",
        meeting_beside,
    ),
    Pattern("{name} is the foot of the perpendicular from {point} to {line}", foot_of),
    Pattern("{name} is the midpoint of {point:start} and {point:end}", middle),
    Pattern("{name} is the midpoint of (?:the segment )?{pair}", middle_of_pair),
    Pattern(
        f"from {{point:start}} to {{name}} leads the vector {{vector}}{PERHAPS_TURNED}",
        by_vector,
    ),
]
