"""A deduction as equations: in symbols, with this paper's numbers, and with its results, exact and
as decimals.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level, Part
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.equation import (
    Equation,
    Link,
    equate,
    lead_to,
)
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import bearing, double, length
from kinegrade.worked.formulas.numbers import measure, state_number
from kinegrade.worked.senses import (
    find_axis_sense,
    state_rotation_sense,
    state_sense_along,
    state_way_round,
)
from kinegrade.worked.vectors.alignments import explain_alignments
from kinegrade.worked.vectors.angle_sums import explain_sums
from kinegrade.worked.vectors.arms import name_length
from kinegrade.worked.vectors.inclinations import Cosine, find_ends, introduce_angle
from kinegrade.worked.vectors.magnitudes import find_heading, find_path_ends
from kinegrade.worked.vectors.projection import Deduction, Projection
from kinegrade.worked.vectors.stage import (
    Stage,
    find_share_cosine,
    measure_along_direction,
)
from kinegrade.worked.vectors.vectors import UNITS, name_part, name_value

_RIGHT_ANGLE = 90.0
AXIS_NAMES = {0.0: Message("solution.projection-x"), 90.0: Message("solution.projection-y")}


def explain_deduction(
    stage: Stage, deduction: Deduction, solved: Collection[Rate]
) -> Iterator[Block]:
    """A deduction in words and equations; relations between rates have been written before."""
    case, single = stage.case, len(deduction.unknowns) == 1 and not deduction.scalars
    for projection in deduction.projections:
        yield from _introduce_angles(stage, projection)
        yield from explain_sums(_list_cosines(stage, projection), case)
        yield from explain_alignments(projection, case)
        yield case.say(_announce_axis(stage, projection))
        if single:
            yield show_solution(stage, projection, solved, deduction.unknowns[0])
        else:
            yield case.show(*_state_projection(stage, projection, solved))
    if not single:
        yield case.say(Message("solution.together"))
        results = (result for rate in deduction.unknowns for result in _state_results(stage, rate))
        yield case.show(*results)


def _list_cosines(stage: Stage, projection: Projection) -> Iterator[Cosine | None]:
    """The cosines of a projection, as far as their directions have names."""
    for share in projection.shares:
        if share.angle:
            yield find_share_cosine(projection, share, stage.case)


def _introduce_angles(stage: Stage, projection: Projection) -> Iterator[Block]:
    """The angles that a projection uses and that have not been found before."""
    for share in (*projection.left, *projection.right):
        if not share.angle or find_share_cosine(projection, share, stage.case) is None:
            continue
        for part in (projection.dropped, share.part):
            if part is not None:
                yield from introduce_angle(part, stage.case)


def _state_projection(
    stage: Stage, projection: Projection, solved: Collection[Rate]
) -> tuple[Equation, ...]:
    """A projection in symbols, and in numbers where that adds something."""
    symbols, numbers = stage.project(projection, None), stage.project(projection, solved)
    return (symbols,) if numbers == symbols else (symbols, numbers)


def show_solution(
    stage: Stage, projection: Projection, solved: Collection[Rate], rate: Rate
) -> Display:
    """A projection with one unknown, solved for it in symbols, then in numbers, and its result."""
    first, *others = _state_results(stage, rate)
    symbols, numbers = (stage.solve(projection, rate, rates) for rates in (None, solved))
    if symbols is None or numbers is None:
        return stage.case.show(*_state_projection(stage, projection, solved), first, *others)
    links = lead_to(first.left, (symbols, numbers), first.links)
    notation, stated = stage.case.notation, stage.project(projection, None)
    alone = first.left in (stated.left, stated.links[0].right)
    return Display(
        (
            *(() if alone else (stated.print_line(notation),)),
            *Equation(first.left, links, first.aside).break_lines(notation),
            *(other.print_line(notation) for other in others),
        )
    )


def _announce_axis(stage: Stage, projection: Projection) -> Message:
    """On which axis the equation is projected, and why."""
    case, part = stage.case, projection.dropped
    if part is None:
        axis = AXIS_NAMES.get(projection.axis) or _name_direction_of_part(projection, case)
        return Message("solution.project-along", axis=axis)
    dropped = case.text(name_part(projection.equation, part, case, bold=True))
    known = AXIS_NAMES.get(projection.axis) or _name_line(projection.axis, part, case)
    if known is None:
        way = _describe_normal(find_heading(part), projection.axis)
        return Message("solution.project-normal", dropped=dropped, way=way)
    return Message("solution.project-drop", axis=known, dropped=dropped)


def _describe_normal(positive: Vector, axis: float) -> Message:
    """Which of the two directions normal to a vector the axis has, from its positive direction."""
    turned = positive.turned()
    counter_clockwise = abs((bearing(turned) - axis + 180) % 360 - 180) < _RIGHT_ANGLE
    sense = find_axis_sense(turned if counter_clockwise else -turned)
    return sense or Message(f"solution.normal-{'left' if counter_clockwise else 'right'}")


def _name_direction_of_part(projection: Projection, case: Case) -> Message:
    """The direction of the part along the axis, which is the one that is sought, or its
    opposite.
    """
    along = next(share for share in projection.shares if not share.angle)
    vector = case.text(name_part(projection.equation, along.part, case, bold=True))
    if along.sign < 0:
        return Message("solution.projection-against", vector=vector)
    return Message("solution.projection-of", vector=vector)


def _name_line(axis: float, dropped: Part, case: Case) -> Message | None:
    """The axis as the direction from one point to another, to which a rotating part is normal; None
    for other parts.
    """
    ends = find_ends(dropped, case)
    if ends is None or dropped.term is None or dropped.term.kind == "sliding":
        return None
    start, end = (case.motion.points[point] for point in ends)
    turned = abs((bearing(end - start) - axis + 180) % 360 - 180)
    first, last = ends if turned < _RIGHT_ANGLE else (ends[1], ends[0])
    return Message(
        "solution.projection-line", start=case.naming.point(first), end=case.naming.point(last)
    )


def _state_results(stage: Stage, rate: Rate) -> Iterator[Equation]:
    """The value of a vector along its direction, and of the rotation it belongs to."""
    case, level = stage.case, stage.level
    found = stage.occurrences(rate)
    turning = rate.kind == "turning"
    if found and (len(found) == 1 or not turning):
        equation, part = found[0]
        symbol = name_value(equation, part, case)
        yield state_vector_value(symbol, part, case, level)
        if turning:
            yield state_rotation_result(rate, case, level, _divide_by_arm(symbol, part, stage))
    elif turning:
        yield state_rotation_result(rate, case, level)


def _divide_by_arm(symbol: Formula, part: Part, stage: Stage) -> tuple[Link, ...]:
    """A rotation as the speed over the arm, in symbols and, unless it is zero, in numbers."""
    ratio = symbol / name_length(part.base, part.point, stage.case)
    if part.term is None or not double(length(part.value, stage.case.arithmetic)):
        return equate(ratio)
    speed = measure_along_direction(part.term, stage.case, stage.level)
    arm = measure(length(part.term.vector, stage.case.arithmetic), "m")
    return equate(ratio, measure(speed, UNITS[stage.level, False]) / arm)


def state_rotation_result(
    rate: Rate, case: Case, level: Level, how: tuple[Link, ...] = ()
) -> Equation:
    """The value of an angular velocity or acceleration with its sense."""
    value = case.rates(level)[rate]
    links = (*how, *state_number(value, UNITS[level, True]))
    letters = case.naming.turning(rate.body, level)
    return Equation(letters, links, state_rotation_sense(value, case))


def state_vector_value(symbol: Formula, part: Part, case: Case, level: Level) -> Equation:
    """The algebraic value of an unknown vector along its positive direction, with its sense in
    words.
    """
    unit = UNITS[level, False]
    if part.term is None or part.coefficient is None:
        return Equation(symbol, state_number(length(part.value, case.arithmetic), unit))
    value = measure_along_direction(part.term, case, level)
    sense = _state_sense(double(value), part.coefficient, part, case)
    return Equation(symbol, state_number(value, unit), sense)


def _state_sense(value: float, positive: Vector, part: Part, case: Case) -> Row:
    """The direction beside the value of an unknown vector; of a clockwise rotation about what,
    where the vector is slanting.
    """
    if part.base and value < 0 and find_axis_sense(positive) is None:
        return state_way_round(part.base, value, case)
    return state_sense_along(value, positive, find_path_ends(part, case), case)
