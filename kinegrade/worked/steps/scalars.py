"""Steps that need no vectors: what is given, bodies that rotate together, rolling without slipping,
meshing gears.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, assert_never

from kinegrade.expressions.expression import Expression, Number
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import (
    EqualPitchSpeed,
    EqualRotation,
    GuidedPoint,
    Imposed,
    ImposedCircling,
    ImposedMotion,
    ImposedRotation,
    NoSlip,
    SharedPoint,
)
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.relations import Relation, Term
from kinegrade.mechanics.vector_equation import Level
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.expression import collect_symbols, write_latex
from kinegrade.worked.formulas.numbers import double, write_bracketed, write_number, write_short
from kinegrade.worked.steps.deductions import UNITS, measure_along_direction, write_rotation_result
from kinegrade.worked.steps.kinds import describe_track
from kinegrade.worked.steps.known_vectors import find_positive_sense, find_stated_sense
from kinegrade.worked.words.senses import (
    describe_direction,
    write_rotation_sense,
    write_sense_along,
)
from kinegrade.worked.words.solution_case import LETTERS, Case


@dataclass(frozen=True)
class Statement:
    """A relation between rates: its title, why it holds, and the relation in symbols as a line of a
    display.
    """

    title: Message
    reason: Message
    line: str


def state_relation(relation: Relation, case: Case, level: Level) -> Statement:
    """What a scalar relation says about velocities or about accelerations."""
    source = relation.source
    match source:
        case NoSlip():
            return _state_rolling(source, relation, case, level)
        case EqualPitchSpeed():
            return _state_meshing(source, case, level)
        case EqualRotation():
            return _state_equal_rotation(source, case, level)
        case ImposedRotation() | ImposedMotion() | ImposedCircling():
            return _state_imposed(source, relation, case, level)
        case SharedPoint() | GuidedPoint() | None:
            raise TypeError("a pin or a guide states no relation of rates alone")
        case _:
            assert_never(source)


def _state_equal_rotation(law: EqualRotation, case: Case, level: Level) -> Statement:
    """Two bodies that do not turn relative to each other."""
    body, other = case.naming.body(law.body), case.naming.body(law.of)
    reason = Message(f"solution.parallel-{level}", body=body, other=other)
    title = Message("solution.title-parallel", body=body, other=other)
    line = f"{write_rotation(law.body, case, level)} &= {write_rotation(law.of, case, level)}"
    return Statement(title, reason, line)


def explain_scalar_step(
    relation: Relation, unknown: Rate, case: Case, level: Level
) -> Iterator[Block]:
    """A step of one scalar relation: the relation and the rate it gives."""
    statement = state_relation(relation, case, level)
    yield case.say(statement.reason)
    result = _write_rate_result(unknown, case, level)
    worked = (statement.line, *_write_solved_relation(relation, unknown, case, level), result)
    match relation.source:
        case ImposedRotation() | ImposedMotion() | ImposedCircling():
            yield Display((statement.line,) if imposes_single_rate(relation) else worked)
        case EqualRotation():
            value = case.rates(level)[unknown]
            known = f"{write_number(value, UNITS[level, True])}{write_rotation_sense(value, case)}"
            yield Display((f"{statement.line} = {known}",))
        case NoSlip() | EqualPitchSpeed() | SharedPoint() | GuidedPoint() | None:
            yield Display(worked)
        case _:
            assert_never(relation.source)


def imposes_single_rate(relation: Relation) -> bool:
    """Whether a driver imposes one rate and nothing else."""
    return len(relation.turning) + len(relation.left) + len(relation.right) == 1


def _write_rate_result(rate: Rate, case: Case, level: Level) -> str:
    """The value of a rate: an angular velocity, or the speed that belongs to a guided point."""
    match rate.kind:
        case "turning":
            return write_rotation_result(rate, case, level, "")
        case "sliding" | "circling" | "free-x" | "free-y" | "added-x" | "added-y":
            return _write_speed_result(find_term(rate, case), case, level)
        case _:
            assert_never(rate.kind)


def _write_speed_result(term: Term, case: Case, level: Level) -> str:
    """The value of a guided point's speed with its sense."""
    value = measure_along_direction(term, case, level) * find_stated_sense(term, case)
    shown = f"{write_number(value, UNITS[level, False])}{_describe_speed_sense(value, term, case)}"
    return f"{write_speed(term, case, level)} &= {shown}"


def _describe_speed_sense(value: Any, term: Term, case: Case) -> str:
    """The sense of a guided point's speed: around its centre, or along its line."""
    match term.kind:
        case "arc":
            return write_rotation_sense(value, case)
        case "sliding" | "rotation":
            return write_sense_along(double(value), find_positive_sense(term, case), None, case)
        case _:
            assert_never(term.kind)


def find_term(rate: Rate, case: Case) -> Term:
    """The term of a guided point's rate."""
    frames = case.motion.frames
    chains = [chain for relation in frames.relations for chain in (relation.left, relation.right)]
    chains += [base.chain for base in frames.bases.values()]
    return next(term for chain in chains for term in chain if term.rate == rate)


def write_speed(term: Term, case: Case, level: Level) -> str:
    """The symbol of a guided point's algebraic speed, or of its change."""
    head = LETTERS[level]
    lower = r"\mathrm{r}" if term.frame != GROUND else case.naming.point(term.point)
    return f"{head}_{{{lower}}}" + (r"^{\mathrm{t}}" if head == "a" and term.kind == "arc" else "")


def write_rotation(body: str, case: Case, level: Level) -> str:
    """The symbol of a body's rotation; 0 for the ground."""
    if body == GROUND:
        return "0"
    return case.naming.turning(body, level)


def find_rotation_value(body: str, case: Case, level: Level) -> Any:
    """The value of a body's rotation; 0 for the ground."""
    rates = case.rates(level)
    return 0 if body == GROUND else rates[make_turning(body)]


def _write_relative_rotation(body: str, of: str, case: Case, level: Level) -> str:
    """The symbol of one body's rotation relative to another."""
    rotation = write_rotation(body, case, level)
    return rotation if of == GROUND else f"({rotation} - {write_rotation(of, case, level)})"


def _write_formula(tree: Expression, case: Case) -> str:
    """An expression of the template in symbols."""
    return write_latex(tree, collect_symbols(case.template))


def _state_rolling(roll: NoSlip, relation: Relation, case: Case, level: Level) -> Statement:
    """No slip: the centre's speed along the track is the radius times the relative rotation."""
    term = find_term(relation.turning[0][0], case)
    body, other = case.naming.body(roll.body), describe_track(roll, case)
    sign = "-" if _find_slip_sign(roll, relation, case) > 0 else ""
    line = (
        rf"{write_speed(term, case, level)} &= {sign}{_write_radius(roll, case)}\,"
        f"{_write_relative_rotation(roll.body, roll.of, case, level)}"
    )
    title = Message("solution.title-roll", body=body, other=other)
    return Statement(title, _explain_rolling(roll, term, case, level), line)


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
        speed=write_speed(term, case, level),
        way=_describe_positive_sense(term, case),
    )


def _describe_positive_sense(term: Term, case: Case) -> Message:
    """In which sense a guided point's speed counts positive."""
    match term.kind:
        case "arc":
            return Message("solution.around", centre=case.naming.point(term.base))
        case "sliding" | "rotation":
            return describe_direction(find_positive_sense(term, case))
        case _:
            assert_never(term.kind)


def _find_slip_sign(roll: NoSlip, relation: Relation, case: Case) -> float:
    """The sign of the rotation's coefficient when the centre's speed, as stated, has the
    coefficient one.
    """
    factor = double(
        next(factor for rate, factor in relation.turning if rate == make_turning(roll.body))
    )
    return factor * find_stated_sense(find_term(relation.turning[0][0], case), case)


def _write_radius(roll: NoSlip, case: Case) -> str:
    """The radius of the rolling circle in symbols."""
    sentence = case.template.scheme.joints[roll.joint]
    text = (
        _write_formula(sentence.circle.arguments[1], case)
        if sentence.circle
        else write_short(roll.circle.radius)
    )
    return f"({text})" if " + " in text or " - " in text else text


def _write_solved_relation(
    relation: Relation, unknown: Rate, case: Case, level: Level
) -> Iterator[str]:
    """The relation solved for a rate, with numbers unless they are zero."""
    roll = relation.source
    if not isinstance(roll, NoSlip):
        return
    term = find_term(relation.turning[0][0], case)
    sign = -1 if _find_slip_sign(roll, relation, case) > 0 else 1
    size = write_short(roll.circle.radius)
    other = find_rotation_value(roll.of, case, level)
    if unknown == term.rate:
        turned = write_short(find_rotation_value(roll.body, case, level))
        if turned == "0" and not double(other):
            return
        rotation = (
            write_bracketed(turned)
            if not double(other)
            else f"({turned} - {write_bracketed(write_short(other))})"
        )
        yield (
            rf"{write_speed(term, case, level)} &= "
            rf"{'-' if sign < 0 else ''}{size}\cdot {rotation}"
        )
    elif unknown == make_turning(roll.body):
        known = write_short(
            measure_along_direction(term, case, level) * (find_stated_sense(term, case) * sign)
        )
        fraction = rf"\frac{{{known.removeprefix('-')}}}{{{size}}}"
        parts = [write_short(other)] if double(other) else []
        parts += [("-" if known.startswith("-") else "+") + fraction] if known != "0" else []
        if parts and parts != [write_short(other)]:
            yield f"{write_rotation(roll.body, case, level)} &= {''.join(parts).removeprefix('+')}"


def _state_meshing(mesh: EqualPitchSpeed, case: Case, level: Level) -> Statement:
    """Equal pitch speeds relative to the carrier, of opposite senses for external gears."""
    body, other = case.naming.body(mesh.body), case.naming.body(mesh.of)
    sentence = case.template.scheme.joints[mesh.joint]
    radius_text = (
        _write_formula(sentence.circle.arguments[1], case)
        if sentence.circle
        else write_short(mesh.circle.radius)
    )
    others = (
        _write_formula(sentence.on.arguments[1], case)
        if sentence.on
        else write_short(mesh.on.radius)
    )
    sign = "" if mesh.inside else "-"
    line = (
        rf"{radius_text}\,{_write_relative_rotation(mesh.body, mesh.carrier, case, level)} &= "
        rf"{sign}{others}\,{_write_relative_rotation(mesh.of, mesh.carrier, case, level)}"
    )
    return Statement(
        Message("solution.title-mesh", body=body, other=other),
        Message("solution.mesh", carrier=case.naming.body(mesh.carrier)),
        line,
    )


def _state_imposed(law: Imposed, relation: Relation, case: Case, level: Level) -> Statement:
    """What a driver imposes."""
    value = _find_driven_value(relation, level)
    match law:
        case ImposedRotation(body=body, of=of):
            left = write_rotation(body, case, level)
            left += f" - {write_rotation(of, case, level)}" if of != GROUND else ""
            way = write_rotation_sense(value, case)
        case ImposedMotion(direction=along):
            left = _write_driven_speed(law, case, level)
            way = write_sense_along(double(value), along, None, case)
        case ImposedCircling():
            left = _write_driven_speed(law, case, level)
            way = write_rotation_sense(value, case)
        case _:
            assert_never(law)
    unit = UNITS[level, isinstance(law, ImposedRotation)]
    line = (
        f"{left} &= {_write_driver_expression(law, left, case, level)}"
        f"{write_number(value, unit)}{way}"
    )
    return Statement(Message("solution.title-given"), _state_given(law, case, level), line)


def _find_driven_value(relation: Relation, level: Level) -> Any:
    """The velocity or acceleration that a driver imposes."""
    match level:
        case "velocity":
            return relation.velocity
        case "acceleration":
            return relation.acceleration
        case _:
            assert_never(level)


def _write_driven_speed(law: ImposedMotion | ImposedCircling, case: Case, level: Level) -> str:
    """The symbol of what a driver imposes on a point."""
    head = LETTERS[level]
    relative = isinstance(law, ImposedMotion) and law.of != GROUND
    lower = r"\mathrm{r}" if relative else case.naming.point(law.point)
    return f"{head}_{{{lower}}}" + (
        r"^{\mathrm{t}}" if head == "a" and isinstance(law, ImposedCircling) else ""
    )


def _write_driver_expression(law: Imposed, name: str, case: Case, level: Level) -> str:
    """The template's expression for a driver's value, with an equals sign; "" for a number.

    Also "" where the paper's parameter has the same letters as the algebraic value, `name`.
    """
    sentence = case.template.scheme.drivers[law.driver]
    tree = {"velocity": sentence.velocity, "acceleration": sentence.acceleration}[level]
    text = _write_formula(tree, case)
    same = name.partition("^")[0] in text
    return "" if isinstance(tree, Number) or same else f"{text} = "


def _state_given(law: Imposed, case: Case, level: Level) -> Message:
    """What is given, in a sentence."""
    match law:
        case ImposedRotation():
            return _state_given_rotation(law, case, level)
        case ImposedMotion():
            return _state_given_component(law, case, level)
        case ImposedCircling():
            point, centre = case.naming.point(law.point), case.naming.point(law.centre)
            return Message(f"solution.given-circling-{level}", point=point, centre=centre)
        case _:
            assert_never(law)


def _state_given_rotation(law: ImposedRotation, case: Case, level: Level) -> Message:
    body = case.naming.body(law.body)
    if law.of == GROUND:
        return Message(f"solution.given-rotation-{level}", body=body)
    other = case.naming.body(law.of)
    return Message(f"solution.given-relative-rotation-{level}", body=body, other=other)


def _state_given_component(law: ImposedMotion, case: Case, level: Level) -> Message:
    point, way = case.naming.point(law.point), describe_direction(law.direction)
    if law.of == GROUND:
        return Message(f"solution.given-motion-{level}", point=point, way=way)
    other = case.naming.body(law.of)
    return Message(f"solution.given-relative-motion-{level}", point=point, way=way, other=other)
