"""Whether the angle that a sentence names between two lines is that of the triangle at their common
point, or where they have none that between their directions, each from the first of its letters to
the second.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence

from kinegrade.language import Language
from kinegrade.language.math.reading import read_math
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.as_stated import restate
from kinegrade.problem.solution import Solution
from kinegrade.worked.case import write_row
from kinegrade.worked.document import Block, Prose
from kinegrade.worked.formulas.measures import bearing
from kinegrade.worked.words.naming import Naming
from tests.worked.reader.amounts import Amount
from tests.worked.reader.formula_reader import read_formula
from tests.worked.reader.inclined import POINT

_LINE = rf"\$({POINT.pattern})({POINT.pattern})\$"
_BETWEEN = re.compile(
    rf"{_LINE} (?:and|und|与) {_LINE} (?:is|ist|的夹角为) \$([^$=]*?)(?: =[^$]*)?\$"
)
_CORNER = re.compile(
    rf"\$\\angle ({POINT.pattern})({POINT.pattern})({POINT.pattern})\$ (?:is|ist|等于) "
    r"\$([^$=]*?)(?: =[^$]*)?\$"
)
_ROOM = 0.02  # degrees: a sum of two angles of two decimals


def find_misnamed(
    blocks: Sequence[Block], solution: Solution, worth: Callable[[str], Amount]
) -> Iterator[str]:
    """The angles of sentences that are none between the directions of the lines they name."""
    points = dict(_place_points(solution))
    for block in blocks:
        if isinstance(block, Prose):
            corners = ((b, a, b, c, angle) for a, b, c, angle in _CORNER.findall(block.text))
            for *letters, angle in (*_BETWEEN.findall(block.text), *corners):
                told = math.degrees(read_formula(read_math(angle, "test"), worth).value)
                if abs(told - _measure(letters, points)) > _ROOM:
                    yield f"{told:.2f} between {' '.join(letters)}"


def _place_points(solution: Solution) -> Iterator[tuple[str, Vector]]:
    stated = restate(solution)
    naming = Naming(stated.template, Language("en"))
    for name, place in stated.motion.points.items():
        yield write_row(naming.letter(name).row), place


def _measure(letters: Sequence[str], points: Mapping[str, Vector]) -> float:
    """The angle between two directions, each by the letters of its start and its end, or from the
    letter that both lines have.
    """
    first, second = letters[:2], letters[2:]
    for corner in {*first} & {*second}:
        first, second = (
            sorted(one, key=lambda letter: letter != corner) for one in (first, second)
        )
    start, end, other_start, other_end = (points[letter] for letter in (*first, *second))
    turned = abs(bearing(end - start) - bearing(other_end - other_start)) % 360
    return min(turned, 360 - turned)
