"""Parts of sentences: points, lines, circles, directions, numbers with units."""

from __future__ import annotations

import cmath
import re
from collections.abc import Callable
from typing import Any

from tests.description.reader.deferred import Deferred, combined, known, position
from tests.description.reader.formulas import formula, number
from tests.description.reader.geometry import Circle, Curve
from tests.description.reader.lines import (
    HEADING,
    LINE,
    MATH,
    heading_of,
    inside,
    line_of,
    pieces,
    point_of,
)
from tests.description.reader.names import atoms, pair_of_points, plain, point_name
from tests.description.reader.units import factor_of, is_length
from tests.description.reader.vocabulary import Vocabulary

SIGNED_UNIT = re.compile(r"\\unit\{((?:[^{}]|\{[^{}]*\})*)\}")
RAYS = {
    "the horizontal to the right": 1 + 0j,
    "the horizontal to the left": -1 + 0j,
    "the vertical upwards": 1j,
    "the vertical downwards": -1j,
}
RAY = "(?:" + "|".join(RAYS) + f"|{MATH})"
CIRCLE = rf"(?:the circle about {MATH} of radius {MATH})"


def named_point(text: str, words: Vocabulary) -> str:
    """The name of a point."""
    return point_name(inside(text))


def pair_of(text: str, words: Vocabulary) -> tuple[str, str]:
    """The names of two points side by side."""
    return pair_of_points(inside(text))


def number_of(text: str, words: Vocabulary) -> Deferred[float]:
    """A number in m, s and rad, whatever it is called."""
    value = inside(text).rpartition("=")[2]
    factor = 1.0
    unit = SIGNED_UNIT.search(value)
    if unit:
        factor = factor_of(unit[1])
        value = value[: unit.start()].strip().removesuffix(r"\,")
    return combined(lambda bare: factor * bare, number(value, words.numbers))


def corners_of(text: str, words: Vocabulary) -> list[str]:
    """The names of three points side by side."""
    found = atoms(inside(text).removeprefix(r"\angle"))
    if len(found) != 3:
        raise ValueError(f"not the names of three points: {text}")
    return found


def quantity_of(text: str, words: Vocabulary) -> float:
    """A number that needs no point; a name in front of it is kept for later."""
    value = number_of(text, words).at({})
    unit = SIGNED_UNIT.search(text)
    if unit and is_length(unit[1]):
        words.lengths.append(abs(value))
    for name in inside(text).split("=")[:-1]:
        words.numbers[plain(name)] = value
    return value


def vector_of(text: str, words: Vocabulary) -> Deferred[complex]:
    """A vector."""
    return combined(complex, formula(inside(text), words.numbers))


def circle_of(text: str, words: Vocabulary) -> Deferred[Circle]:
    """A circle."""
    centre, radius = pieces(text)
    return combined(Circle, point_of(centre, words), number(radius, words.numbers))


def curve_of(text: str, words: Vocabulary) -> Deferred[Curve]:
    """A line or a circle."""
    if re.fullmatch(CIRCLE, text):
        circle = circle_of(text, words)
        return Deferred(circle.needs, circle.at)
    line = line_of(text, words)
    return Deferred(line.needs, line.at)


def ray_of(text: str, words: Vocabulary) -> tuple[str | None, Deferred[complex]]:
    """The point at which a ray starts, where it has one, and its direction as a vector."""
    if text in RAYS:
        return None, known(RAYS[text])
    first, second = pair_of_points(inside(text))
    return first, combined(lambda a, b: b - a, position(first), position(second))


def bearing_of(text: str, words: Vocabulary) -> Deferred[float]:
    """A direction, as its angle."""
    if not text.startswith("from"):
        return number_of(text, words)
    start, end = (point_of(part, words) for part in pieces(text))
    return combined(lambda a, b: cmath.phase(b - a), start, end)


def mover_of(text: str, words: Vocabulary) -> tuple[str, str]:
    """A point and its body; a body that is no more than a point stands for both."""
    point, _, body = text.partition(" of ")
    return point_name(inside(point)), words.body(body or point)


def body_of(text: str, words: Vocabulary) -> str:
    """A body."""
    return words.body(text)


KINDS: dict[str, tuple[str, Callable[[str, Vocabulary], Any]]] = {
    "point": (MATH, point_of),
    "name": (MATH, named_point),
    "pair": (MATH, pair_of),
    "number": (MATH, number_of),
    "corners": (MATH, corners_of),
    "quantity": (MATH, quantity_of),
    "vector": (MATH, vector_of),
    "line": (LINE, line_of),
    "circle": (CIRCLE, circle_of),
    "curve": (f"(?:{LINE}|{CIRCLE})", curve_of),
    "ray": (RAY, ray_of),
    "bearing": (f"(?:{MATH}|from {MATH} to {MATH})", bearing_of),
    "heading": (HEADING, heading_of),
}
