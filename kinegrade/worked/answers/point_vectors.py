"""The velocities and accelerations of points that an answer refers to, each found once."""

from __future__ import annotations

from collections.abc import Generator, Iterable, Iterator
from dataclasses import replace
from typing import TypeAlias

from kinegrade.expressions.tree import Expression, Name
from kinegrade.figure.vectors.mechanism import PointArrow
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.template.template import Ask
from kinegrade.worked.case import Case
from kinegrade.worked.coincident_points import index_owner
from kinegrade.worked.document import Block
from kinegrade.worked.findings import Fact
from kinegrade.worked.formulas.atoms import VectorSymbol
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.points import find_point
from kinegrade.worked.vectors.vectors import name_point_vector

Found: TypeAlias = Generator[Block, None, Fact]


def keep_fact(tree: Expression, found: Found, case: Case) -> Found:
    """The vector of an expression, with the blocks that show how it is found unless they have been
    written before.
    """
    answered = case.findings.answered
    if tree not in answered:
        answered[tree] = yield from found
    return answered[tree]


def explain_point_vector(point: str, body: str, level: Level, case: Case) -> Found:
    """The velocity or acceleration of a point of a body."""
    chain = case.motion.frames.chain(body, point)
    yield from find_point(chain, _name_vector(point, body, level, case), case, level)
    nothing = Fact(name_point_vector(point, level, case), Vector(0, 0), False)
    return case.findings.facts.get(make_key(chain, level), nothing)


def list_asked_velocities(asked: Iterable[Ask], case: Case) -> Iterator[PointArrow]:
    """The velocities of points that answers are about, as arrows that are sought."""
    for ask in asked:
        for call in find_motion_calls(ask.quantity):
            function = MOTION_FUNCTIONS[call.function]
            if (function.derivation, function.level) == ("point", "velocity"):
                point, *bodies = (one.name for one in call.arguments if isinstance(one, Name))
                body = bodies[0] if bodies else case.reader.owner(point, None)
                yield PointArrow(
                    case.text(_name_vector(point, body, "velocity", case)),
                    case.motion.points[point].map(float),
                    case.motion.velocity(point, body).map(float),
                    False,
                )


def _name_vector(point: str, body: str, level: Level, case: Case) -> VectorSymbol:
    """The symbol of a point's vector; with the body where the point belongs to several that move
    apart.
    """
    plain = name_point_vector(point, level, case)
    return replace(plain, lower=index_owner(plain.lower, point, body, case))
