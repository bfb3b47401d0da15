"""The points whose places a solution uses: those of its answers and of the steps that lead to them;
others serve only to draw the mechanism.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kinegrade.expressions.tree import Call, find_names
from kinegrade.mechanics.laws import find_rolling
from kinegrade.mechanics.plan import Step
from kinegrade.mechanics.relations.terms import Term
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.template.template import Ask
from kinegrade.worked.case import Case
from kinegrade.worked.contacts import turn_about_contact
from kinegrade.worked.formulas.leaves import count_quarter_turns
from kinegrade.worked.vectors.needed_rates import find_references


def find_used_points(case: Case, asked: Iterable[Ask], steps: Iterable[Step]) -> tuple[str, ...]:
    """The points that answers and steps refer to, in the template's order."""
    trees = [*case.template.scheme.lengths.values()]
    terms, turned = list[Term](), list[Term]()
    for ask in asked:
        trees.append(ask.quantity)
        for call in find_motion_calls(ask.quantity):
            found = tuple(_list_asked_terms(call, case))
            terms += found
            # An acceleration is never taken about the point of contact
            turned += found if MOTION_FUNCTIONS[call.function].level != "acceleration" else ()
    for step in steps:
        for index in step.relations:
            relation = case.motion.frames.relations[index]
            terms += (*relation.left, *relation.right)
            turned += (*relation.left, *relation.right)
    used = {name for tree in trees for name in find_names(tree)}
    used |= {name for term in terms for name in _list_points(term, case)}
    used |= {name for term in turned for name in _list_contacts(term, case)}
    return tuple(point for point in case.template.scheme.points if point in used)


def find_placed_points(case: Case, asked: Sequence[Ask]) -> tuple[str, ...]:
    """The points of the mechanism where any answers are about positions alone, with those that
    these refer to; not what only the figure marks. None without such answers.
    """
    if not asked:
        return ()
    placed = {point for body in case.template.scheme.bodies for point in body.points}
    placed |= {name for ask in asked for name in find_names(ask.quantity)}
    return tuple(point for point in case.template.scheme.points if point in placed)


def _list_asked_terms(call: Call, case: Case) -> Iterator[Term]:
    """The terms that make up the vectors to which a function of the motion refers."""
    for body, point in find_references(call, case.reader).points:
        yield from case.motion.frames.chain(body, point)


def _list_points(term: Term, case: Case) -> Iterator[str]:
    """The points of a term: that which moves, about which, and those that give its path."""
    yield from (term.point, term.base)
    sentence = case.joint(term)
    for shape in (sentence.on, sentence.circle) if sentence else ():
        if shape is not None and not _lies_along_axis(shape):
            yield from find_names(shape)


def _list_contacts(term: Term, case: Case) -> Iterator[str]:
    """The point of contact about which a point turns."""
    about_contact = turn_about_contact(term, case)
    if about_contact is not None and not _is_rolling_centre(term.point, case):
        yield about_contact.base


def _is_rolling_centre(point: str, case: Case) -> bool:
    """Whether a point is the centre of a rolling circle, whose velocity the track gives without
    the point of contact.
    """
    rolls = (find_rolling(relation.source) for relation in case.motion.frames.relations)
    return any(roll is not None and roll.circle.centre == point for roll in rolls)


def _lies_along_axis(shape: Call) -> bool:
    """Whether a shape is a line along an axis, which no point has to tell."""
    return shape.function == "line" and count_quarter_turns(shape.arguments[1]) is not None
