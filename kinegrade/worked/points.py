"""The velocity or acceleration of a point of a body whose motion is known: from its distance to a
fixed axis, or from its base point.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from dataclasses import dataclass, field
from typing import assert_never

from kinegrade.expression import Expression
from kinegrade.mechanics.joints import GROUND
from kinegrade.mechanics.motion import Motion
from kinegrade.mechanics.relations import Chain, Term, total
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import (
    Level,
    Part,
    VectorEquation,
    is_whole,
    term_parts,
    term_value,
)
from kinegrade.worked.deductions import UNITS
from kinegrade.worked.document import Block, Display, Prose
from kinegrade.worked.known_vectors import positive_sense, ways
from kinegrade.worked.numbers import (
    absolute_value,
    angle_text,
    bearing,
    bracketed,
    double,
    length,
    short,
    stated,
)
from kinegrade.worked.phrases import phrase
from kinegrade.worked.senses import direction_words
from kinegrade.worked.solution_case import LETTERS, Case
from kinegrade.worked.summands import NUMBER, Summand, component, sum_line, sum_of
from kinegrade.worked.vectors import letter, letters_of, number_of, subscript

Key = tuple[Level, tuple[tuple[str, str, str], ...]]


@dataclass(frozen=True)
class Piece:
    """A vector given by one number: its symbol, the direction in which that counts positive, its
    value.
    """

    symbol: str
    positive: Vector
    value: Vector


@dataclass(frozen=True)
class Fact:
    """A vector that the solution has found: its symbol, and whether by components or by magnitudes
    and directions.

    `pieces` are the vectors whose sum it is where it is given by magnitudes: itself, or a normal
    and a tangential part.
    """

    symbol: str
    value: Vector
    by_components: bool
    pieces: tuple[Piece, ...] = ()

    @property
    def parts(self) -> tuple[Piece, ...]:
        """The pieces, or the vector itself where it is given by magnitude and direction."""
        return self.pieces or (Piece(self.symbol, self.value, self.value),)


@dataclass
class Findings:
    """What a solution has found so far, filled in as it is written.

    `numbers` are those of the relative motions where a step has several, by the rate of each;
    `sized` the symbols of vectors known by components whose magnitude has been given as well.
    """

    facts: dict[Key, Fact] = field(default_factory=dict)
    answered: dict[Expression, Fact] = field(default_factory=dict)
    poles: dict[str, str] = field(default_factory=dict)
    numbers: dict[str, str] = field(default_factory=dict)
    sized: set[str] = field(default_factory=set)

    def note(self, equation: VectorEquation, case: Case) -> None:
        """Record what a solved equation gives: the vector that stands alone on one side, which is
        that of both chains, the vectors of points fixed only to the ground, and the numbers of its
        relative motions.
        """
        for part in equation.compositions:
            if part.term is not None:
                self.numbers[part.term.rate] = number_of(equation, part)
        relation = equation.relation
        whole = next((side for side in (equation.left, equation.right) if is_whole(side)), None)
        if whole is not None:
            for chain in (relation.left, relation.right):
                self.facts.setdefault(key_of(chain, equation.level), fact_of(whole, equation, case))
        for chain in (relation.left, relation.right):
            first = [
                part
                for part in equation.parts
                if chain and part.term is chain[0] and part.role in ("absolute", "transport")
            ]
            if first:
                self.facts.setdefault(
                    key_of(chain[:1], equation.level), fact_of(first, equation, case)
                )


def fact_of(parts: Sequence[Part], equation: VectorEquation, case: Case) -> Fact:
    """The vector of one point whose parts stand in an equation."""
    pieces = tuple(
        Piece(letters_of(equation, part, case), sense_of(part, case), part.value) for part in parts
    )
    transport = f"{letter(equation)}_{{{subscript(equation, parts[0], case)}}}"
    first = parts[0]
    match first.role:
        case "transport":
            symbol = transport
        case "absolute" | "relative" | "rotation" | "coriolis":
            symbol = point_symbol(first.point, equation.level, case)
        case _:
            assert_never(first.role)
    return Fact(symbol, total(part.value for part in parts), False, pieces)


def sense_of(part: Part, case: Case) -> Vector:
    """The direction in which a part's number counts positive: the part's direction where only its
    magnitude is given.
    """
    if part.coefficient is not None:
        return part.coefficient
    if part.term is None or part.part == "n" or part.term.kind == "rotation":
        return part.value
    return positive_sense(part.term, case)


def key_of(chain: Chain, level: Level) -> Key:
    """The key under which a chain's vector is kept."""
    return level, ways(chain)


def point_symbol(point: str, level: Level, case: Case) -> str:
    """The symbol of a point's velocity or acceleration."""
    return f"{LETTERS[level]}_{{{case.naming.point(point)}}}"


def vector_of(chain: Chain, motion: Motion, level: Level) -> Vector:
    """The vector of a chain."""
    return total(term_value(term, motion, level) for term in chain)


def find_point(
    chain: Chain, name: str, case: Case, level: Level, findings: Findings
) -> Iterator[Block]:
    """How the vector of a chain is found, if that has not been written yet; `name` is its
    symbol.
    """
    if key_of(chain, level) in findings.facts or not chain:
        return
    last, value = chain[-1], vector_of(chain, case.motion, level)
    if all(term.kind == "sliding" and term.frame == GROUND for term in chain):
        pieces = (Piece(name, positive_sense(last, case), value),) if len(chain) == 1 else ()
        fact = Fact(name, value, len(chain) > 1, pieces)
    elif len(chain) == 1 and level == "velocity":
        yield from single(last, name, case)
        fact = Fact(name, value, False, (Piece(name, way_of_one(last, value), value),))
    elif len(chain) == 1 and last.kind == "arc":
        fact = yield from circling(last, name, case)
    else:
        yield from added_up(chain, name, case, level, findings)
        fact = Fact(name, value, True)
    findings.facts[key_of(chain, level)] = fact


def way_of_one(term: Term, value: Vector) -> Vector:
    """The direction in which the speed of a single term counts positive."""
    match term.kind:
        case "rotation":
            return value
        case "sliding" | "arc":
            return term.coefficient()
        case _:
            assert_never(term.kind)


def added_up(
    chain: Chain, name: str, case: Case, level: Level, findings: Findings
) -> Iterator[Block]:
    """The components of a point's vector: its last term added to the terms before."""
    match chain[-1].kind:
        case "rotation":
            yield from carried(chain, name, case, level, findings)
        case "sliding" | "arc":
            yield from composed(chain, name, case, level, findings)
        case _:
            assert_never(chain[-1].kind)


def single(term: Term, name: str, case: Case) -> Iterator[Block]:
    """The velocity of a point that turns about a fixed axis; nothing for a guided point, whose
    speed has been given.
    """
    if term.kind != "rotation":
        return
    body = term.rate.removeprefix("omega ")
    point, base = case.naming.point(term.point), case.naming.point(term.base)
    value = term.velocity(case.motion.rates)
    size = length(value, case.arithmetic)
    omega = case.naming.omega(body)
    bars = omega if double(case.motion.rates[term.rate]) >= 0 else absolute_value(omega)
    yield Prose(
        phrase(
            f"known_point{place_of(term, case)}",
            case.language,
            point=point,
            base=base,
            body=case.naming.body(body),
        )
    )
    yield Display(
        (rf"{name} &= {base}{point}\cdot {bars} = {stated(size, 'm/s')}{way(value, case)}",)
    )


def place_of(term: Term, case: Case) -> str:
    """Which sentence fits a point: another one where the point only coincides with one of the body
    that turns.
    """
    name = term.rate.removeprefix("omega ")
    points = next(body.points for body in case.motion.frames.mechanism.bodies if body.name == name)
    return "" if term.point in points else "_at"


def circling(term: Term, name: str, case: Case) -> Generator[Block, None, Fact]:
    """The acceleration of a point on a fixed circle: the normal part from its speed, the tangential
    part as given.
    """
    point, centre = case.naming.point(term.point), case.naming.point(term.base)
    yield Prose(phrase("known_circle", case.language, point=point, centre=centre))
    normal, tangential = (
        term.normal(case.motion.rates),
        term.coefficient() * case.motion.changes[term.rate],
    )
    speed = short(length(term.velocity(case.motion.rates), case.arithmetic))
    radius = length(term.vector, case.arithmetic)
    symbols = tuple(rf"{name}^{{\mathrm{{{part}}}}}" for part in "nt")
    yield Display(
        (
            rf"{symbols[0]} &= \frac{{v_{{{point}}}^{{2}}}}{{{centre}{point}}} = "
            rf"\frac{{{speed}^{{2}}}}{{{short(radius)}}} = "
            f"{stated(length(normal, case.arithmetic), 'm/s^2')}",
        )
    )
    pieces = Piece(symbols[0], normal, normal), Piece(symbols[1], term.coefficient(), tangential)
    return Fact(name, normal + tangential, False, pieces)


def way(vector: Vector, case: Case) -> str:
    """The direction of a vector after its magnitude in an equation, "" for a zero vector."""
    words = direction_words(vector, case)
    if "$" in words or not words:
        return rf",\quad {angle_text(bearing(vector))}" if words else ""
    return rf"\quad\text{{({words})}}"


def carried(
    chain: Chain, name: str, case: Case, level: Level, findings: Findings
) -> Iterator[Block]:
    """The components of a point's vector from its base point: the base point's plus those of the
    rotation about it.
    """
    last, before = chain[-1], chain[:-1]
    base_name = point_symbol(last.base, level, case)
    yield from find_point(before, base_name, case, level, findings)
    point, base = case.naming.point(last.point), case.naming.point(last.base)
    key = f"{'known_base' if before else 'known_point'}{place_of(last, case)}"
    yield Prose(
        phrase(
            key,
            case.language,
            point=point,
            base=base,
            body=case.naming.body(last.rate.removeprefix("omega ")),
        )
    )
    start = (base_name if before else "", vector_of(before, case.motion, level))
    yield Display(
        tuple(
            f"{component(name, axis)} &= {carried_component(axis, start, last, case, level)}"
            for axis in "xy"
        )
    )


def carried_component(
    axis: str, start: tuple[str, Vector], term: Term, case: Case, level: Level
) -> str:
    """v_Ax - omega (y_P - y_A), or a_Ax - alpha (y_P - y_A) - omega^2 (x_P - x_A), with numbers and
    value.

    `start` is the vector of the base point with its symbol, "" where it is fixed. Terms of a
    rotation that is zero are left out.
    """
    base_name, base = start
    along = 0 if axis == "x" else 1
    summands = [Summand("+", component(base_name, axis), short(base[along]))] if base_name else []
    summands += turning_summands(axis, term, case, level)
    added = term_value(term, case.motion, level)
    result = stated(base[along] + added[along], UNITS[level, False])
    texts = (sum_of(summands, "symbol"), sum_of([one for one in summands if one.counts], "number"))
    return " = ".join(
        [*(text for text in dict.fromkeys(texts) if not NUMBER.fullmatch(text)), result]
    )


def turning_summands(axis: str, term: Term, case: Case, level: Level) -> Iterator[Summand]:
    """The terms that the rotation about a base point adds to a component; none where the rotation
    is zero.
    """
    along, across, other, sign = (0, 1, "y", "-") if axis == "x" else (1, 0, "x", "+")
    point, base = case.naming.point(term.point), case.naming.point(term.base)
    body = term.rate.removeprefix("omega ")
    rate = case.motion.rates[term.rate]
    letters, value = case.naming.turning(body, level), case.rates(level)[term.rate]
    if double(value):
        yield Summand(
            sign,
            f"{letters}({other}_{{{point}}}-{other}_{{{base}}})",
            rf"{bracketed(short(value))}\cdot {bracketed(short(term.vector[across]))}",
        )
    if level == "acceleration" and double(rate):
        yield Summand(
            "-",
            f"{case.naming.omega(body)}^{{2}}({axis}_{{{point}}}-{axis}_{{{base}}})",
            rf"{bracketed(short(rate))}^{{2}}\cdot {bracketed(short(term.vector[along]))}",
        )


def composed(
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
    yield Prose(
        phrase(
            "known_relative",
            case.language,
            point=case.naming.point(last.point),
            frame=case.naming.body(last.frame),
        )
    )
    parts = [
        (transport, vector_of(before, case.motion, level)),
        *(
            (part_symbol(part, head, number), part.value)
            for part in term_parts(last, case.motion, tuple(case.motion.rates), level)
        ),
    ]
    yield Display(tuple(sum_line(axis, name, parts, level) for axis in "xy"))


def part_symbol(part: Part, head: str, number: str = "") -> str:
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
