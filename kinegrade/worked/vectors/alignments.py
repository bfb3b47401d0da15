"""Lines that are parallel or at right angles at this instant alone, on which a projection in
letters rests: with other numbers of the same problem its cosines would not be one or zero.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import chain
from typing import Literal, TypeAlias

from kinegrade.language.math.tree import Letter, Row, Sign
from kinegrade.language.message import Listing, Message
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Part
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.measures import bearing
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.vectors.projection import Projection
from kinegrade.worked.vectors.slopes.directions import find_ends
from kinegrade.worked.vectors.slopes.inclination import name_axis
from kinegrade.worked.vectors.vectors import vanishes

_Line: TypeAlias = tuple[str, str]  # through two points
_Relation: TypeAlias = Literal[r"\parallel", r"\perp"]
_RELATIONS: tuple[_Relation, _Relation] = (r"\parallel", r"\perp")  # by quarters of a turn


@dataclass(frozen=True)
class Alignment:
    """A line, parallel or normal to another one, or to the x axis (None)."""

    line: _Line
    relation: _Relation
    other: _Line | None

    @property
    def pair(self) -> frozenset[frozenset[str]]:
        """The two lines in any order."""
        return frozenset((frozenset(self.line), frozenset(self.other or ())))


def explain_alignments(projection: Projection, case: Case) -> Iterator[Block]:
    """Which lines of a projection are aligned by this paper's numbers, each said once."""
    new = list(_select_new(_list_alignments(projection, case), case.findings.aligned))
    if new:
        lines = Listing(tuple(f"${case.text(_name(one, case))}$" for one in new), "and")
        yield case.say(Message("solution.aligned", lines=lines))


def _select_new(
    found: Iterable[Alignment], said: set[frozenset[frozenset[str]]]
) -> Iterator[Alignment]:
    """Those that have not been said, nor follow from two that have."""
    for one in found:
        first, second = one.pair
        follows = any({first, third} in said and {second, third} in said for third in chain(*said))
        if one.pair not in said and not follows:
            said.add(one.pair)
            yield one


def _name(alignment: Alignment, case: Case) -> Symbol:
    """An alignment in letters: AB parallel to CD, AB normal to x."""
    line, sign = _join(alignment.line, case), Sign(alignment.relation)
    other = _join(alignment.other, case) if alignment.other else (Letter("x"),)
    return Symbol((*line, sign, *other))


def _join(line: _Line, case: Case) -> Row:
    return join_letters(map(case.naming.letter, line)).row


def _list_alignments(projection: Projection, case: Case) -> Iterator[Alignment]:
    """The alignments of the lines of all parts with the x axis, else with the line that gives the
    axis of projection.
    """
    nearby = case.nearby
    if nearby is None:
        return
    lines = (_find_line(part, case) for part in projection.equation.parts if not vanishes(part))
    reference = _find_line(projection.reference, case) if projection.reference else None
    for line in filter(None, dict.fromkeys(lines)):
        for other in dict.fromkeys((None, reference)):
            relation = _find_relation(line, other, case.motion.points)
            if relation is None or line == other:
                continue
            if _find_relation(line, other, nearby) is None:
                yield Alignment(line, relation, other)
            break


def _find_line(part: Part, case: Case) -> _Line | None:
    """The line along or normal to which a part lies, where points give it."""
    ends = find_ends(part, case)
    return ends if ends is not None and {*ends} <= {*case.motion.points} else None


def _find_relation(
    line: _Line, other: _Line | None, points: Mapping[str, Vector]
) -> _Relation | None:
    """How two lines lie, None where they are oblique."""
    axis = name_axis(_measure(line, points) - _measure(other, points))
    return None if axis is None else _RELATIONS[axis.quarters % 2]


def _measure(line: _Line | None, points: Mapping[str, Vector]) -> float:
    """The direction of a line in degrees, that of the x axis for None."""
    if line is None:
        return 0.0
    start, end = (points[point] for point in line)
    return bearing(end - start)
