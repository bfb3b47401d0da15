"""Steps that need no vectors: what is given, bodies that rotate together, rolling without slipping,
meshing gears, belts.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import (
    EqualBeltSpeed,
    EqualPitchSpeed,
    EqualRotation,
    GuidedPoint,
    ImposedCircling,
    ImposedComponent,
    ImposedMotion,
    ImposedRotation,
    NoSlip,
    SharedPoint,
    find_rolling,
)
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.rates.driven import solve_relative, state_imposed
from kinegrade.worked.rates.rims import solve_rims, state_belt, state_meshing
from kinegrade.worked.rates.rolling import explain_rolls, group_rolls, state_rolling
from kinegrade.worked.rates.solved_rolling import solve_rolling
from kinegrade.worked.rates.speeds import Statement, name_rotation, state_rate


def state_relation(relation: Relation, case: Case, level: Level) -> Statement:
    """What a scalar relation says about velocities or about accelerations."""
    source = relation.source
    match source:
        case NoSlip():
            return state_rolling(source, relation, case, level)
        case EqualPitchSpeed():
            return state_meshing(source, case, level)
        case EqualBeltSpeed():
            return state_belt(source, case, level)
        case EqualRotation():
            return _state_equal_rotation(source, case, level)
        case ImposedRotation() | ImposedMotion() | ImposedComponent() | ImposedCircling():
            return state_imposed(source, relation, case, level)
        case SharedPoint() | GuidedPoint() | None:
            raise TypeError("a pin or a guide states no relation of rates alone")
        case _:
            assert_never(source)


def state_relations(
    relations: Sequence[Relation], case: Case, level: Level
) -> Iterator[tuple[Message, tuple[Equation, ...]]]:
    """What several relations say, with the reason that they share: a body that rolls on several
    others does so for one.
    """
    found = [(find_rolling(one.source), one) for one in relations]
    together = group_rolls(roll for roll, _ in found if roll is not None)
    for roll, relation in found:
        group = next((rolls for rolls in together if roll in rolls), ())
        if len(group) < 2:
            statement = state_relation(relation, case, level)
            yield statement.reason, (statement.equation,)
        elif roll == group[0]:
            members = (one for other, one in found if other in group)
            stated = tuple(state_relation(one, case, level).equation for one in members)
            yield explain_rolls(group, relation, case, level), stated


def _state_equal_rotation(law: EqualRotation, case: Case, level: Level) -> Statement:
    """Two bodies that do not turn relative to each other."""
    body, other = case.naming.body(law.body), case.naming.body(law.of)
    reason = Message(f"solution.parallel-{level}", body=body, other=other)
    title = Message("solution.title-parallel", body=body, other=other)
    left, right = (name_rotation(name, case, level) for name in (law.body, law.of))
    return Statement(title, reason, Equation(left, equate(right)))


def explain_scalar_step(
    relation: Relation, unknown: Rate, case: Case, level: Level
) -> Iterator[Block]:
    """A step of one scalar relation: the relation and the rate it gives."""
    statement = state_relation(relation, case, level)
    stated, result = statement.equation, state_rate(unknown, case, level)
    yield case.say(statement.reason)
    match relation.source:
        case ImposedRotation() | ImposedMotion() | ImposedComponent() | ImposedCircling() if (
            imposes_single_rate(relation)
        ):
            yield case.show(stated)
        case EqualRotation():
            links = (*stated.links, *result.links)
            yield case.show(Equation(stated.left, links, result.aside))
        case ImposedRotation() as imposed:
            yield case.show(stated, solve_relative(imposed, stated, result, case, level))
        case ImposedMotion() | ImposedComponent() | ImposedCircling():
            yield case.show(stated, result)
        case NoSlip() as roll:
            solved = solve_rolling(roll, relation, result, case, level)
            followed = solved is not None and (roll.of == GROUND or result.left == stated.left)
            yield case.show(*(() if followed else (stated,)), solved or result)
        case EqualPitchSpeed() | EqualBeltSpeed() as rims:
            yield case.show(stated, solve_rims(rims, result, case, level) or result)
        case SharedPoint() | GuidedPoint() | None:
            yield case.show(stated, result)
        case _:
            assert_never(relation.source)


def imposes_single_rate(relation: Relation) -> bool:
    """Whether a driver imposes one rate and nothing else."""
    return len(relation.turning) + len(relation.left) + len(relation.right) == 1
