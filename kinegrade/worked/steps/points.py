"""The velocity or acceleration of a point of a body whose motion is known: from its distance to a
fixed axis, or from its base point.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from typing import Literal, assert_never

from kinegrade.language.message import Message
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.relations import Chain, Term, add_vectors
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import (
    Level,
    Part,
    find_term_value,
    list_term_parts,
)
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.numbers import (
    bearing,
    double,
    length,
    write_absolute_value,
    write_angle,
    write_bracketed,
    write_number,
    write_short,
)
from kinegrade.worked.steps.deductions import UNITS
from kinegrade.worked.steps.findings import Fact, Findings, Piece, make_key, write_point_symbol
from kinegrade.worked.steps.known_vectors import find_positive_sense
from kinegrade.worked.steps.summands import (
    NUMBER,
    Summand,
    write_component,
    write_sum,
    write_sum_line,
)
from kinegrade.worked.words.senses import find_axis_sense, is_zero, write_beside_value
from kinegrade.worked.words.solution_case import LETTERS, Case

_Place = Literal["of", "at"]  # a point of the body that turns, or one at the same place
_Start = Literal["point", "base"]  # from a fixed axis, or from a moving base point


def find_vector(chain: Chain, motion: Motion, level: Level) -> Vector:
    """The vector of a chain."""
    return add_vectors(find_term_value(term, motion, level) for term in chain)


def find_point(
    chain: Chain, name: str, case: Case, level: Level, findings: Findings
) -> Iterator[Block]:
    """How the vector of a chain is found, if that has not been written yet; `name` is its
    symbol.
    """
    if make_key(chain, level) in findings.facts or not chain:
        return
    last, value = chain[-1], find_vector(chain, case.motion, level)
    if all(term.kind == "sliding" and term.frame == GROUND for term in chain):
        pieces = (Piece(name, find_positive_sense(last, case), value),) if len(chain) == 1 else ()
        fact = Fact(name, value, len(chain) > 1, pieces)
    elif len(chain) == 1 and level == "velocity":
        yield from _explain_single(last, name, case)
        fact = Fact(name, value, False, (Piece(name, _find_single_sense(last, value), value),))
    elif len(chain) == 1 and last.kind == "arc":
        fact = yield from _explain_circling(last, name, case)
    else:
        yield from _explain_sum(chain, name, case, level, findings)
        fact = Fact(name, value, True)
    findings.facts[make_key(chain, level)] = fact


def _find_single_sense(term: Term, value: Vector) -> Vector:
    """The direction in which the speed of a single term counts positive."""
    match term.kind:
        case "rotation":
            return value
        case "sliding" | "arc":
            return term.coefficient()
        case _:
            assert_never(term.kind)


def _explain_sum(
    chain: Chain, name: str, case: Case, level: Level, findings: Findings
) -> Iterator[Block]:
    """The components of a point's vector: its last term added to the terms before."""
    match chain[-1].kind:
        case "rotation":
            yield from _explain_carried(chain, name, case, level, findings)
        case "sliding" | "arc":
            yield from _explain_composed(chain, name, case, level, findings)
        case _:
            assert_never(chain[-1].kind)


def _explain_single(term: Term, name: str, case: Case) -> Iterator[Block]:
    """The velocity of a point that turns about a fixed axis; nothing for a guided point, whose
    speed has been given.
    """
    if term.kind != "rotation":
        return
    body = term.rate.body
    point, base = case.naming.point(term.point), case.naming.point(term.base)
    value = term.velocity(case.motion.rates)
    size = length(value, case.arithmetic)
    omega = case.naming.omega(body)
    bars = omega if double(case.motion.rates[term.rate]) >= 0 else write_absolute_value(omega)
    yield case.say(
        Message(
            f"solution.known-point-{_find_place(term, case)}",
            point=point,
            base=base,
            body=case.naming.body(body),
        )
    )
    yield Display(
        (
            (
                rf"{name} &= {base}{point}\cdot {bars} = "
                rf"{write_number(size, 'm/s')}{write_way(value, case)}"
            ),
        )
    )


def _find_place(term: Term, case: Case) -> _Place:
    """Whether a point is one of the body that turns, or is only at the same place."""
    name = term.rate.body
    points = next(body.points for body in case.motion.frames.mechanism.bodies if body.name == name)
    return "of" if term.point in points else "at"


def _explain_circling(term: Term, name: str, case: Case) -> Generator[Block, None, Fact]:
    """The acceleration of a point on a fixed circle: the normal part from its speed, the tangential
    part as given.
    """
    point, centre = case.naming.point(term.point), case.naming.point(term.base)
    yield case.say(Message("solution.known-circle", point=point, centre=centre))
    normal, tangential = (
        term.normal(case.motion.rates),
        term.coefficient() * case.motion.changes[term.rate],
    )
    speed = write_short(length(term.velocity(case.motion.rates), case.arithmetic))
    radius = length(term.vector, case.arithmetic)
    symbols = tuple(rf"{name}^{{\mathrm{{{part}}}}}" for part in "nt")
    yield Display(
        (
            rf"{symbols[0]} &= \frac{{v_{{{point}}}^{{2}}}}{{{centre}{point}}} = "
            rf"\frac{{{speed}^{{2}}}}{{{write_short(radius)}}} = "
            f"{write_number(length(normal, case.arithmetic), 'm/s^2')}",
        )
    )
    pieces = Piece(symbols[0], normal, normal), Piece(symbols[1], term.coefficient(), tangential)
    return Fact(name, normal + tangential, False, pieces)


def write_way(vector: Vector, case: Case) -> str:
    """The direction of a vector after its magnitude in an equation, "" for a zero vector."""
    if is_zero(vector):
        return ""
    sense = find_axis_sense(vector)
    return write_beside_value(sense, case) if sense else rf",\quad {write_angle(bearing(vector))}"


def _explain_carried(
    chain: Chain, name: str, case: Case, level: Level, findings: Findings
) -> Iterator[Block]:
    """The components of a point's vector from its base point: the base point's plus those of the
    rotation about it.
    """
    last, before = chain[-1], chain[:-1]
    base_name = write_point_symbol(last.base, level, case)
    yield from find_point(before, base_name, case, level, findings)
    point, base = case.naming.point(last.point), case.naming.point(last.base)
    start: _Start = "base" if before else "point"
    yield case.say(
        Message(
            f"solution.known-{start}-{_find_place(last, case)}",
            point=point,
            base=base,
            body=case.naming.body(last.rate.body),
        )
    )
    known = (base_name if before else "", find_vector(before, case.motion, level))
    yield Display(
        tuple(
            (
                f"{write_component(name, axis)} &= "
                f"{_write_carried_component(axis, known, last, case, level)}"
            )
            for axis in "xy"
        )
    )


def _write_carried_component(
    axis: str, start: tuple[str, Vector], term: Term, case: Case, level: Level
) -> str:
    """v_Ax - omega (y_P - y_A), or a_Ax - alpha (y_P - y_A) - omega^2 (x_P - x_A), with numbers and
    value.

    `start` is the vector of the base point with its symbol, "" where it is fixed. Terms of a
    rotation that is zero are left out.
    """
    base_name, base = start
    along = 0 if axis == "x" else 1
    summands = (
        [Summand("+", write_component(base_name, axis), write_short(base[along]))]
        if base_name
        else []
    )
    summands += _list_turning_summands(axis, term, case, level)
    added = find_term_value(term, case.motion, level)
    result = write_number(base[along] + added[along], UNITS[level, False])
    texts = (
        write_sum(summands, "symbol"),
        write_sum([one for one in summands if one.counts], "number"),
    )
    return " = ".join(
        [*(text for text in dict.fromkeys(texts) if not NUMBER.fullmatch(text)), result]
    )


def _list_turning_summands(axis: str, term: Term, case: Case, level: Level) -> Iterator[Summand]:
    """The terms that the rotation about a base point adds to a component; none where the rotation
    is zero.
    """
    along, across, other, sign = (0, 1, "y", "-") if axis == "x" else (1, 0, "x", "+")
    point, base = case.naming.point(term.point), case.naming.point(term.base)
    body = term.rate.body
    rate = case.motion.rates[term.rate]
    letters, value = case.naming.turning(body, level), case.rates(level)[term.rate]
    if double(value):
        yield Summand(
            sign,
            f"{letters}({other}_{{{point}}}-{other}_{{{base}}})",
            (
                rf"{write_bracketed(write_short(value))}\cdot "
                rf"{write_bracketed(write_short(term.vector[across]))}"
            ),
        )
    if level == "acceleration" and double(rate):
        yield Summand(
            "-",
            f"{case.naming.omega(body)}^{{2}}({axis}_{{{point}}}-{axis}_{{{base}}})",
            (
                rf"{write_bracketed(write_short(rate))}^{{2}}\cdot "
                rf"{write_bracketed(write_short(term.vector[along]))}"
            ),
        )


def _explain_composed(
    chain: Chain, name: str, case: Case, level: Level, findings: Findings
) -> Iterator[Block]:
    """The components of a point that moves within a moving body: transport, relative and Coriolis
    parts added.
    """
    last, before = chain[-1], chain[:-1]
    head = LETTERS[level]
    number = findings.numbers.get(last.rate, "")
    transport = rf"{head}_{{\mathrm{{e}}{number}}}"
    yield from find_point(before, transport, case, level, findings)
    yield case.say(
        Message(
            "solution.known-relative",
            point=case.naming.point(last.point),
            frame=case.naming.body(last.frame),
        )
    )
    parts = [
        (transport, find_vector(before, case.motion, level)),
        *(
            (write_part_symbol(part, head, number), part.value)
            for part in list_term_parts(last, case.motion, tuple(case.motion.rates), level)
        ),
    ]
    yield Display(tuple(write_sum_line(axis, name, parts, level) for axis in "xy"))


def write_part_symbol(part: Part, head: str, number: str = "") -> str:
    """The symbol of a relative or Coriolis part."""
    upper = rf"^{{\mathrm{{{part.part}}}}}" if part.part else ""
    match part.role:
        case "coriolis":
            lower = "C"
        case "relative" | "absolute" | "transport" | "rotation":
            lower = "r"
        case _:
            assert_never(part.role)
    return rf"{head}_{{\mathrm{{{lower}}}{number}}}{upper}"
