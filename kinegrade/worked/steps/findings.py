"""What a worked solution has found so far: the vectors of points, their symbols and numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import assert_never

from kinegrade.expressions.expression import Expression
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations import Chain, add_vectors
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level, Part, VectorEquation, is_whole
from kinegrade.worked.steps.known_vectors import find_positive_sense, list_ways
from kinegrade.worked.steps.vectors import (
    write_composition_number,
    write_letter,
    write_letters,
    write_subscript,
)
from kinegrade.worked.words.solution_case import LETTERS, Case

Key = tuple[Level, tuple[tuple[Rate, str, str], ...]]


@dataclass(frozen=True)
class Piece:
    """A vector given by one number: its symbol, the direction in which that counts positive, its
    value.
    """

    symbol: str
    positive: Vector
    value: Vector


@dataclass(frozen=True)
class Fact:
    """A vector that the solution has found: its symbol, and whether by components or by magnitudes
    and directions.

    `pieces` are the vectors whose sum it is where it is given by magnitudes: itself, or a normal
    and a tangential part.
    """

    symbol: str
    value: Vector
    by_components: bool
    pieces: tuple[Piece, ...] = ()

    @property
    def parts(self) -> tuple[Piece, ...]:
        """The pieces, or the vector itself where it is given by magnitude and direction."""
        return self.pieces or (Piece(self.symbol, self.value, self.value),)


@dataclass
class Findings:
    """What a solution has found so far, filled in as it is written.

    `numbers` are those of the relative motions where a step has several, by the rate of each;
    `sized` the symbols of vectors known by components whose magnitude has been given as well.
    """

    facts: dict[Key, Fact] = field(default_factory=dict)
    answered: dict[Expression, Fact] = field(default_factory=dict)
    poles: dict[str, str] = field(default_factory=dict)
    numbers: dict[Rate, str] = field(default_factory=dict)
    sized: set[str] = field(default_factory=set)

    def note(self, equation: VectorEquation, case: Case) -> None:
        """Record what a solved equation gives: the vector that stands alone on one side, which is
        that of both chains, the vectors of points fixed only to the ground, and the numbers of its
        relative motions.
        """
        for part in equation.compositions:
            if part.term is not None:
                self.numbers[part.term.rate] = write_composition_number(equation, part)
        relation = equation.relation
        whole = next((side for side in (equation.left, equation.right) if is_whole(side)), None)
        if whole is not None:
            for chain in (relation.left, relation.right):
                self.facts.setdefault(
                    make_key(chain, equation.level), _find_fact(whole, equation, case)
                )
        for chain in (relation.left, relation.right):
            first = [
                part
                for part in equation.parts
                if chain and part.term is chain[0] and part.role in ("absolute", "transport")
            ]
            if first:
                self.facts.setdefault(
                    make_key(chain[:1], equation.level), _find_fact(first, equation, case)
                )


def _find_fact(parts: Sequence[Part], equation: VectorEquation, case: Case) -> Fact:
    """The vector of one point whose parts stand in an equation."""
    pieces = tuple(
        Piece(write_letters(equation, part, case), _find_sense(part, case), part.value)
        for part in parts
    )
    transport = f"{write_letter(equation)}_{{{write_subscript(equation, parts[0], case)}}}"
    first = parts[0]
    match first.role:
        case "transport":
            symbol = transport
        case "absolute" | "relative" | "rotation" | "coriolis":
            symbol = write_point_symbol(first.point, equation.level, case)
        case _:
            assert_never(first.role)
    return Fact(symbol, add_vectors(part.value for part in parts), False, pieces)


def _find_sense(part: Part, case: Case) -> Vector:
    """The direction in which a part's number counts positive: the part's direction where only its
    magnitude is given.
    """
    if part.coefficient is not None:
        return part.coefficient
    if part.term is None or part.part == "n" or part.term.kind == "rotation":
        return part.value
    return find_positive_sense(part.term, case)


def make_key(chain: Chain, level: Level) -> Key:
    """The key under which a chain's vector is kept."""
    return level, list_ways(chain)


def write_point_symbol(point: str, level: Level, case: Case) -> str:
    """The symbol of a point's velocity or acceleration."""
    return f"{LETTERS[level]}_{{{case.naming.point(point)}}}"
