"""Why a mechanism cannot be solved, in the language of mechanics."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from kinegrade.errors import MechanismError
from kinegrade.language.message import Message, list_all, list_plainly
from kinegrade.mechanics.dead_point import describe_dead_point, make_numeral
from kinegrade.mechanics.frames import Frames
from kinegrade.mechanics.plan import Equations
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.numbers.elimination import find_null_vectors, is_consistent


def explain_refusal(
    frames: Frames, equations: Equations, sides: Sequence[Sequence[Any]], arithmetic: Any
) -> MechanismError:
    """The error for relations that have no solution, or more than one; `sides` are their right-hand
    sides.
    """
    rates = list(
        dict.fromkeys(rate for relation in frames.relations for rate in relation.unknowns())
    )
    matrix = [[[row.get(rate, 0) for rate in rates] for row in rows] for rows in equations]
    rows = [_convert_row(row, arithmetic) for block in matrix for row in block]
    loose = find_null_vectors(rows, len(rates), arithmetic.is_zero)
    fits = is_consistent(
        rows, [make_numeral(s, arithmetic) for side in sides for s in side], arithmetic.is_zero
    )
    motions = [{rates[i] for i in vector} for vector in loose]
    turning = {rate.body for rate in set().union(*motions) if rate.kind == "turning"}
    line = describe_dead_point(frames, turning, arithmetic) if loose else None
    if fits and line:
        return MechanismError(Message("mechanics.dead-point", line=line))
    if fits:
        return MechanismError(describe_looseness(frames, motions))
    culprits = _find_contradiction(matrix, sides, arithmetic)
    names = list_all(frames.relations[index].origin for index in culprits)
    if not loose and len(culprits) == 1:
        return MechanismError(Message("mechanics.contradicts-joints", relation=names))
    if not loose:
        return MechanismError(Message("mechanics.contradiction", relations=names))
    if line:
        return MechanismError(
            Message("mechanics.dead-point-of-drivers", line=line, relations=names)
        )
    return MechanismError(Message("mechanics.dead-configuration", relations=names))


def describe_looseness(frames: Frames, motions: Sequence[set[Rate]]) -> Message:
    """Which bodies can still turn and which points can still move."""
    idle = find_unrelated(frames)
    moving = set().union(*motions, idle)
    bodies = sorted(rate.body for rate in moving if rate.kind == "turning")
    points = sorted({rate.point for rate in moving if rate.kind != "turning"})
    parts = [Message("mechanics.can-turn", body=body) for body in bodies]
    parts += [Message("mechanics.can-move", point=point) for point in points]
    count = len(motions) + len(idle)
    return Message("mechanics.loose", motions=list_plainly(parts), count=count)


def find_unrelated(frames: Frames) -> list[Rate]:
    """The rates of bodies and base points that occur in no relation, so that nothing determines
    them.
    """
    known = {rate for relation in frames.relations for rate in relation.unknowns()}
    rates = [make_turning(body.name) for body in frames.mechanism.bodies if not body.particle]
    rates += [term.rate for base in frames.bases.values() for term in base.chain]
    return [rate for rate in dict.fromkeys(rates) if rate not in known]


def _find_contradiction(
    matrix: Sequence[Sequence[Sequence[Any]]], sides: Sequence[Sequence[Any]], arithmetic: Any
) -> list[int]:
    """A minimal set of contradictory relations (by index): without any one of them the others
    agree.
    """
    culprits = list(range(len(matrix)))
    for index in list(culprits):
        rest = [other for other in culprits if other != index]
        rows = [_convert_row(row, arithmetic) for other in rest for row in matrix[other]]
        right = [make_numeral(side, arithmetic) for other in rest for side in sides[other]]
        if rows and not is_consistent(rows, right, arithmetic.is_zero):
            culprits = rest
    return culprits


def _convert_row(row: Sequence[Any], arithmetic: Any) -> list[Any]:
    """A row as numbers of the arithmetic."""
    return [make_numeral(entry, arithmetic) for entry in row]
