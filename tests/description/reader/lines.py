"""Phrases that name points, lines and headings."""

from __future__ import annotations

import cmath
import re
from collections.abc import Callable

from tests.description.reader.deferred import Deferred, combined, known, position
from tests.description.reader.formulas import formula, number
from tests.description.reader.geometry import Line, line_between, line_towards, unit
from tests.description.reader.names import pair_of_points, point_name
from tests.description.reader.vocabulary import Vocabulary

MATH = r"\$[^$]+\$"
AXIS = r"the \$[xy]\$ axis"
AXES = {"x": 1 + 0j, "y": 1j}


def inside(math_text: str) -> str:
    """The formula without its dollar signs."""
    return math_text.strip("$").strip()


def pieces(text: str) -> list[str]:
    """The formulas of a phrase, in their order."""
    return [inside(piece) for piece in re.findall(MATH, text)]


def point_of(text: str, words: Vocabulary) -> Deferred[complex]:
    """A point by its name or its coordinates."""
    text = inside(text)
    if text.startswith("("):
        return combined(complex, formula(text, words.numbers))
    return position(point_name(text))


def axis(parts: list[str], words: Vocabulary) -> Deferred[Line]:
    """One of the axes."""
    return known(Line(0j, AXES[parts[0]]))


def along_axis(parts: list[str], words: Vocabulary) -> Deferred[Line]:
    """The line through a point along an axis."""
    direction = AXES[parts[1]]
    return combined(lambda point: Line(point, direction), point_of(parts[0], words))


def across_axis(parts: list[str], words: Vocabulary) -> Deferred[Line]:
    """The line through a point at right angles to an axis."""
    direction = AXES[parts[1]] * 1j
    return combined(lambda point: Line(point, direction), point_of(parts[0], words))


def at_angle(parts: list[str], words: Vocabulary) -> Deferred[Line]:
    """The line through a point in the direction of an angle."""
    return combined(line_towards, point_of(parts[0], words), number(parts[1], words.numbers))


def along_vector(parts: list[str], words: Vocabulary) -> Deferred[Line]:
    """The line through a point in the direction of a vector."""
    vector = combined(complex, formula(parts[1], words.numbers))
    return combined(lambda point, v: Line(point, unit(v)), point_of(parts[0], words), vector)


def along_line(parts: list[str], words: Vocabulary) -> Deferred[Line]:
    """The line through a point parallel to another one."""
    return combined(
        lambda point, other: Line(point, other.direction),
        point_of(parts[0], words),
        line_of_pair(parts[1:], words),
    )


def across_line(parts: list[str], words: Vocabulary) -> Deferred[Line]:
    """The line through a point at right angles to another one."""
    return combined(
        lambda point, other: Line(point, other.direction * 1j),
        point_of(parts[0], words),
        line_of_pair(parts[1:], words),
    )


def through_both(parts: list[str], words: Vocabulary) -> Deferred[Line]:
    """The line through two points."""
    return combined(line_between, point_of(parts[0], words), point_of(parts[1], words))


def line_of_pair(parts: list[str], words: Vocabulary) -> Deferred[Line]:
    """The line through two points named side by side."""
    first, second = pair_of_points(parts[0])
    return combined(line_between, position(first), position(second))


LineForm = Callable[[list[str], Vocabulary], Deferred[Line]]
THROUGH = f"the line through {MATH}"
LINES: dict[str, LineForm] = {
    AXIS: axis,
    f"{THROUGH} parallel to {AXIS}": along_axis,
    f"{THROUGH} perpendicular to {AXIS}": across_axis,
    rf"{THROUGH} in the direction {MATH} from the \$x\$ axis": at_angle,
    f"{THROUGH} in the direction of the vector {MATH}": along_vector,
    f"{THROUGH} parallel to (?:the line )?{MATH}": along_line,
    f"{THROUGH} perpendicular to (?:the line )?{MATH}": across_line,
    f"{THROUGH} and {MATH}": through_both,
    f"the line from {MATH} to {MATH}": through_both,
    f"the line {MATH}": line_of_pair,
}
LINE = f"(?:{'|'.join(LINES)})"


def line_of(text: str, words: Vocabulary) -> Deferred[Line]:
    """The line that the phrase names."""
    for form, make in LINES.items():
        if re.fullmatch(form, text):
            return make(pieces(text), words)
    raise ValueError(f"line not understood: {text}")


def upwards(parts: list[str], words: Vocabulary) -> Deferred[complex]:
    """The direction of an axis."""
    return known(AXES[parts[0]])


def by_angle(parts: list[str], words: Vocabulary) -> Deferred[complex]:
    """The direction of an angle."""
    return combined(lambda angle: cmath.rect(1, angle), number(parts[0], words.numbers))


def by_vector(parts: list[str], words: Vocabulary) -> Deferred[complex]:
    """The direction of a vector."""
    return combined(lambda v: unit(complex(v)), formula(parts[0], words.numbers))


def from_to(parts: list[str], words: Vocabulary) -> Deferred[complex]:
    """The direction from the first of the last two points to the second."""
    start, end = (point_of(part, words) for part in parts[-2:])
    return combined(lambda a, b: unit(b - a), start, end)


HeadingForm = Callable[[list[str], Vocabulary], Deferred[complex]]
PERHAPS_ALONG = f"(?:along (?:the line )?{MATH},? )?"
HEADINGS: dict[str, HeadingForm] = {
    "to the right": lambda parts, words: known(1 + 0j),
    "to the left": lambda parts, words: known(-1 + 0j),
    "upwards": lambda parts, words: known(1j),
    "downwards": lambda parts, words: known(-1j),
    f"along {AXIS}": upwards,
    f"in the direction {MATH}": by_angle,
    f"in the direction of the vector {MATH}": by_vector,
    f"in the direction from {MATH} to {MATH}": from_to,
    f"{PERHAPS_ALONG}from {MATH} (?:to|towards) {MATH}": from_to,
}
HEADING = f"(?:{'|'.join(HEADINGS)})"


def heading_of(text: str, words: Vocabulary) -> Deferred[complex]:
    """The direction in which something moves, as a vector of length one."""
    for form, make in HEADINGS.items():
        if re.fullmatch(form, text):
            return make(pieces(text), words)
    raise ValueError(f"heading not understood: {text}")
