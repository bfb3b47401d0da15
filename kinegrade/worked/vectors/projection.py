"""Which projections solve a step: each on an axis normal to one unknown vector, which thereby drops
out.

Only directions are decided here, in doubles; the values come from the exact motion.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import cos, radians, sin

from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.formulas.measures import bearing, size, tidy
from kinegrade.worked.vectors.table.tracks import find_heading
from kinegrade.worked.vectors.vectors import vanishes

PARALLEL = 1e-9  # sine of the angle below which two directions count as parallel


@dataclass(frozen=True)
class Share:
    """What one part contributes to a projection: its magnitude times the cosine of `angle`, with a
    sign; angle in degrees.
    """

    part: Part
    sign: int
    angle: float


@dataclass(frozen=True)
class Projection:
    """A vector equation projected on the axis at `axis` degrees; `dropped` is the unknown part
    normal to it.
    """

    equation: VectorEquation
    axis: float
    dropped: Part | None

    @cached_property
    def left(self) -> tuple[Share, ...]:
        """The shares of the left side."""
        return tuple(self._shares(self.equation.left))

    @cached_property
    def right(self) -> tuple[Share, ...]:
        """The shares of the right side."""
        return tuple(self._shares(self.equation.right))

    @property
    def shares(self) -> tuple[Share, ...]:
        """The shares of both sides."""
        return (*self.left, *self.right)

    @property
    def reference(self) -> Part | None:
        """The part that gives the axis: the one normal to it, else one along it."""
        along = (share.part for share in self.shares if not share.angle)
        return self.dropped or next(along, None)

    def _shares(self, parts: Sequence[Part]) -> Iterator[Share]:
        for part in parts:
            if vanishes(part) or size(find_heading(part)) == 0:
                continue
            angle = abs((bearing(find_heading(part)) - self.axis + 180) % 360 - 180)
            if abs(angle - 90) > 1e-7:
                yield Share(part, 1 if angle < 90 else -1, tidy(min(angle, 180 - angle)))

    @property
    def direction(self) -> Vector:
        """The unit vector of the axis."""
        return Vector(cos(radians(self.axis)), sin(radians(self.axis)))

    def row(self) -> dict[Rate, float]:
        """The coefficients of the unknown rates with everything on the left side."""
        return {
            rate: self.direction.dot(self.equation.coefficient(rate).map(float))
            for rate in self.equation.unknowns
        }

    def involves(self, rate: Rate) -> bool:
        """Whether a rate remains in the projection."""
        return abs(self.row().get(rate, 0.0)) > PARALLEL


@dataclass(frozen=True)
class Deduction:
    """Equations that together give the rates `unknowns`: projections, and relations between
    rates.
    """

    projections: tuple[Projection, ...]
    scalars: tuple[Relation, ...]
    unknowns: tuple[Rate, ...]


def find_deductions(
    equations: Sequence[VectorEquation], scalars: Sequence[Relation], unknowns: Sequence[Rate]
) -> Iterator[Deduction]:
    """How the vector equations and scalar relations of a step give its unknown rates, one deduction
    after the other.

    An unknown that occurs in only one equation is first projected out of it; the shared unknowns
    are solved for together, then each of the others follows.
    """
    unshared = {
        index: _find_private_unknowns(index, equations, scalars) for index in range(len(equations))
    }
    shared = [rate for rate in unknowns if not any(rate in rates for rates in unshared.values())]
    if shared:
        core = [
            projection
            for index, equation in enumerate(equations)
            for projection in _find_core_projections(equation, unshared[index])
        ]
        yield from _take_apart(_select_enough(core, scalars, shared), scalars, shared)
    for index, equation in enumerate(equations):
        for rate in unshared[index]:
            others = [other for other in unshared[index] if other != rate]
            yield Deduction((_project_toward(equation, rate, others),), (), (rate,))


def _take_apart(
    projections: Sequence[Projection], scalars: Sequence[Relation], shared: Sequence[Rate]
) -> Iterator[Deduction]:
    """The deductions of shared unknowns: a projection in which one alone is left gives that, the
    rest are solved for together.
    """
    left, unsolved = list(projections), list(shared)
    while found := next(_find_single(left, unsolved), None):
        projection, rate = found
        left.remove(projection)
        unsolved.remove(rate)
        yield Deduction((projection,), (), (rate,))
    if unsolved:
        yield Deduction(tuple(left), tuple(scalars), tuple(unsolved))


def _find_single(
    projections: Sequence[Projection], unsolved: Sequence[Rate]
) -> Iterator[tuple[Projection, Rate]]:
    """The projections in which one unknown alone is left, with that."""
    for projection in projections:
        involved = [rate for rate in unsolved if projection.involves(rate)]
        if len(involved) == 1:
            yield projection, involved[0]


def _find_private_unknowns(
    index: int, equations: Sequence[VectorEquation], scalars: Sequence[Relation]
) -> list[Rate]:
    """The unknowns that occur only in the equation at `index`; the rotation of a body comes
    last.
    """
    elsewhere = {
        rate
        for other, equation in enumerate(equations)
        if other != index
        for rate in equation.unknowns
    }
    elsewhere |= {rate for scalar in scalars for rate, _ in scalar.turning}
    return sorted(
        (rate for rate in equations[index].unknowns if rate not in elsewhere),
        key=lambda rate: rate.kind == "turning",
    )


def _find_core_projections(
    equation: VectorEquation, unshared: Sequence[Rate]
) -> Iterator[Projection]:
    """The projections of an equation in which only unknowns that it shares with others remain."""
    if len(unshared) == 1:
        yield _project_normal_to(equation, unshared[0])
    elif not unshared:
        first, *others = equation.unknowns
        across = [rate for rate in others if not _are_parallel(equation, first, rate)]
        yield _project_normal_to(equation, first)
        yield (
            _project_normal_to(equation, across[0]) if across else _project_along(equation, first)
        )


def _are_parallel(equation: VectorEquation, first: Rate, second: Rate) -> bool:
    """Whether two unknowns of an equation lie along one line, as of a wheel between two tracks."""
    one, other = (equation.coefficient(rate).map(float) for rate in (first, second))
    return bool(abs(one.cross(other)) <= PARALLEL * size(one) * size(other))


def _select_enough(
    core: Sequence[Projection], scalars: Sequence[Relation], shared: Sequence[Rate]
) -> tuple[Projection, ...]:
    """As many of the projections as are needed besides the scalar relations."""
    needed = max(len(shared) - len(scalars), 0)
    telling = [
        projection for projection in core if any(projection.involves(rate) for rate in shared)
    ]
    return tuple(telling[:needed])


def _project_toward(equation: VectorEquation, rate: Rate, others: Sequence[Rate]) -> Projection:
    """The projection that gives a rate: normal to the other unknown, else along the part of the
    rate itself.
    """
    return (
        _project_normal_to(equation, others[0], rate) if others else _project_along(equation, rate)
    )


def _project_normal_to(
    equation: VectorEquation, rate: Rate, sought: Rate | None = None
) -> Projection:
    """The projection on the axis normal to an unknown, oriented so that few parts are negative."""
    axis = (bearing(equation.coefficient(rate).map(float)) + 90) % 360
    dropped = next(part for part in equation.parts if part.unknown == rate)
    return _orient(Projection(equation, axis, dropped), sought)


def _project_along(equation: VectorEquation, rate: Rate) -> Projection:
    """The projection on the direction of an unknown."""
    return _orient(Projection(equation, bearing(equation.coefficient(rate).map(float)), None), rate)


def _orient(projection: Projection, sought: Rate | None) -> Projection:
    """The projection, with its axis reversed where most parts are negative; in a tie the unknown
    sought decides.
    """
    balance = sum(share.sign for share in projection.shares)
    deciding = [share for share in projection.shares if balance or share.part.unknown == sought]
    if sum(share.sign for share in deciding) >= 0:
        return projection
    return Projection(projection.equation, (projection.axis + 180) % 360, projection.dropped)
