"""The vector equations of a solved motion, vector by vector, as textbooks write them.

    v_B = v_A + v_BA                v_a = v_e + v_r
    a_B = a_A + a_BA^n + a_BA^t     a_a = a_e^n + a_e^t + a_r + a_Cor

The terms of a relation that are known already are drawn together into one vector; the others stand
one by one, an acceleration in its normal, tangential and Coriolis parts. `kinegrade.worked` puts
these into words.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Literal, assert_never

from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Chain, Term
from kinegrade.mechanics.vector import Vector, add_vectors

Level = Literal["velocity", "acceleration"]
Role = Literal["absolute", "transport", "relative", "rotation", "coriolis"]


@dataclass(frozen=True)
class Part:
    """One vector of a vector equation.

    absolute: of `point`, about the fixed `base` where there is one, else along its path, or drawn
    together; transport: of the point of the moving body that coincides with `point`; relative: of
    `point` relative to `frame`; rotation: of `point` relative to `base`, a point of the same body;
    `coincident` when it stands for the moving body's point at `point`; coriolis: the acceleration.

    `composition` numbers the compositions of motions of an equation, from 0: transport, relative
    and Coriolis parts of one have the same number. `part` is "n" or "t" for the normal and
    tangential part of an acceleration. `term` is the term it comes from, None where several
    (`number_together`) are drawn together. `coefficient` is the vector that the unknown rate (or
    its change) multiplies, None where the part is known; `value` is the vector, m/s or m/s^2.
    """

    role: Role
    point: str
    value: Vector
    term: Term | None = None
    coefficient: Vector | None = None
    part: Literal["", "n", "t"] = ""
    frame: str = GROUND
    coincident: bool = False
    composition: int = 0
    together: Chain = ()

    @property
    def base(self) -> str:
        """The base point or centre, "" where there is none."""
        return self.term.base if self.term else ""

    @property
    def unknown(self) -> Rate | None:
        """The unknown rate of this part, None where the part is known."""
        return self.term.rate if self.term and self.coefficient is not None else None


@dataclass(frozen=True)
class VectorEquation:
    """left = right; `relation` is where it comes from.

    Its compositions of motions are numbered from `first` where others are solved together with
    them, `among` in all.
    """

    relation: Relation
    left: tuple[Part, ...]
    right: tuple[Part, ...]
    level: Level
    first: int = 0
    among: int = 1
    turned: bool = False  # whether its base point is not that of the body's chain

    @property
    def parts(self) -> tuple[Part, ...]:
        """All parts, those of the left side first."""
        return (*self.left, *self.right)

    @property
    def unknowns(self) -> tuple[Rate, ...]:
        """The unknown rates, in order of occurrence."""
        return tuple(dict.fromkeys(part.unknown for part in self.parts if part.unknown))

    def coefficient(self, rate: Rate) -> Vector:
        """The vector that an unknown rate multiplies when everything stands on the left."""
        return _add_coefficients(self.left, rate) - _add_coefficients(self.right, rate)

    @property
    def compositions(self) -> tuple[Part, ...]:
        """The relative parts, one for each composition of motions."""
        return tuple(part for part in self.parts if part.role == "relative" and part.part != "n")


def _add_coefficients(parts: Sequence[Part], rate: Rate) -> Vector:
    """The vector that an unknown rate multiplies in some parts."""
    return add_vectors(
        part.coefficient for part in parts if part.unknown == rate and part.coefficient is not None
    )


def write_vector_equation(
    relation: Relation, motion: Motion, known: Collection[Rate], level: Level
) -> VectorEquation:
    """The vector equation of a relation at the stage where the rates `known` are known (their
    changes, for accelerations, of which all velocities are known).
    """
    left = list(_list_chain_parts(relation.left, motion, known, level))
    right = list(_list_chain_parts(relation.right, motion, known, level))
    if is_whole(right) and not is_whole(left):  # v_B = v_A + v_BA, not the other way round
        left, right = right, left
    parts = _number_parts([*left, *right])
    return VectorEquation(relation, tuple(parts[: len(left)]), tuple(parts[len(left) :]), level)


def number_together(equations: Sequence[VectorEquation]) -> tuple[VectorEquation, ...]:
    """The same equations with their compositions of motions numbered consecutively."""
    counts = [len(equation.compositions) for equation in equations]
    return tuple(
        replace(equation, first=sum(counts[:place]), among=sum(counts))
        for place, equation in enumerate(equations)
    )


def is_whole(parts: Sequence[Part]) -> bool:
    """Whether one side of an equation is the absolute motion of one point and nothing else."""
    return (
        bool(parts)
        and all(part.role == "absolute" for part in parts)
        and len({part.point for part in parts}) == 1
    )


def _number_parts(parts: Sequence[Part]) -> list[Part]:
    """The parts with the numbers of their compositions: each ends with the last part of its
    relative motion.
    """
    number, result = 0, []
    for part, following in zip(parts, (*parts[1:], None), strict=True):
        result.append(replace(part, composition=number))
        ends = part.role in ("relative", "coriolis") and (
            following is None or following.term is not part.term
        )
        number += ends
    return result


def _list_chain_parts(
    chain: Chain, motion: Motion, known: Collection[Rate], level: Level
) -> Iterator[Part]:
    """The parts of one side: what is known from the ground outwards as one vector, then term by
    term.
    """
    count = next((place for place, term in enumerate(chain) if term.rate not in known), len(chain))
    if count > 1 and chain[count - 1].frame != GROUND:
        count -= 1  # a relative motion is a part by itself, even a known one
    if count > 1:
        yield _join_terms(chain[:count], motion, level, _transports(chain, count))
    for place in range(count if count > 1 else 0, len(chain)):
        for part in list_term_parts(chain[place], motion, known, level):
            yield _place_part(part, chain, place)


def _transports(chain: Chain, count: int) -> bool:
    """Whether the first `count` terms lead to a point of a moving body in which something moves."""
    return count < len(chain) and chain[count].frame != GROUND


def _join_terms(chain: Chain, motion: Motion, level: Level, transport: bool) -> Part:
    """Known terms combined into one vector."""
    value = add_vectors(find_term_value(term, motion, level) for term in chain)
    return Part("transport" if transport else "absolute", chain[-1].point, value, together=chain)


def find_term_value(term: Term, motion: Motion, level: Level) -> Vector:
    """A term's velocity or acceleration, m/s or m/s^2."""
    match level:
        case "velocity":
            return term.velocity(motion.rates)
        case "acceleration":
            return term.acceleration(motion.rates, motion.changes)
        case _:
            assert_never(level)


def list_term_parts(
    term: Term, motion: Motion, known: Collection[Rate], level: Level
) -> Iterator[Part]:
    """One term's velocity, or the parts of its acceleration; those that vanish identically are left
    out.
    """
    role: Role = "relative" if term.frame != GROUND else "rotation"
    unknown = None if term.rate in known else term.coefficient()
    match level:
        case "velocity":
            velocity = term.velocity(motion.rates)
            yield Part(role, term.point, velocity, term, unknown, frame=term.frame)
        case "acceleration":
            yield from _list_acceleration_parts(term, motion, role, unknown)
        case _:
            assert_never(level)


def _list_acceleration_parts(
    term: Term, motion: Motion, role: Role, unknown: Vector | None
) -> Iterator[Part]:
    """The normal, tangential and Coriolis parts of a term's acceleration; `unknown` multiplies the
    unknown rate.
    """
    along = term.coefficient() * motion.changes[term.rate]
    match term.kind:
        case "sliding":
            yield Part(role, term.point, along, term, unknown, frame=term.frame)
        case "rotation" | "arc":
            normal = term.normal(motion.rates)
            yield Part(role, term.point, normal, term, part="n", frame=term.frame)
            yield Part(role, term.point, along, term, unknown, "t", term.frame)
        case _:
            assert_never(term.kind)
    if term.frame != GROUND:
        yield Part("coriolis", term.point, term.coriolis(motion.rates), term, frame=term.frame)


def _place_part(part: Part, chain: Chain, place: int) -> Part:
    """The part in the role of its place in the chain: first terms are absolute, or transport."""
    match part.role:
        case "absolute" | "transport" | "relative" | "coriolis":
            return part
        case "rotation":
            return _place_rotation(part, chain, place)
        case _:
            assert_never(part.role)


def _place_rotation(part: Part, chain: Chain, place: int) -> Part:
    """A rotation with its role: absolute or transport at the head of a chain, and for a free
    point's components.
    """
    transport = _transports(chain, place + 1)
    if place == 0:
        return replace(part, role="transport" if transport else "absolute")
    both_free = part.term is not None and part.term.kind == "sliding"
    return replace(part, role="absolute") if both_free else replace(part, coincident=transport)
