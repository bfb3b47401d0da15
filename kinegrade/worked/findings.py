"""What a worked solution has found so far: the vectors of points, their symbols and numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from kinegrade.expressions.tree import Expression
from kinegrade.language.math.tree import Row
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.formulas.atoms import Symbol, VectorSymbol
from kinegrade.worked.formulas.equation import Equation
from kinegrade.worked.formulas.formula import Formula

Ways: TypeAlias = tuple[tuple[Rate, str, str], ...]  # what distinguishes chains of terms
Key: TypeAlias = tuple[Level, Ways]
Pair: TypeAlias = frozenset[frozenset[object]]  # of lines, by their points, or of one and the axes


@dataclass(frozen=True)
class Moved:
    """A rate where an equation of accelerations has the velocity that it makes."""

    rate: Rate


# What an equation says of rates: what multiplies each of them, all on one side
Form: TypeAlias = Mapping[Rate | Moved, float]
Stated: TypeAlias = tuple[Formula, int, float]  # an angle, its sign, its degrees


@dataclass(frozen=True)
class Piece:
    """A vector given by one number: its symbol, the direction in which that counts positive, its
    value, and the term that it is, or is a part of; None where it is none.
    """

    symbol: VectorSymbol
    positive: Vector
    value: Vector
    term: Term | None = None


@dataclass(frozen=True)
class Fact:
    """A vector that the solution has found: its symbol, and whether by components or by magnitudes
    and directions.

    `pieces` are the vectors whose sum it is where it is given by magnitudes: itself, or a normal
    and a tangential part.
    """

    symbol: VectorSymbol
    value: Vector
    by_components: bool
    pieces: tuple[Piece, ...] = ()

    @property
    def parts(self) -> tuple[Piece, ...]:
        """The pieces, or the vector itself where it is given by magnitude and direction."""
        return self.pieces or (Piece(self.symbol, self.value, self.value),)


@dataclass(frozen=True)
class Seen:
    """The direction in which one point is seen from another: that of a side of a triangle, turned
    through the triangle's angle, which stands in `tree` under `name`.
    """

    tree: Expression
    name: str
    symbol: Symbol
    value: Any


@dataclass(frozen=True)
class Checked:
    """What a check says of rates, and what the steps of its chapter have said of them before."""

    check: Form
    steps: tuple[Form, ...]


@dataclass
class Findings:
    """What a solution has found so far, filled in as it is written.

    `relatives` are the indices of the relative motions, each given by point, body and frame;
    `inclined` the lines whose angle with the x axis has been found; `summed` the sums of angles, in
    degrees, that have been worked out; `aligned` pairs of lines that have been said to be parallel
    or normal at this instant; `sized` the symbols of vectors known by components whose magnitude
    has been given as well; `counted` the answers counted against their letter; `directed` the
    Coriolis accelerations whose direction has been said; `arms` the distances of two points that
    have been worked out; `places_alone` whether all answers are places of poles that normals lead
    to, so that speeds are left out; `seen` the directions that triangles have given, each from one
    point to another; `poles_sought` the bodies about whose poles answers are; `distances` the
    printed symbols of the distances of poles that have been worked out; `corners` the letters of
    polygons that have been explained; `stated` the angles by which givens state lines; `told` the
    formulas within sentences; `spared` the rates that no answer and no later step needs, so that a
    check alone may ask for them; `rim_tracks` how a track moves that has the speed of a wheel's
    rim, by the number of their joint; `written` the formulas of sentences by their text;
    `translated` the bodies of which has been said that their points have one velocity or
    acceleration; `composed` the moving frames, each with the body whose points move relative to it,
    of which the composition of motions has been explained; `coincident` the primed letters that
    have been; `parts_explained` whether it has been said what the indices n and t mark; `leaning`
    the lines, one or two, whose angle with an axis or with one another has been told for a
    projection; `checked` what the checks say; `printed` the equations.
    """

    facts: dict[Key, Fact] = field(default_factory=dict)
    answered: dict[Expression, Fact] = field(default_factory=dict)
    poles: dict[str, str] = field(default_factory=dict)
    circles: set[str] = field(default_factory=set)
    relatives: dict[tuple[str, str, str], Row] = field(default_factory=dict)
    sized: set[VectorSymbol] = field(default_factory=set)
    counted: set[str] = field(default_factory=set)
    inclined: set[tuple[str, str]] = field(default_factory=set)
    summed: set[frozenset[float]] = field(default_factory=set)
    directed: set[VectorSymbol] = field(default_factory=set)
    aligned: set[frozenset[frozenset[str]]] = field(default_factory=set)
    arms: dict[frozenset[str], Symbol] = field(default_factory=dict)
    seen: dict[tuple[Expression, Expression], Seen] = field(default_factory=dict)
    places_alone: bool = False
    parts_explained: bool = False
    poles_sought: frozenset[str] = frozenset()
    distances: set[Row] = field(default_factory=set)
    corners: set[str] = field(default_factory=set)
    leaning: set[Pair] = field(default_factory=set)
    rim_tracks: dict[int, Term] = field(default_factory=dict)
    legs: dict[frozenset[str], tuple[str, str]] = field(default_factory=dict)
    printed: list[Equation] = field(default_factory=list)
    checked: list[Checked] = field(default_factory=list)
    is_checked: bool = False
    stated: dict[tuple[str, str], Stated | None] = field(default_factory=dict)
    composed: set[tuple[Level, str, str | None]] = field(default_factory=set)
    coincident: set[str] = field(default_factory=set)
    told: list[Row] = field(default_factory=list)
    written: dict[str, Row] = field(default_factory=dict)
    translated: dict[Level, set[str]] = field(
        default_factory=lambda: {"velocity": set(), "acceleration": set()}
    )
    spared: dict[Level, frozenset[Rate]] = field(
        default_factory=lambda: {"velocity": frozenset(), "acceleration": frozenset()}
    )

    def is_negative(self, symbol: Formula) -> bool:
        """Whether an equation has given a letter a negative value."""
        return any(
            one.left.looks_like(symbol) and one.links and one.links[-1].right.sign < 0
            for one in self.printed
        )

    def is_size_alone(self, symbol: Formula) -> bool:
        """Whether equations have given the magnitude of what a letter is, and not its sign."""
        lefts = [one.left for one in self.printed]
        sized = any(one.looks_like(abs(symbol)) for one in lefts)
        return sized and not any(one.looks_like(symbol) for one in lefts)

    def spares(self, rate: Rate, level: Level) -> bool:
        """Whether neither an answer nor a later step needs a rate."""
        return rate in self.spared[level]
