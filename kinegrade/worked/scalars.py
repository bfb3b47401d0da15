"""Steps that need no vectors: what is given, bodies that rotate together, rolling without slipping,
meshing gears.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, assert_never

from kinegrade.expression import Expression, Number
from kinegrade.mechanics.drivers import Circulation, Component, Driver, Rotation
from kinegrade.mechanics.joints import (
    GROUND,
    Arc,
    Contact,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.mechanics.relations import Relation, Term, omega_of
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.deductions import UNITS, along_direction, rotation_result
from kinegrade.worked.document import Block, Display, Prose
from kinegrade.worked.formula_text import latex_of, symbols_of
from kinegrade.worked.kinds import track_of
from kinegrade.worked.known_vectors import positive_sense, sense_told
from kinegrade.worked.numbers import bracketed, double, short, stated
from kinegrade.worked.phrases import phrase
from kinegrade.worked.senses import direction_words, sense_along, sense_of_rotation
from kinegrade.worked.solution_case import LETTERS, Case


@dataclass(frozen=True)
class Statement:
    """A relation between rates: its title, why it holds, and the relation in symbols as a line of a
    display.
    """

    title: str
    reason: str
    line: str


def stated_relation(relation: Relation, case: Case, level: Level) -> Statement:
    """What a scalar relation says about velocities or about accelerations."""
    source = relation.source
    match source:
        case Roll():
            return rolling(source, relation, case, level)
        case Mesh():
            return meshing(source, case, level)
        case Parallel() | Sleeve():
            return turning_alike(source, case, level)
        case Rotation() | Component() | Circulation():
            return imposed(source, case, level)
        case Pin() | Slide() | Arc() | Contact() | None:
            raise TypeError("a pin or a guide states no relation of rates alone")
        case _:
            assert_never(source)


def turning_alike(joint: Parallel | Sleeve, case: Case, level: Level) -> Statement:
    """Two bodies that do not turn relative to each other."""
    body, other = case.naming.body(joint.body), body_or_ground(joint.of, case)
    reason = phrase(f"parallel_{level}", case.language, body=body, other=other)
    title = phrase("title_parallel", case.language, body=body, other=other)
    line = f"{turning(joint.body, case, level)} &= {turning(joint.of, case, level)}"
    return Statement(title, reason, line)


def scalar_step(relation: Relation, unknown: str, case: Case, level: Level) -> Iterator[Block]:
    """A step of one scalar relation: the relation and the rate it gives."""
    statement = stated_relation(relation, case, level)
    yield Prose(statement.reason)
    result = rate_result(unknown, case, level)
    worked = (statement.line, *solved_for(relation, unknown, case, level), result)
    match relation.source:
        case Rotation() | Component() | Circulation():
            yield Display((statement.line,) if single_rate(relation) else worked)
        case Parallel() | Sleeve():
            value = case.rates(level)[unknown]
            known = f"{stated(value, UNITS[level, True])}{sense_of_rotation(value, case)}"
            yield Display((f"{statement.line} = {known}",))
        case Roll() | Mesh() | Pin() | Slide() | Arc() | Contact() | None:
            yield Display(worked)
        case _:
            assert_never(relation.source)


def single_rate(relation: Relation) -> bool:
    """Whether a driver imposes one rate and nothing else."""
    return len(relation.turning) + len(relation.left) + len(relation.right) == 1


def rate_result(rate: str, case: Case, level: Level) -> str:
    """The value of a rate: an angular velocity, or the speed that belongs to a guided point."""
    if rate.startswith("omega "):
        return rotation_result(rate, case, level, "")
    term = term_of(rate, case)
    value = along_direction(term, case, level) * sense_told(term, case)
    shown = f"{stated(value, UNITS[level, False])}{way_of_speed(value, term, case)}"
    return f"{speed(term, case, level)} &= {shown}"


def way_of_speed(value: Any, term: Term, case: Case) -> str:
    """The sense of a guided point's speed: around its centre, or along its line."""
    match term.kind:
        case "arc":
            return sense_of_rotation(value, case)
        case "sliding" | "rotation":
            return sense_along(double(value), positive_sense(term, case), None, case)
        case _:
            assert_never(term.kind)


def term_of(rate: str, case: Case) -> Term:
    """The term of a guided point's rate."""
    frames = case.motion.frames
    chains = [chain for relation in frames.relations for chain in (relation.left, relation.right)]
    chains += [base.chain for base in frames.bases.values()]
    return next(term for chain in chains for term in chain if term.rate == rate)


def speed(term: Term, case: Case, level: Level) -> str:
    """The symbol of a guided point's algebraic speed, or of its change."""
    head = LETTERS[level]
    lower = r"\mathrm{r}" if term.frame != GROUND else case.naming.point(term.point)
    return f"{head}_{{{lower}}}" + (r"^{\mathrm{t}}" if head == "a" and term.kind == "arc" else "")


def turning(body: str, case: Case, level: Level) -> str:
    """The symbol of a body's rotation; 0 for the ground."""
    if body == GROUND:
        return "0"
    return case.naming.turning(body, level)


def turning_value(body: str, case: Case, level: Level) -> Any:
    """The value of a body's rotation; 0 for the ground."""
    rates = case.rates(level)
    return 0 if body == GROUND else rates[omega_of(body)]


def relative_turning(body: str, of: str, case: Case, level: Level) -> str:
    """The symbol of one body's rotation relative to another."""
    rotation = turning(body, case, level)
    return rotation if of == GROUND else f"({rotation} - {turning(of, case, level)})"


def body_or_ground(body: str, case: Case) -> str:
    """A body in prose."""
    return phrase("ground", case.language) if body == GROUND else case.naming.body(body)


def formula(tree: Expression, case: Case) -> str:
    """An expression of the template in symbols."""
    return latex_of(tree, symbols_of(case.template))


def rolling(roll: Roll, relation: Relation, case: Case, level: Level) -> Statement:
    """No slip: the centre's speed along the track is the radius times the relative rotation."""
    term = term_of(relation.turning[0][0], case)
    body, other = case.naming.body(roll.body), track_of(roll, case)
    kind = "rotation_absolute" if roll.of == GROUND else "rotation_relative"
    relative = phrase(kind, case.language, body=body, other=other)
    reason = phrase(
        "no_slip",
        case.language,
        centre=case.naming.point(roll.circle.centre),
        relative=relative,
        positive=positive_words(term, case, level),
    ).replace("  ", " ")
    if roll.of == GROUND and level == "velocity":
        reason = f"{phrase('pole_contact', case.language, body=body)} {reason}"
    sign = "-" if slip_sign(roll, relation, case) > 0 else ""
    line = (
        rf"{speed(term, case, level)} &= {sign}{radius(roll, case)}\,"
        f"{relative_turning(roll.body, roll.of, case, level)}"
    )
    return Statement(phrase("title_roll", case.language, body=body, other=other), reason, line)


def positive_words(term: Term, case: Case, level: Level) -> str:
    """In which sense a guided point's speed counts positive, in brackets; "" where its direction
    has no short name.
    """
    if term.frame != GROUND:
        return ""
    centre = case.naming.point(term.base)
    match term.kind:
        case "arc":
            words = phrase("around", case.language, centre=centre)
        case "sliding" | "rotation":
            words = direction_words(positive_sense(term, case), case)
        case _:
            assert_never(term.kind)
    return phrase("positive_way", case.language, symbol=f"${speed(term, case, level)}$", way=words)


def slip_sign(roll: Roll, relation: Relation, case: Case) -> float:
    """The sign of the rotation's coefficient when the centre's speed, as stated, has the
    coefficient one.
    """
    factor = double(
        next(factor for rate, factor in relation.turning if rate == omega_of(roll.body))
    )
    return factor * sense_told(term_of(relation.turning[0][0], case), case)


def radius(roll: Roll, case: Case) -> str:
    """The radius of the rolling circle in symbols."""
    sentence = case.template.scheme.joints[case.motion.frames.mechanism.joints.index(roll)]
    text = (
        formula(sentence.circle.arguments[1], case)
        if sentence.circle
        else short(roll.circle.radius)
    )
    return f"({text})" if " + " in text or " - " in text else text


def solved_for(relation: Relation, unknown: str, case: Case, level: Level) -> Iterator[str]:
    """The relation solved for a rate, with numbers unless they are zero."""
    roll = relation.source
    if not isinstance(roll, Roll):
        return
    term = term_of(relation.turning[0][0], case)
    sign = -1 if slip_sign(roll, relation, case) > 0 else 1
    size = short(roll.circle.radius)
    other = turning_value(roll.of, case, level)
    if unknown == term.rate:
        turned = short(turning_value(roll.body, case, level))
        if turned == "0" and not double(other):
            return
        rotation = (
            bracketed(turned) if not double(other) else f"({turned} - {bracketed(short(other))})"
        )
        yield rf"{speed(term, case, level)} &= {'-' if sign < 0 else ''}{size}\cdot {rotation}"
    elif unknown == omega_of(roll.body):
        known = short(along_direction(term, case, level) * (sense_told(term, case) * sign))
        fraction = rf"\frac{{{known.removeprefix('-')}}}{{{size}}}"
        parts = [short(other)] if double(other) else []
        parts += [("-" if known.startswith("-") else "+") + fraction] if known != "0" else []
        if parts and parts != [short(other)]:
            yield f"{turning(roll.body, case, level)} &= {''.join(parts).removeprefix('+')}"


def meshing(mesh: Mesh, case: Case, level: Level) -> Statement:
    """Equal pitch speeds relative to the carrier, of opposite senses for external gears."""
    body, other = case.naming.body(mesh.body), case.naming.body(mesh.of)
    sentence = case.template.scheme.joints[case.motion.frames.mechanism.joints.index(mesh)]
    radius_text = (
        formula(sentence.circle.arguments[1], case)
        if sentence.circle
        else short(mesh.circle.radius)
    )
    others = formula(sentence.on.arguments[1], case) if sentence.on else short(mesh.on.radius)
    sign = "" if mesh.inside else "-"
    line = (
        rf"{radius_text}\,{relative_turning(mesh.body, mesh.carrier, case, level)} &= "
        rf"{sign}{others}\,{relative_turning(mesh.of, mesh.carrier, case, level)}"
    )
    return Statement(
        phrase("title_mesh", case.language, body=body, other=other),
        phrase("mesh", case.language, carrier=body_or_ground(mesh.carrier, case)),
        line,
    )


def imposed(driver: Driver, case: Case, level: Level) -> Statement:
    """What a driver imposes."""
    value = driven_value(driver, level)
    match driver:
        case Rotation(of=of):
            left = turning(driver.body, case, level)
            left += f" - {turning(of, case, level)}" if of != GROUND else ""
            way = sense_of_rotation(value, case)
        case Component(direction=along):
            left = driven_speed(driver, case, level)
            way = sense_along(double(value), along, None, case)
        case Circulation():
            left = driven_speed(driver, case, level)
            way = sense_of_rotation(value, case)
        case _:
            assert_never(driver)
    unit = UNITS[level, isinstance(driver, Rotation)]
    line = f"{left} &= {expressed(driver, left, case, level)}{stated(value, unit)}{way}"
    return Statement(phrase("title_given", case.language), given(driver, case, level), line)


def driven_value(driver: Driver, level: Level) -> Any:
    """The velocity or acceleration that a driver imposes."""
    match level:
        case "velocity":
            return driver.velocity
        case "acceleration":
            return driver.acceleration
        case _:
            assert_never(level)


def driven_speed(driver: Component | Circulation, case: Case, level: Level) -> str:
    """The symbol of what a driver imposes on a point."""
    head = LETTERS[level]
    relative = isinstance(driver, Component) and driver.of != GROUND
    lower = r"\mathrm{r}" if relative else case.naming.point(driver.point)
    return f"{head}_{{{lower}}}" + (
        r"^{\mathrm{t}}" if head == "a" and isinstance(driver, Circulation) else ""
    )


def expressed(driver: Driver, name: str, case: Case, level: Level) -> str:
    """The template's expression for a driver's value, with an equals sign; "" for a number.

    Also "" where the paper's parameter has the same letters as the algebraic value, `name`.
    """
    sentence = case.template.scheme.drivers[case.motion.frames.mechanism.drivers.index(driver)]
    tree = {"velocity": sentence.velocity, "acceleration": sentence.acceleration}[level]
    text = formula(tree, case)
    same = name.partition("^")[0] in text
    return "" if isinstance(tree, Number) or same else f"{text} = "


def given(driver: Driver, case: Case, level: Level) -> str:
    """What is given, in a sentence."""
    body = case.naming.body(driver.body)
    match driver:
        case Rotation(of=of):
            key = "given_rotation" if of == GROUND else "given_rotation_of"
            parts = {"other": body_or_ground(of, case)}
        case Component(of=of):
            key = "given_point" if of == GROUND else "given_point_of"
            point, way = case.naming.point(driver.point), direction_words(driver.direction, case)
            parts = {"other": body_or_ground(of, case), "point": point, "way": way}
        case Circulation():
            key = "given_circle"
            point, centre = case.naming.point(driver.point), case.naming.point(driver.centre)
            parts = {"point": point, "centre": centre}
        case _:
            assert_never(driver)
    return phrase(f"{key}_{level}", case.language, body=body, **parts)
