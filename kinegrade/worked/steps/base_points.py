"""The base point of a vector equation: the point of a body whose motion is known, even where the
chain of the body begins at another one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from kinegrade.mechanics.vector_equation import Part, VectorEquation, is_whole


def start_from_known(equation: VectorEquation) -> VectorEquation:
    """v_B = v_A + v_BA for v_A = v_B + v_AB where v_A alone is known; others as they are."""
    if not _starts_from_unknown(equation.left, equation.right):
        return equation
    head, rest = _split_head(equation.right)
    right = (*equation.left, *map(_turn_about_point, rest))
    return replace(equation, left=tuple(head), right=right, turned=True)


def _starts_from_unknown(left: Sequence[Part], right: Sequence[Part]) -> bool:
    """Whether a point whose motion is known is reached from a point of its body whose motion is
    not: v_A = v_B + v_AB with v_A known.
    """
    head, rest = _split_head(right)
    return (
        is_whole(left)
        and not any(part.unknown for part in left)
        and is_whole(head)
        and any(part.unknown for part in head)
        and bool(rest)
        and all(_turns_freely(part) for part in rest)
        and len({part.point for part in rest}) == 1
    )


def _split_head(parts: Sequence[Part]) -> tuple[Sequence[Part], Sequence[Part]]:
    """The absolute parts that come first, and the others."""
    count = next((place for place, part in enumerate(parts) if part.role != "absolute"), len(parts))
    return parts[:count], parts[count:]


def _turns_freely(part: Part) -> bool:
    """Whether a part is that of a point about another of its body."""
    turns = part.term is not None and part.term.kind == "rotation"
    return turns and part.role == "rotation" and not part.coincident


def _turn_about_point(part: Part) -> Part:
    """The motion of the base point about the point, opposite to that of the point about it."""
    if part.term is None:
        return part
    term = replace(part.term, vector=-part.term.vector, point=part.term.base, base=part.term.point)
    coefficient = None if part.coefficient is None else -part.coefficient
    return replace(part, point=term.point, value=-part.value, term=term, coefficient=coefficient)
