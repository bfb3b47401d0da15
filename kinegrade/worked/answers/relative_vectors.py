"""Relative, Coriolis, normal and tangential vectors that an answer refers to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain
from typing import Literal

from kinegrade.expressions.tree import Call
from kinegrade.language.message import Message, Text
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector import Vector, add_vectors
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.answers.point_vectors import Found, explain_point_vector, keep_fact
from kinegrade.worked.case import Case
from kinegrade.worked.coincident_points import prime_letter
from kinegrade.worked.document import Block
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import AXES, OTHER, TWO, VectorSymbol, add_terms
from kinegrade.worked.formulas.equation import Equation, Link, equate
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, length
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.rates.speeds import find_rotation_value, name_rotation
from kinegrade.worked.senses import state_way
from kinegrade.worked.vectors.arms import introduce_lengths, name_length
from kinegrade.worked.vectors.by_components import state_size
from kinegrade.worked.vectors.components import add_components
from kinegrade.worked.vectors.coriolis import Turned, explain_directions
from kinegrade.worked.vectors.relative_parts import list_relative_parts
from kinegrade.worked.vectors.relatives import Relative, find_relative, index_relative
from kinegrade.worked.vectors.summands import PLACES, name_component
from kinegrade.worked.vectors.vectors import name_by_role, name_coriolis


def explain_relative(motion: Relative, level: Level, case: Case) -> Found:
    """The relative velocity or acceleration: along its track, or else what remains of the absolute
    vector without the transport one.
    """
    term = _find_track(motion, case)
    name = name_by_role("r", level, index_relative(motion, case))
    if term is None:
        return (yield from _explain_rest(motion, name, level, case))
    if level == "velocity" or term.kind == "sliding":
        value = term.coefficient() * case.rates(level)[term.rate]
        return Fact(name, value, False, (Piece(name, term.coefficient(), value, term),))
    coriolis = name_coriolis(index_relative(motion, case))
    parts = [part for part in list_relative_parts(term, case, level) if part.symbol != coriolis]
    pieces = tuple(piece for part in parts for piece in part.pieces)
    return Fact(name, add_vectors(part.value for part in parts), False, pieces)


def _find_track(motion: Relative, case: Case) -> Term | None:
    """The term of a point that is guided in the frame, None where no joint guides it."""
    relations = case.motion.frames.relations
    for term in chain.from_iterable((*one.left, *one.right) for one in relations):
        if term.rate.is_guided and find_relative(term) == motion:
            return term
    return None


def _explain_rest(motion: Relative, name: VectorSymbol, level: Level, case: Case) -> Found:
    """v_r = v_a - v_e, a_r = a_a - a_e - a_Cor, by components."""
    absolute = yield from explain_point_vector(motion.point, motion.body, level, case)
    transport = yield from explain_point_vector(motion.point, motion.frame, level, case)
    parts = [absolute, transport]
    if level == "acceleration":
        coriolis = yield from explain_coriolis(motion, case)
        yield from _explain_components(coriolis, motion, case)
        parts.append(coriolis)
    difference = _state_difference(name, parts)
    yield case.say(_say_whose(motion, absolute, difference, level, case))
    yield case.show(*(add_components(axis, name, parts, case, "-") for axis in AXES))
    return Fact(name, absolute.value - add_vectors(part.value for part in parts[1:]), True)


def _say_whose(
    motion: Relative, absolute: Fact, difference: Equation, level: Level, case: Case
) -> Message:
    """Which point has the relative vector: that of the body, where the letter is another one's."""
    named: dict[str, Text] = {
        "point": case.naming.point(motion.point),
        "frame": case.naming.body(motion.frame),
        "difference": case.tell(difference),
    }
    if absolute.symbol.lower == case.naming.letter(motion.point).row:
        return Message(f"solution.relative-of-{level}", **named)
    return Message(f"solution.relative-at-{level}", body=case.naming.body(motion.body), **named)


def _explain_components(coriolis: Fact, motion: Relative, case: Case) -> Iterator[Block]:
    """The components of a Coriolis acceleration that is slanting: those of the relative velocity,
    turned with the frame.
    """
    relative = case.findings.answered[Call("relative_velocity", motion.names)]
    if not relative.by_components or not all(map(double, coriolis.value)):
        return
    turning = name_rotation(motion.frame, case, "velocity")
    omega = measure(find_rotation_value(motion.frame, case, "velocity"), "rad/s")
    equations = list[Equation]()
    for axis, sign in zip(AXES, (-1, 1), strict=True):
        across = OTHER[axis]
        speed = measure(relative.value[PLACES[across]], "m/s")
        symbols = (TWO * turning * name_component(relative.symbol, across)).signed(sign)
        size = state_number(coriolis.value[PLACES[axis]], "m/s^2")
        links = (*equate(symbols, TWO.dot(omega).dot(speed).signed(sign)), *size)
        equations.append(Equation(name_component(coriolis.symbol, axis), links))
    yield case.show(*equations)


def _state_difference(name: VectorSymbol, parts: Sequence[Fact]) -> Equation:
    """A relative vector as what remains of the absolute one, in vectors."""
    absolute, *others = (replace(part.symbol, bold=True) for part in parts)
    rest = add_terms((absolute, *(-symbol for symbol in others)))
    return Equation(replace(name, bold=True), equate(rest))


def explain_coriolis(motion: Relative, case: Case) -> Found:
    """The Coriolis acceleration, twice the frame's angular velocity times the relative speed."""
    tree = Call("coriolis", motion.names)
    return (yield from keep_fact(tree, _find_coriolis(motion, case), case))


def _find_coriolis(motion: Relative, case: Case) -> Found:
    asked = Call("relative_velocity", motion.names)
    found = explain_relative(motion, "velocity", case)
    relative = yield from keep_fact(asked, found, case)
    along = [axis for axis in AXES if double(relative.value[PLACES[axis]])]
    speed: Formula = relative.symbol
    if relative.by_components and len(along) == 1:
        speed = name_component(relative.symbol, along[0])
    elif relative.by_components and relative.symbol not in case.findings.sized:
        case.findings.sized.add(relative.symbol)
        yield case.show(state_size(relative, case))
    value = case.motion.coriolis(*motion)
    name = name_coriolis(index_relative(motion, case))
    omega = abs(name_rotation(motion.frame, case, "velocity"))
    links: tuple[Link, ...] = ()
    if any(map(double, value)):
        links = equate(TWO * omega * abs(speed))
        bold = replace(name, bold=True), replace(relative.symbol, bold=True)
        yield from explain_directions((Turned(*bold, motion.frame),), case)
        turned = abs(measure(find_rotation_value(motion.frame, case, "velocity"), "rad/s"))
        size = measure(length(relative.value, case.arithmetic), "m/s")
        links += equate(TWO.dot(turned).dot(size))
    links += state_number(length(value, case.arithmetic), "m/s^2")
    yield case.show(Equation(name, links, state_way(value, case)))
    return Fact(name, value, False, (Piece(name, value, value, _find_track(motion, case)),))


def explain_normal(point: str, base: str, body: str, case: Case) -> Found:
    """The normal acceleration of a point about a base point of its body."""
    omega = case.motion.omega(body)
    value = _find_arm(point, base, case) * -(omega * omega)
    factors = case.naming.omega(body) ** TWO, measure(omega, "rad/s") ** TWO
    return (yield from _explain_about_base("n", (point, base), value, factors, case))


def explain_tangential(point: str, base: str, body: str, case: Case) -> Found:
    """The tangential acceleration of a point about a base point of its body, as a step has found it
    if one has.
    """
    alpha = case.motion.alpha(body)
    value = _find_arm(point, base, case).turned() * alpha
    told = _find_told((point, base), value, case)
    if told is not None:
        return told
    factors = abs(case.naming.alpha(body)), abs(measure(alpha, "rad/s^2"))
    return (yield from _explain_about_base("t", (point, base), value, factors, case))


def _find_told(ends: tuple[str, str], value: Vector, case: Case) -> Fact | None:
    """A tangential part that has the letters of both points, primed or not, on the left of an
    equation.
    """
    point, base = ends
    centre = case.naming.letter(base).row
    for letters in (case.naming.letter(point).row, prime_letter(point, case).row):
        name = VectorSymbol("a", (*letters, *centre), "t")
        told = (one for one in case.findings.printed if one.left.looks_like(name) and one.links)
        equation = next(told, None)
        if equation is not None:
            positive = value * equation.links[-1].right.sign
            return Fact(name, value, False, (Piece(name, positive, value),))
    return None


def _find_arm(point: str, base: str, case: Case) -> Vector:
    points = case.motion.points
    return points[point] - points[base]


def _explain_about_base(
    part: Literal["n", "t"],
    ends: tuple[str, str],
    value: Vector,
    factors: tuple[Formula, Formula],
    case: Case,
) -> Found:
    """A part of an acceleration: the arm times a factor, in symbols and in numbers."""
    point, base = map(case.naming.letter, ends)
    name = VectorSymbol("a", (*point.row, *base.row), part)
    size = measure(length(_find_arm(*ends, case), case.arithmetic), "m")
    symbols, numbers = factors
    # The arm of a point begins at its base point
    start, end = reversed(ends)
    formulas = equate(name_length(start, end, case).dot(symbols), size.dot(numbers))
    result = state_number(length(value, case.arithmetic), "m/s^2")
    left = abs(name) if case.findings.is_negative(name) else name
    found = Equation(left, (*formulas, *result))
    yield case.show(*introduce_lengths(((start, end),), case), found)
    return Fact(name, value, False)
