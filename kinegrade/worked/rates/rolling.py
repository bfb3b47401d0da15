"""Bodies that roll without slipping."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import NoSlip
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations import Relation, Term
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import ZERO, add_terms
from kinegrade.worked.formulas.equation import Equation, equate
from kinegrade.worked.formulas.measures import double
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.rates.kinds import describe_track
from kinegrade.worked.rates.speeds import (
    Statement,
    find_rotation_value,
    find_term,
    name_relative_rotation,
    name_rotation,
    name_speed,
    state_radius,
)
from kinegrade.worked.senses import describe_direction
from kinegrade.worked.vectors.known_vectors import find_positive_sense, find_stated_sense
from kinegrade.worked.vectors.stage import measure_along_direction
from kinegrade.worked.vectors.vectors import UNITS


def state_rolling(roll: NoSlip, relation: Relation, case: Case, level: Level) -> Statement:
    """No slip: the centre's speed along the track is the radius times the relative rotation."""
    term = find_term(relation.turning[0][0], case)
    body, other = case.naming.body(roll.body), describe_track(roll, case)
    sentence = case.template.scheme.joints[roll.joint]
    radius = state_radius(sentence.circle, roll.circle.radius, case)
    rotation = name_relative_rotation(roll.body, roll.of, case, level)
    right = (radius * rotation).signed(_find_slip_sign(roll, relation, case))
    equation = Equation(name_speed(term, case, level), equate(right))
    title = Message("solution.title-roll", body=body, other=other)
    return Statement(title, _explain_rolling(roll, term, case, level), equation)


def _explain_rolling(roll: NoSlip, term: Term, case: Case, level: Level) -> Message:
    """Why the rotation of a rolling body and the motion of its centre are linked."""
    body, motion = case.naming.body(roll.body), _name_motion_along_path(roll, term, case, level)
    if roll.of != GROUND:
        other = describe_track(roll, case)
        relative = Message("solution.rotation-relative-to", body=body, other=other)
        return Message("solution.no-slip", motion=motion, rotation=relative)
    rotation = Message("solution.rotation-of", body=body)
    match level:
        case "velocity":
            return Message(
                "solution.no-slip-on-ground", body=body, motion=motion, rotation=rotation
            )
        case "acceleration":
            return Message("solution.no-slip", motion=motion, rotation=rotation)
        case _:
            assert_never(level)


def _name_motion_along_path(roll: NoSlip, term: Term, case: Case, level: Level) -> Message:
    """The motion of a rolling body's centre, with its positive sense where it moves in the plane of
    the page.
    """
    centre = case.naming.point(roll.circle.centre)
    if term.frame != GROUND:
        return Message("solution.motion-along-path", centre=centre)
    return Message(
        "solution.motion-along-path-positive",
        centre=centre,
        speed=case.text(name_speed(term, case, level)),
        way=_describe_positive_sense(term, case),
    )


def _describe_positive_sense(term: Term, case: Case) -> Message:
    """In which sense a guided point's speed counts positive."""
    match term.kind:
        case "arc":
            return Message("solution.around", centre=case.naming.point(term.base))
        case "sliding" | "rotation":
            return describe_direction(find_positive_sense(term, case), case)
        case _:
            assert_never(term.kind)


def _find_slip_sign(roll: NoSlip, relation: Relation, case: Case) -> int:
    """1 where the rotation has the sign of the centre's speed as stated, else -1."""
    turning = make_turning(roll.body)
    factor = double(next(factor for rate, factor in relation.turning if rate == turning))
    stated = find_stated_sense(find_term(relation.turning[0][0], case), case)
    return -1 if factor * stated > 0 else 1


def solve_rolling(
    relation: Relation, unknown: Rate, case: Case, level: Level
) -> Iterator[Equation]:
    """The relation of a rolling body solved for a rate, with numbers unless they are zero."""
    roll = relation.source.find_rolling() if relation.source else None
    if roll is None:
        return
    term = find_term(relation.turning[0][0], case)
    sign = _find_slip_sign(roll, relation, case)
    other = find_rotation_value(roll.of, case, level)
    unit = UNITS[level, True]
    radius, track = measure(roll.circle.radius, "m"), measure(other, unit)
    if unknown == term.rate:
        turned = measure(find_rotation_value(roll.body, case, level), unit)
        if turned == ZERO and not double(other):
            return
        rotation = turned - track if double(other) else turned
        right = radius.dot(rotation).signed(sign)
        yield Equation(name_speed(term, case, level), equate(right))
    elif unknown == make_turning(roll.body):
        stated = find_stated_sense(term, case) * sign
        speed = measure_along_direction(term, case, level) * stated
        known = measure(speed, UNITS[level, False])
        if known != ZERO:
            turned_by = (known.size / radius).signed(known.sign)
            right = add_terms((track, turned_by) if double(other) else (turned_by,))
            yield Equation(name_rotation(roll.body, case, level), equate(right))
