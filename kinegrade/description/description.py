"""The figure of a question in words: a short text in place of the image, and a long one from which
the problem can be set up without it.

Both follow from the template and the instance, as the figure does: what the bodies are and how they
are joined, where the points are, what moves and how. Their numbers are those that the statement
prints; what is asked they never tell.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import reduce

from kinegrade.description.bodies import say_bodies
from kinegrade.description.joints import say_joints
from kinegrade.description.lengths import say_givens
from kinegrade.description.motions import say_motions
from kinegrade.description.positions import say_positions
from kinegrade.description.said import Description
from kinegrade.description.short import describe_briefly
from kinegrade.description.subject import Subject, make_subject
from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.problem.solution import Solution


def describe(
    solution: Solution, language: Language, asks: Collection[str] | None = None
) -> Description | None:
    """The figure of a question that asks for these, or for all asks; None where it has no figure.

    Lengths in the units of the givens, angles counter-clockwise from the x axis.
    """
    if not solution.template.scheme.has_mechanism:
        return None
    named = solution.template.asks if asks is None else asks
    subject = make_subject(solution, tuple(named), language)
    with subject.case.arithmetic.context():
        paragraphs = [tuple(part) for part in _list_paragraphs(subject)]
    short = describe_briefly(solution.template, solution.parameters, language)
    return Description(short, tuple(subject.case.say(_join(part)) for part in paragraphs if part))


def _join(sentences: tuple[Message, ...]) -> Message:
    """Sentences one after the other."""
    return reduce(
        lambda first, one: Message("solution.sentences", first=first, next=one), sentences
    )


def _list_paragraphs(subject: Subject) -> Iterator[Iterator[Message]]:
    yield say_givens(subject)
    yield say_bodies(subject)
    yield say_joints(subject)
    yield say_positions(subject)
    yield say_motions(subject)
