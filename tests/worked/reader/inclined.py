"""Whether a page says why a vector makes the angle with an axis by which it is projected: from its
tables it is known to which line the vector is normal, and from a sentence what that line makes.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import combinations

from kinegrade.language import Language
from kinegrade.language.math.tree import (
    Fenced,
    Function,
    Letter,
    Node,
    Number,
    Row,
    Scripts,
    Sign,
    list_parts,
)
from kinegrade.problem.as_stated import restate
from kinegrade.problem.solution import Solution
from kinegrade.worked.case import write_row
from kinegrade.worked.document import Block, Display, Prose, TermTable
from kinegrade.worked.words.naming import Naming

_NORMAL = re.compile(r"\\perp ([^,$]*)")
POINT = re.compile(r"[A-Z](?:_\{\w+\}|'|_\w)*")
_CLAUSE = re.compile(r"\\boldsymbol\{[va]\}[^$]*\\(?:perp|parallel)")
_BOLD = re.compile(r"\\boldsymbol\{([va])\}")
_COMPONENT = re.compile(r"^\S*,[xy]\}")  # on the axes, with which the figure shows the angles
_NO_LINE = frozenset[str]()
_CLOSE = 1e-9
_FORMULA = re.compile(r"\$([^$]*)\$")


def find_underived(blocks: Sequence[Block], solution: Solution) -> Iterator[str]:
    """The projected vectors of whose angle no sentence before has said where it comes from; those
    normal to lines that lie along an axis in the figure need none.
    """
    straight = set(_find_straight(solution))
    across, told = dict[str, frozenset[str]](), list[str]()
    for block in blocks:
        match block:
            case TermTable(terms):
                for term in terms:
                    line = _NORMAL.search(term.direction)
                    points = _find_points(line[1]) if line else _NO_LINE
                    normal = _NO_LINE if points in straight else points
                    across[_BOLD.sub(r"\1", write_row(term.symbol))] = normal
            case Prose(text):
                told.append(text)
            case Display(lines):
                for row in (one for one in lines if not _COMPONENT.search(write_row(one))):
                    for vector, angle in find_projected(row):
                        if not _is_derived(across.get(vector), angle, told):
                            yield f"{vector} by {angle} in {write_row(row)}"
            case _:
                continue


def _find_straight(solution: Solution) -> Iterator[frozenset[str]]:
    """The lines along the axes, each by the letters of two points."""
    stated = restate(solution)
    naming = Naming(stated.template, Language("en"))
    for (first, start), (second, end) in combinations(stated.motion.points.items(), 2):
        if min(abs(float(end.x - start.x)), abs(float(end.y - start.y))) < _CLOSE:
            yield frozenset(write_row(naming.letter(point).row) for point in (first, second))


def _is_derived(line: frozenset[str] | None, angle: str, told: Sequence[str]) -> bool:
    """Whether a sentence has told an angle, of that line where the vector is normal to one."""
    several = " + " in angle or " - " in angle
    if line is None or not (line or several):
        return True
    clauses = (text for text in told if angle in text and (several or _CLAUSE.search(text)))
    return any(not line or line in _find_lines(text) for text in clauses)


def _find_lines(text: str) -> set[frozenset[str]]:
    """The lines that formulas of a sentence name, each by its points."""
    parts = (part for one in _FORMULA.findall(text) for part in re.split(r"\\perp|\\parallel", one))
    return {_find_points(part) for part in parts}


def _find_points(letters: str) -> frozenset[str]:
    return frozenset(POINT.findall(letters.strip()))


def find_projected(row: Row) -> Iterator[tuple[str, str]]:
    """The vectors that a formula has times a sine or cosine, each with the angle of that."""
    for place, node in enumerate(row):
        if place and isinstance(node, Function) and node.name in ("sin", "cos"):
            vector = _name_vector(row[place - 1])
            if vector:
                yield vector, write_row(_read_argument(row[place + 1 :]))
        for part in list_parts(node):
            yield from find_projected(part)


def _name_vector(node: Node) -> str:
    """The symbol of a vector's component or magnitude; nothing for what is none."""
    if isinstance(node, Fenced) and len(node.row) == 1:
        return _name_vector(node.row[0])
    known = isinstance(node, Scripts) and node.base in (Letter("v"), Letter("a"))
    return write_row((node,)) if known else ""


def _read_argument(row: Row) -> Row:
    """What a function is of, of which the rest of a formula begins with the argument."""
    if row[:1] == (Sign("("),):
        return row[1 : next(place for place, node in enumerate(row) if node == Sign(")"))]
    if isinstance(row[0], Number):
        return row[:2]
    if row[0] == Sign(r"\angle"):
        after = (
            place
            for place, node in enumerate(row)
            if place and not isinstance(node, Letter | Scripts)
        )
        return row[: next(after, len(row))]
    return row[:1]
