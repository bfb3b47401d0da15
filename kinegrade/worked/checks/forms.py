"""What equations say of rates, however they are written: what multiplies each rate, all on one
side. Of two equations that are multiples of one another the one tells nothing that the other has
not told.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import sqrt
from typing import assert_never

from kinegrade.mechanics.laws import find_rolling
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector import Vector, add_vectors
from kinegrade.mechanics.vector_equation import Level, find_term_value
from kinegrade.worked.case import Case
from kinegrade.worked.findings import Fact, Form, Moved
from kinegrade.worked.formulas.measures import double, is_zero
from kinegrade.worked.steps.couplers import find_coupler
from kinegrade.worked.steps.methods import find_way
from kinegrade.worked.steps.rigid import find_rigid_triangle
from kinegrade.worked.steps.titles import select_scalars
from kinegrade.worked.steps.two_tracks import TwoTracks, find_two_tracks
from kinegrade.worked.vectors.projection import find_deductions
from kinegrade.worked.vectors.stage import Stage

_SAME = 1e-9  # what is left of a form, relative to its size, where it is nothing
_LEVELS: Mapping[str, Level] = {"v": "velocity", "a": "acceleration"}


def multiply_relation(relation: Relation, by: Vector) -> Form:
    """A vector equation times a vector."""
    return subtract(multiply_chain(relation.left, by), multiply_chain(relation.right, by))


def multiply_chain(chain: Chain, by: Vector) -> Form:
    """The vector of a chain times a vector."""
    form: dict[Rate | Moved, float] = {}
    for term in chain:
        form[term.rate] = form.get(term.rate, 0.0) + _multiply(by, term)
    return form


def compare_points(
    body: str, points: tuple[str, str], facts: tuple[Fact, Fact], by: Vector, case: Case
) -> Form:
    """The rotation of a body about one of its points, times a vector, by what has been found of
    both points.
    """
    first, second = (
        multiply_chain(_find_source(fact, case.motion.frames.chain(body, point), case), by)
        for point, fact in zip(points, facts, strict=True)
    )
    start, end = (case.motion.points[point] for point in points)
    turned = by.map(double).dot((end - start).map(double).turned())
    return subtract(subtract(second, first), {make_turning(body): turned})


def _find_source(fact: Fact, chain: Chain, case: Case) -> Chain:
    """The terms of a point's vector: those by which another body has led to it, else those of this
    one, of which a part may have only the direction.
    """
    terms = {piece.term.rate: piece.term for piece in fact.pieces if piece.term is not None}
    own, of_body = tuple(terms.values()), {term.rate for term in chain}
    if fact.by_components or terms.keys() <= of_body:
        return chain
    level = _LEVELS[fact.symbol.letter]
    added = add_vectors(find_term_value(term, case.motion, level) for term in own)
    return own if is_zero(added - fact.value) else chain


def subtract(first: Form, second: Form) -> Form:
    """The difference of two equations."""
    every = dict.fromkeys((*first, *second))
    return {rate: first.get(rate, 0.0) - second.get(rate, 0.0) for rate in every}


def state_form(relation: Relation) -> Form:
    """A relation of rates; the centre of a wheel that a body carries by its velocity."""
    form: dict[Rate | Moved, float] = {rate: double(factor) for rate, factor in relation.turning}
    along = relation.along
    if along is None:
        return form
    for sign, chain in ((1, relation.left), (-1, relation.right)):
        for term in chain:
            form[term.rate] = form.get(term.rate, 0.0) + sign * _multiply(along, term)
    return form


def _multiply(by: Vector, term: Term) -> float:
    return float(by.map(double).dot(term.coefficient().map(double)))


@dataclass(frozen=True)
class Told:
    """What equations have said of rates, each of size one, without the rates that are `held`, known
    to be zero.
    """

    forms: tuple[Form, ...]
    held: Collection[Rate]

    @staticmethod
    def by(solved: Iterable[Form], held: Collection[Rate]) -> Told:
        """What the equations that have been solved say."""
        return Told(tuple(_normalize(_leave_out(form, held)) for form in solved), held)

    def says(self, form: Form) -> bool:
        """Whether an equation holds for any rates, or is a multiple of one of these."""
        left = _normalize(_leave_out(form, self.held))
        return not left or any(_are_multiples(left, one) for one in self.forms)


def _leave_out(form: Form, held: Collection[Rate]) -> Form:
    every = {*held, *map(Moved, held)}
    return {rate: one for rate, one in form.items() if rate not in every}


def list_rates(form: Form) -> set[Rate]:
    """The rates that do not drop out."""
    return {rate for rate in _normalize(form) if not isinstance(rate, Moved)}


def _are_multiples(one: Form, other: Form) -> bool:
    """Whether two forms of size one differ by the sign at most."""
    if one.keys() != other.keys():
        return False
    turned = sum(one[rate] * other[rate] for rate in one)
    return all(abs(one[rate] * turned - other[rate]) < _SAME for rate in one)


def _normalize(form: Form) -> Form:
    """The form of size one, without what drops out."""
    largest = max(map(abs, form.values()), default=0.0)
    left = {rate: one for rate, one in form.items() if abs(one) > _SAME * largest}
    far = sqrt(sum(one * one for one in left.values()))
    return {rate: one / far for rate, one in left.items()} if far > _SAME else {}


def list_solved(step: Step, stage: Stage) -> Iterator[Form]:
    """The equations by which the solution of a step has found its unknowns."""
    scalars = select_scalars(step, stage.case)
    wheel = find_two_tracks(step, stage)
    if wheel is not None:
        yield from _list_tracks(wheel, scalars)
        return
    yield from map(state_form, scalars)
    way = find_way(step, stage)
    match way:
        case "rigid-triangle":
            yield from _list_circling(stage)
        case "pole":
            yield from _list_normals(stage)
        case "projection" | "base-point" | None:
            for deduction in find_deductions(stage.equations, scalars, step.unknowns):
                if not stage.spares(deduction):
                    for projection in deduction.projections:
                        by = projection.direction
                        yield multiply_relation(projection.equation.relation, by)
        case _:
            assert_never(way)


def _list_tracks(wheel: TwoTracks, scalars: Sequence[Relation]) -> Iterator[Form]:
    """The difference of both contacts, and that from which the centre's motion is found."""
    first, second = map(state_form, scalars)
    yield subtract(first, second)
    sources = [find_rolling(relation.source) for relation in scalars]
    if wheel.is_centre_needed:
        yield (first, second)[sources.index(wheel.start.roll)]


def _list_circling(stage: Stage) -> Iterator[Form]:
    """The rotations of both points about the centre, which are that of the body."""
    triangle = find_rigid_triangle(stage)
    if triangle is None:
        return
    for part in (triangle.known, triangle.sought):
        if part.term is not None:
            yield {part.term.rate: 1.0, make_turning(triangle.body): -1.0}


def _list_normals(stage: Stage) -> Iterator[Form]:
    """The speeds of both points by their distances from the pole."""
    coupler = find_coupler(stage)
    if coupler is None:
        return
    for part in (coupler.base, coupler.point):
        yield multiply_relation(coupler.equation.relation, part.value.turned())
