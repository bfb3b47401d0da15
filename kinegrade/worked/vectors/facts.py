"""What a solved equation adds to the findings of a solution."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import assert_never

from kinegrade.mechanics.relations.terms import Chain
from kinegrade.mechanics.vector import Vector, add_vectors
from kinegrade.mechanics.vector_equation import Level, Part, VectorEquation, is_whole
from kinegrade.worked.case import Case
from kinegrade.worked.findings import Fact, Key, Piece
from kinegrade.worked.vectors.known_vectors import find_positive_sense, list_ways
from kinegrade.worked.vectors.vectors import name_part, name_point_vector


def note_equation(equation: VectorEquation, case: Case) -> None:
    """Record what a solved equation gives: the vector that stands alone on one side, which is that
    of both chains, and the vectors of points fixed only to the ground.
    """
    relation = equation.relation
    whole = _find_whole(equation)
    if whole is not None and not _is_spared(whole, equation.level, case):
        for chain in (relation.left, relation.right):
            _keep(chain, _find_fact(whole, equation, case), equation.level, case)
    for chain in (relation.left, relation.right):
        first = [
            part
            for part in equation.parts
            if chain and part.term is chain[0] and part.role in ("absolute", "transport")
        ]
        if first and not _is_spared(first, equation.level, case):
            _keep(chain[:1], _find_fact(first, equation, case), equation.level, case)


def _find_whole(equation: VectorEquation) -> Sequence[Part] | None:
    """The vector of the point to which both chains lead."""
    if equation.turned:
        return [part for part in equation.right if part.role == "absolute"]
    return next((side for side in (equation.left, equation.right) if is_whole(side)), None)


def _is_spared(parts: Sequence[Part], level: Level, case: Case) -> bool:
    """Whether a vector's numbers are left out, as nothing needs them."""
    return any(part.unknown and case.findings.spares(part.unknown, level) for part in parts)


def _keep(chain: Chain, fact: Fact, level: Level, case: Case) -> None:
    """Record a fact that has not been recorded before."""
    case.findings.facts.setdefault(make_key(chain, level), fact)


def _find_fact(parts: Sequence[Part], equation: VectorEquation, case: Case) -> Fact:
    """The vector of one point whose parts stand in an equation."""
    pieces = tuple(
        Piece(
            name_part(equation, part, case),
            _find_sense(part, case, equation.level),
            part.value,
            part.term,
        )
        for part in parts
    )
    first = parts[0]
    match first.role:
        case "transport":
            symbol = replace(name_part(equation, first, case), part="")
        case "absolute" | "relative" | "rotation" | "coriolis":
            symbol = name_point_vector(first.point, equation.level, case)
        case _:
            assert_never(first.role)
    return Fact(symbol, add_vectors(part.value for part in parts), False, pieces)


def _find_sense(part: Part, case: Case, level: Level) -> Vector:
    """The direction in which a part's number counts positive: the part's direction where only its
    magnitude is given.
    """
    if part.term is not None and part.term.kind == "arc" and part.part != "n":
        return find_positive_sense(part.term, case, level)
    if part.coefficient is not None:
        return part.coefficient
    if part.term is None or part.part == "n" or part.term.kind == "rotation":
        return part.value
    return find_positive_sense(part.term, case, level)


def has_been_told(part: Part, case: Case, level: Level) -> bool:
    """Whether the magnitude and the direction of a part have been found before, under the symbol
    that it has alone.
    """
    fact = case.findings.facts.get(make_key((part.term,), level)) if part.term else None
    return fact is not None and not fact.by_components


def make_key(chain: Chain, level: Level) -> Key:
    """The key under which a chain's vector is kept."""
    return level, list_ways(chain)
