"""What a driver imposes on a point, in letters and words: of a point of a moving frame its relative
motion, of one that is driven along both axes a component.
"""

from __future__ import annotations

from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import ImposedComponent, ImposedMotion
from kinegrade.mechanics.relations.relation import Relation
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import VectorSymbol
from kinegrade.worked.senses import (
    describe_direction,
    find_axis_sense,
    say_beside,
    state_sense_along,
)
from kinegrade.worked.unlettered import find_translating_body
from kinegrade.worked.vectors.known_vectors import find_given_sign
from kinegrade.worked.vectors.relatives import find_relative, index_relative
from kinegrade.worked.vectors.summands import name_component
from kinegrade.worked.vectors.table.tracks import orient_track
from kinegrade.worked.vectors.vectors import name_by_role, name_point_vector


def name_driven(law: ImposedMotion, relation: Relation, case: Case, level: Level) -> VectorSymbol:
    """The letter of a driven motion: v_r, or v_A."""
    if law.of != GROUND:
        return name_by_role("r", level, _index_track(relation, case))
    return name_point_vector(law.point, level, case)


def name_driven_component(law: ImposedComponent, case: Case, level: Level) -> VectorSymbol:
    """The letter of a driven component, v_{A,x}."""
    return name_component(name_point_vector(law.point, level, case), law.axis)


def _index_track(relation: Relation, case: Case) -> Row:
    """What tells a relative motion from others of the problem."""
    tracks = [term for term in relation.left if term.kind == "sliding"]
    return index_relative(find_relative(tracks[-1]), case) if tracks else ()


def state_driven_way(law: ImposedMotion, value: float, case: Case) -> Row:
    """The direction of a driven motion beside its value; of one in a moving frame, where it is not
    the positive one.
    """
    ends = _find_track(law, case)
    if ends is not None or law.of != GROUND or value == 0:
        return state_sense_along(value, law.direction, ends, case)
    return _say_way(law.direction, value, case)


def state_component_way(law: ImposedComponent, value: float, case: Case) -> Row:
    """The direction of a driven component beside its value."""
    if value == 0:
        return state_sense_along(value, law.direction, None, case)
    return _say_way(law.direction, value, case)


def _say_way(direction: Vector, value: float, case: Case) -> Row:
    """A direction, or the opposite one of a negative value."""
    return say_beside(describe_direction(direction if value > 0 else -direction, case), case)


def _find_track(law: ImposedMotion, case: Case) -> tuple[str, str] | None:
    """The points that give the line of a driven motion, in its positive sense; None where no two
    points do.
    """
    for relation in case.motion.frames.relations:
        for term in (*relation.left, *relation.right):
            if _is_track(term, law):
                return orient_track(term, law.direction, case)
    return None


def _is_track(term: Term, law: ImposedMotion) -> bool:
    return (term.kind, term.point, term.frame) == ("sliding", law.point, law.of)


def say_driven(
    law: ImposedMotion, relation: Relation, case: Case, level: Level, *, against: bool
) -> Message:
    """That a motion is given; `against` where an acceleration counts positive in the sense in which
    the velocity counts negative.
    """
    point, carrier = case.naming.point(law.point), find_translating_body(law.point, case)
    if against:
        sign = find_given_sign(law, relation, case, level)
        sense = find_axis_sense(law.direction if sign > 0 else -law.direction)
        sense = sense or Message("solution.way-against-velocity")
        if carrier is not None:
            body = case.naming.body(carrier)
            return Message("solution.counter-translation", body=body, way=sense)
        return Message("solution.counter-motion", point=point, way=sense)
    if law.of == GROUND and carrier is not None:
        body = case.naming.body(carrier)
        return Message(f"solution.given-translation-{level}", body=body)
    if law.of != GROUND:
        other, way = case.naming.body(law.of), _describe_positive_way(law, case)
        return Message(f"solution.given-relative-motion-{level}", point=point, way=way, other=other)
    return Message(f"solution.given-motion-{level}", point=point)


def say_driven_component(law: ImposedComponent, case: Case, level: Level) -> Message:
    """That a component of a motion is given; the whole one where the body translates."""
    carrier = find_translating_body(law.point, case)
    if carrier is not None:
        return Message(f"solution.given-translation-{level}", body=case.naming.body(carrier))
    point = case.naming.point(law.point)
    return Message(f"solution.given-component-{level}", axis=law.axis, point=point)


def _describe_positive_way(law: ImposedMotion, case: Case) -> Message:
    """The positive direction of a relative motion: along an axis, from point to point, or by its
    angle.
    """
    ends, sense = _find_track(law, case), find_axis_sense(law.direction)
    if sense is None and ends is not None:
        start, end = map(case.naming.point, ends)
        return Message("solution.way-from-to", start=start, end=end)
    return describe_direction(law.direction, case)
