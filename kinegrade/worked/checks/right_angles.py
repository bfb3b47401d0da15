"""Checks of a point that slides along a line through the axis of its body: the velocity of the body
is normal to that relative to it, so that their squares add up to that of the point.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

from kinegrade.language.message import Message
from kinegrade.mechanics.relations import Chain, Term
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.checks.amounts import Amount, add_letters, add_numbers
from kinegrade.worked.checks.check import Check, compare
from kinegrade.worked.checks.sides import Side
from kinegrade.worked.formulas.atoms import AXES
from kinegrade.worked.formulas.measures import double, find_sign, length
from kinegrade.worked.formulas.numbers import measure
from kinegrade.worked.vectors.facts import make_key
from kinegrade.worked.vectors.magnitudes import find_heading
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.summands import PLACES
from kinegrade.worked.vectors.vectors import name_part, vanishes


def list_right_angle_checks(stage: Stage) -> Iterator[Check]:
    """The checks of the velocities of a step, the last equation first."""
    if stage.level == "velocity":
        for equation in reversed(stage.equations):
            for before in (equation.relation.left, equation.relation.right):
                for turn, slide in pairwise(before):
                    if len(before) == 2 and turns_slot(turn, slide):
                        yield from _check_squares(turn, slide, equation, stage.case)


def turns_slot(turn: Term, slide: Term) -> bool:
    """Whether a point slides along a line through the axis of the body that turns."""
    return is_own(turn, slide) and not double(turn.vector.cross(slide.vector))


def is_own(turn: Term, slide: Term) -> bool:
    """Whether a point slides along a line of the body that turns."""
    return turn.kind == "rotation" and slide.kind == "sliding" and slide.frame == turn.rate.body


def _check_squares(
    turn: Term, slide: Term, equation: VectorEquation, case: Case
) -> Iterator[Check]:
    parts = [part for part in equation.parts if part.term in (turn, slide)]
    whole = _find_whole((turn, slide), equation, case)
    spared = any(part.unknown and case.findings.spares(part.unknown, "velocity") for part in parts)
    if len(parts) != 2 or spared or any(map(vanishes, parts)) or not whole:
        return
    names = [case.text(name_part(equation, part, case, bold=True)) for part in parts]
    way = Message("solution.check-right-angle", first=names[0], second=names[1])
    squares = [_measure(part, equation, case).squared() for part in parts]
    value = sum(part.value.squared() for part in parts)
    left, right = (
        Side(add_numbers(side), value, add_letters(side))
        for side in (squares, [one.squared() for one in whole])
    )
    yield compare(way, left, right, "m^2/s^2")


def _measure(part: Part, equation: VectorEquation, case: Case) -> Amount:
    """The number of a vector, with its sign where it counts along a positive sense."""
    sense = find_sign(part.value.dot(find_heading(part)))
    number = measure(length(part.value, case.arithmetic) * sense, "m/s")
    return Amount(name_part(equation, part, case), number)


def _find_whole(chain: Chain, equation: VectorEquation, case: Case) -> list[Amount]:
    """The velocity of the point by its components, or by its magnitude; none where the page has
    neither.
    """
    sides = (equation.relation.left, equation.relation.right)
    other = next(tuple(side) for side in sides if tuple(side) != tuple(chain))
    for one in (tuple(chain), other):
        fact = case.findings.facts.get(make_key(one, "velocity"))
        if fact is not None and fact.by_components:
            return [
                Amount(replace(fact.symbol, axis=axis), measure(fact.value[PLACES[axis]], "m/s"))
                for axis in AXES
                if double(fact.value[PLACES[axis]])
            ]
    parts = [part for part in equation.parts if part.term in other or part.together == other]
    seen = [part for part in parts if not vanishes(part)]
    return [_measure(seen[0], equation, case)] if len(seen) == 1 else []
