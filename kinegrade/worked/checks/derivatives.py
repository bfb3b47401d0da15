"""Checks of a point of constant velocity that slides along a line through the axis of a body that
turns: what moves it across that line is its velocity's component there at any time, so that the
derivatives of both agree.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinegrade.language.message import Message
from kinegrade.mechanics.rates import make_turning
from kinegrade.mechanics.relations import Term
from kinegrade.mechanics.vector_equation import VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.checks.check import Check, Side, compare
from kinegrade.worked.formulas.atoms import ZERO, add_terms
from kinegrade.worked.formulas.measures import bearing, double, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.formulas.symbols import join_letters
from kinegrade.worked.vectors.arms import name_length
from kinegrade.worked.vectors.inclinations import find_cosine, name_along, name_axis
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import vanishes

_KINDS = ["sliding", "rotation"]


def list_derivative_checks(stages: Iterable[Stage]) -> Iterator[Check]:
    """The checks of all compositions of that kind, of accelerations."""
    for stage in stages:
        for equation in stage.equations if stage.level == "acceleration" else ():
            yield from _check_composition(equation, stage.case)


def _check_composition(equation: VectorEquation, case: Case) -> Iterator[Check]:
    absolute = [one for one in equation.parts if one.role == "absolute"]
    slides, turns = (_list_terms(equation, role) for role in ("relative", "transport"))
    if all(map(vanishes, absolute)) and [one.kind for one in slides + turns] == _KINDS:
        (slide,), (turn,) = slides, turns
        if not double(turn.vector.cross(slide.coefficient())):
            yield from _check_slide(slide, turn, case)


def _list_terms(equation: VectorEquation, role: str) -> list[Term]:
    """The terms of the parts in one role, each once."""
    parts = (one.term for one in equation.parts if one.role == role)
    return list({term.rate: term for term in parts if term is not None}.values())


def _check_slide(slide: Term, turn: Term, case: Case) -> Iterator[Check]:
    """r alpha + v_r omega = -omega v_a cos(v_a, r), with r from the axis to the point."""
    rates, changes, body = case.motion.rates, case.motion.changes, make_turning(turn.rate.body)
    omega, alpha, arm = rates[body], changes[body], length(turn.vector, case.arithmetic)
    velocity = turn.velocity(rates) + slide.velocity(rates)
    ends = (turn.base, turn.point)
    heading = name_axis(bearing(velocity))
    along = name_along(bearing(turn.vector), ends, case)
    cosine = find_cosine(heading, along) if heading and along else None
    if cosine is None or not double(omega):
        return
    away = slide.velocity(rates).dot(turn.vector) / arm
    turned, slid = measure(abs(omega), "rad/s"), measure(abs(away), "m/s")
    speed = length(velocity, case.arithmetic)
    left = add_terms(
        one
        for one in (
            measure(arm, "m").dot(measure(alpha, "rad/s^2")),
            slid.dot(turned).signed(1 if double(omega * away) > 0 else -1),
        )
        if one != ZERO
    )
    right = turned.dot(measure(speed, "m/s")).dot(cosine.state(True))
    sense = -1 if double(omega * velocity.dot(turn.vector)) > 0 else 1
    way = Message(
        "solution.check-derivative",
        speed=case.text(name_length(*ends, case).dot(case.naming.omega(turn.rate.body))),
        point=case.naming.point(slide.point),
        line=case.text(join_letters(map(case.naming.letter, ends))),
    )
    total = double(arm * alpha + omega * away)
    yield compare(way, Side(left, total), Side(right.signed(sense), total), "m/s^2")
