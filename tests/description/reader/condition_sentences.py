"""The forms of the sentences that tell distances, angles and sides between points."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

from tests.description.reader.deferred import Deferred, combined, known
from tests.description.reader.geometry import cross, dot, foot
from tests.description.reader.lines import MATH, pieces
from tests.description.reader.names import point_name
from tests.description.reader.places import (
    WAYS,
    Equation,
    Side,
    angle_between,
    apart,
    component,
    of_length,
    unsigned_angle,
)
from tests.description.reader.sentences import Parts, Pattern
from tests.description.reader.vocabulary import Vocabulary

Items = list[Any]


def ends(part: Parts) -> tuple[Deferred[complex], Deferred[complex]]:
    """The two points of the sentence."""
    return part["start"], part["end"]


def level(part: Parts, words: Vocabulary) -> Items:
    """A point straight above, below or beside another one, at a distance not told."""
    way = complex(WAYS[part["way"]])
    vector = combined(lambda a, b: b - a, part["other"], part["point"])
    return [Equation(component(vector, way * 1j)), Side(component(vector, way))]


def angle_mark(part: Parts, words: Vocabulary) -> Items:
    """An angle from one direction to another."""
    sign = -1 if part["sense"] == "clockwise" else 1
    turn = combined(lambda angle: sign * angle, part["angle"])
    rays = part["first"], part["second"]
    if any(corner not in (None, part["name"]) for corner, _ in rays):
        raise ValueError(f"a side of the angle does not start at {part['name']}")
    return angle_between(rays[0][1], rays[1][1], turn)


def angle_at_corner(part: Parts, words: Vocabulary) -> Items:
    """An angle named by three points."""
    first, corner, last = part["corners"]
    angle = part["angle"] or known(math.pi / 2)
    return unsigned_angle(apart(corner, first), apart(corner, last), angle)


def distance_of(part: Parts, words: Vocabulary) -> Items:
    """The distance of two points."""
    vector = combined(lambda a, b: b - a, *ends(part))
    way = part["way"]
    if not way:
        return [of_length(vector, part["length"])]
    axis = {"horizontal ": 1 + 0j, "vertical ": 1j}[way]
    return [of_length(component(vector, axis), part["length"])]


def distance_from_line(part: Parts, words: Vocabulary) -> Items:
    """The distance of a point from a line."""
    away = combined(lambda point, line: point - foot(point, line), part["point"], part["line"])
    return [of_length(away, part["length"])]


def lies_towards(part: Parts, words: Vocabulary) -> Items:
    """On which sides of another point a point is."""
    vector = combined(lambda a, b: b - a, part["other"], part["point"])
    ways = [part["way"], *([part["second"]] if part["second"] else [])]
    return [Side(component(vector, complex(WAYS[way]))) for way in ways]


def lies_beside(part: Parts, words: Vocabulary) -> Items:
    """On which side of a line between two points a point is."""
    sign = 1 if part["side"] == "left" else -1
    margin = combined(
        lambda point, start, end: sign * cross(end - start, point - start),
        part["point"],
        *ends(part),
    )
    return [Side(margin)]


def lies_on(part: Parts, words: Vocabulary) -> Items:
    """A point on a line or a circle."""
    gap = combined(on_curve, part["point"], part["curve"])
    return [Equation(gap)]


def on_curve(point: complex, curve: Any) -> float:
    """How far a point is from a curve."""
    if hasattr(curve, "radius"):
        return float(abs(point - curve.centre) - curve.radius)
    return float(abs(point - foot(point, curve)))


def frame(part: Parts, words: Vocabulary) -> Items:
    """Axes fixed to a body have names only; they add nothing to the positions."""
    return []


def right_angle(part: Parts, words: Vocabulary) -> Items:
    """Two lines at right angles."""
    first, second = apart(*part["first"]), apart(*part["second"])
    return unsigned_angle(first, second, known(math.pi / 2))


def parallel(part: Parts, words: Vocabulary) -> Items:
    """Two parallel lines."""
    first, second = apart(*part["first"]), apart(*part["second"])
    gap = combined(lambda a, b: cross(a, b) / (abs(a) or 1e-300), first, second)
    return [Equation(gap)]


def upright(part: Parts, words: Vocabulary) -> Items:
    """A line along one of the axes."""
    across = {"horizontal": 1j, "vertical": 1 + 0j}[part["way"]]
    return [Equation(component(apart(*part["pair"]), across))]


def same_distance(part: Parts, words: Vocabulary) -> Items:
    """Two pairs of points as far apart."""
    first, second = apart(*part["first"]), apart(*part["second"])
    return [Equation(combined(lambda a, b: abs(a) - abs(b), first, second))]


def in_a_row(part: Parts, words: Vocabulary) -> Items:
    """Points on a straight line, in their order."""
    names = [point_name(piece) for piece in pieces(part["points"])]
    return [
        item
        for (first, second), (_, third) in pairwise(pairwise(names))
        for item in straight(first, second, third)
    ]


def between(part: Parts, words: Vocabulary) -> Items:
    """A point on the way from one point to another."""
    return straight(part["first"], part["name"], part["last"])


def straight(first: str, second: str, third: str) -> Items:
    """The second point lies between the two others."""
    before, behind = apart(first, second), apart(second, third)
    gap = combined(lambda a, b: cross(a, b) / (abs(a) or 1e-300), before, behind)
    return [Equation(gap), Side(combined(dot, before, behind))]


WAY = "to the right|to the left"
STRAIGHT = "above|below|to the right of|to the left of"
AXIS_NAME = r"\$[xy](?:_\d|_\{\d\})?\$"
TURNED = r"turned through \$90\^\\circ\$ counter-clockwise"
ROW = f"(?P<points>{MATH}(?:, {MATH})*,? and {MATH})"
CONDITION_PATTERNS = [
    Pattern(
        "the angle at {name} from {ray:first}, (?P<sense>clockwise|counter-clockwise), "
        "to {ray:second} is {number:angle}",
        angle_mark,
    ),
    Pattern("the angle {corners} is (?:a right angle|{number:angle})", angle_at_corner),
    Pattern(
        "the (?P<way>horizontal |vertical )?distance from {point:start} to {point:end} "
        "is {number:length}",
        distance_of,
    ),
    Pattern("the distance from {point} to {line} is {number:length}", distance_from_line),
    Pattern("the distances {pair:first} and {pair:second} are equal", same_distance),
    Pattern("{pair:first} is perpendicular to {pair:second}", right_angle),
    Pattern("{pair:first} is parallel to {pair:second}", parallel),
    Pattern("{pair} is (?P<way>horizontal|vertical)", upright),
    Pattern(f"{ROW} lie on (?:a|one) straight line(?:,)? in this order", in_a_row),
    Pattern("{name} lies between {name:first} and {name:last}", between),
    Pattern(
        f"{{point}} lies (?P<way>{STRAIGHT}) {{point:other}}, "
        "(?:at the same height|on the same vertical)",
        level,
    ),
    Pattern(
        f"{{point}} lies (?P<way>above|below|{WAY})(?: and (?P<second>{WAY}))?(?: of)? "
        "{point:other}",
        lies_towards,
    ),
    Pattern(
        "{point} lies on the (?P<side>right|left) of the line from {point:start} to {point:end}",
        lies_beside,
    ),
    Pattern("{point} lies on {curve}", lies_on),
    Pattern(
        f"a frame of axes fixed to (?:the body|{{body}}) has its origin at {{point}}: "
        f"its {AXIS_NAME} axis points from {{point:start}} to {{point:end}}, "
        f"and its {AXIS_NAME} axis is its {AXIS_NAME} axis {TURNED}",
        frame,
    ),
]
