"""A deduction as equations: in symbols, with this paper's numbers, and with its results, exact and
as decimals.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from kinegrade.language.message import Message
from kinegrade.mechanics.rates import Rate
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Part
from kinegrade.worked.case import Case
from kinegrade.worked.deductions.elimination import find_elimination
from kinegrade.worked.deductions.insertions import Insertion
from kinegrade.worked.deductions.projected_angles import AXIS_NAMES, explain_angles
from kinegrade.worked.document import Block, Display
from kinegrade.worked.formulas.equation import Equation, lead_to
from kinegrade.worked.formulas.measures import bearing
from kinegrade.worked.senses import find_axis_sense
from kinegrade.worked.vectors.alignments import explain_alignments
from kinegrade.worked.vectors.projection import Deduction, Projection
from kinegrade.worked.vectors.results import state_results, state_rotation_result
from kinegrade.worked.vectors.slopes.directions import find_ends
from kinegrade.worked.vectors.slopes.introduced_angles import introduce_angle
from kinegrade.worked.vectors.stage import Stage, find_share_cosine
from kinegrade.worked.vectors.table.tracks import find_heading
from kinegrade.worked.vectors.vectors import name_part

_RIGHT_ANGLE = 90.0
_MOST_SOLVED = 6  # vectors of a projection that is solved in symbols


def explain_deduction(
    stage: Stage,
    deduction: Deduction,
    solved: Collection[Rate],
    later: Sequence[Deduction] = (),
) -> Iterator[Block]:
    """A deduction in words and equations, before `later` ones of the step; relations between rates
    have been written before.
    """
    case, single = stage.case, len(deduction.unknowns) == 1 and not deduction.scalars
    found = None if single else find_elimination(deduction, stage.level, case)
    for projection in deduction.projections:
        yield from introduce_angles(stage, projection)
        yield from explain_alignments(projection, case)
        yield case.say(_announce(stage, projection))
        if single:
            yield show_solution(stage, projection, solved, deduction.unknowns[0])
        elif found and not found.by:
            yield case.show(stage.project(projection, None))
        else:
            yield case.show(*_state_projection(stage, projection, solved))
    if found:
        yield from _explain_insertion(Insertion(stage, found), deduction, solved, later)
    elif not single:
        yield case.say(Message("solution.together"))
        results = (result for rate in deduction.unknowns for result in state_results(stage, rate))
        yield case.show(*results)


def _explain_insertion(
    insertion: Insertion,
    deduction: Deduction,
    solved: Collection[Rate],
    later: Sequence[Deduction],
) -> Iterator[Block]:
    """What is inserted into what, then the values: first of the unknown that is kept."""
    stage, kept = insertion.stage, insertion.elimination.kept
    yield from insertion.explain(solved)
    results = list[Equation]()
    rest = (one for one in deduction.unknowns if one != kept and stage.uses(one, later))
    for rate in (kept, *rest):
        found = list(state_results(stage, rate))
        if rate == kept and kept.kind == "turning":
            results.append(state_rotation_result(rate, stage.case, stage.level))
            found = found[:-1]
        if found:
            first, *others = found
            links = lead_to(first.left, insertion.find_working(rate), first.links)
            results += (replace(first, links=links), *others)
    yield stage.case.show(*results)


def introduce_angles(stage: Stage, projection: Projection) -> Iterator[Block]:
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
    """A projection with one unknown, solved for it in symbols, then in numbers, and its result. One
    of many vectors is solved in numbers alone: over several lines, symbols would be read twice.
    """
    first, *others = state_results(stage, rate)
    symbols, numbers = (stage.solve(projection, rate, rates) for rates in (None, solved))
    if symbols is None or numbers is None:
        return stage.case.show(*_state_projection(stage, projection, solved), first, *others)
    case, stated = stage.case, stage.project(projection, None)
    alone = first.left in (stated.left, stated.links[0].right)
    told = alone or len(projection.shares) <= _MOST_SOLVED
    links = lead_to(first.left, (symbols, numbers) if told else (numbers,), first.links)
    return Display(
        (
            *(() if alone else (case.print_line(stated),)),
            *case.break_lines(Equation(first.left, links, first.aside)),
            *(case.print_line(other) for other in others),
        )
    )


def _announce(stage: Stage, projection: Projection) -> Message:
    """The angles that a projection needs, then its axis."""
    said = _announce_axis(stage, projection)
    for angles in reversed(tuple(explain_angles(stage, projection))):
        said = Message("solution.sentences", first=angles, next=said)
    return said


def _announce_axis(stage: Stage, projection: Projection) -> Message:
    """On which axis the equation is projected, and why."""
    case, part = stage.case, projection.dropped
    if part is None:
        axis = AXIS_NAMES.get(projection.axis) or _name_direction_of_part(projection, case)
        return Message("solution.project-along", axis=axis)
    dropped = case.text(name_part(projection.equation, part, case, bold=True))
    known = AXIS_NAMES.get(projection.axis) or name_line(projection.axis, part, case)
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


def name_line(axis: float, dropped: Part, case: Case) -> Message | None:
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
