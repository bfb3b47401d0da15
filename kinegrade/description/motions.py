"""How what is driven moves: in the words of the statement where it has words for it, else by the
rates in symbols and the sense in which they are positive.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal, assert_never

from kinegrade.description.subject import Subject
from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, find_names
from kinegrade.language.decimal_mark import write_decimals_of_prose
from kinegrade.language.message import Message, Text
from kinegrade.mechanics.drivers import Circulation, Component, Driver, Rotation
from kinegrade.mechanics.ground import GROUND
from kinegrade.problem.driven_words import describe_driven
from kinegrade.problem.given import list_givens
from kinegrade.problem.template.driven import Driven, DrivenPart, find_driven
from kinegrade.problem.template.sentences import DriverSentence
from kinegrade.worked.formulas.leaves import count_quarter_turns

_WAYS = (  # by quarter turns
    Message("statement.right"),
    Message("statement.up"),
    Message("statement.left"),
    Message("statement.down"),
)


def say_motions(subject: Subject) -> Iterator[Message]:
    """A sentence for each driver."""
    drivers = subject.case.solution.assembly.mechanism.drivers
    for driver, sentence in zip(drivers, subject.template.scheme.drivers, strict=True):
        said = find_said(driver, subject)
        if said is None:
            yield _say_rates(driver, sentence, subject)
        else:
            yield _say_in_words(driver, said, subject)


def find_said(driver: Driver, subject: Subject) -> Driven | None:
    """What statements can say of a driver; None where they have no words for it, or do not print
    its rate.
    """
    drawn = subject.drawn.template
    part, name = _name_driven(driver)
    driven = find_driven(drawn.scheme.drivers, drawn.parameters)[part].get(name)
    known = driven is not None and driven.velocity.given in subject.printed
    return driven if known else None


def _name_driven(driver: Driver) -> tuple[DrivenPart, str]:
    match driver:
        case Rotation(body=body):
            return "turning", body
        case Component(point=point) | Circulation(point=point):
            return "moving", point
        case _:
            assert_never(driver)


def _say_in_words(driver: Driver, driven: Driven, subject: Subject) -> Message:
    givens = list_givens(subject.drawn.template, subject.drawn.parameters)
    motion = describe_driven(driven, givens, changes=subject.changes)
    words = write_decimals_of_prose(subject.case.write(motion), subject.case.language)
    match driver:
        case Rotation(body=body, of=of):
            return _say_relatively(subject.body(body), words, of, subject)
        case Component(point=point, body=body, of=of):
            return _say_relatively(subject.place(point, body), words, of, subject)
        case Circulation(point=point, body=body, centre=centre):
            what = subject.place(point, body)
            letter = subject.instance.letter(centre)
            return Message("description.driven-circling", what=what, motion=words, centre=letter)
        case _:
            assert_never(driver)


def _say_relatively(what: Message, motion: str, of: str, subject: Subject) -> Message:
    """What moves, seen from another body unless that is the ground."""
    if of == GROUND:
        return Message("description.driven", what=what, motion=motion)
    return Message("description.driven-relative", what=what, motion=motion, of=subject.body(of))


def _say_rates(driver: Driver, sentence: DriverSentence, subject: Subject) -> Message:
    """A driver by its rates in symbols; that it is driven where no given says how fast."""
    if subject.printed.isdisjoint(find_names(sentence.velocity)):
        return Message("description.driven-unsaid", body=subject.body(sentence.body))
    match driver:
        case Rotation(body=body, of=of):
            names = {"body": subject.body(body), "of": subject.body(of)}
            rates = _name_rates("turning", sentence, subject)
            return Message("description.input-turning", **names, rates=rates)
        case Component(point=point, body=body, of=of):
            return Message(
                "description.input-moving",
                point=subject.place(point, body),
                of=subject.body(of),
                direction=_name_direction(sentence.along, subject),
                rates=_name_rates("moving", sentence, subject),
            )
        case Circulation(point=point, body=body, centre=centre):
            return Message(
                "description.input-circling",
                point=subject.place(point, body),
                centre=subject.instance.letter(centre),
                rates=_name_rates("moving", sentence, subject),
            )
        case _:
            assert_never(driver)


def _name_rates(
    path: Literal["turning", "moving"], sentence: DriverSentence, subject: Subject
) -> Message:
    velocity = subject.text(sentence.velocity)
    if not subject.changes:
        return Message(f"description.rates-{path}", velocity=velocity)
    change = subject.text(sentence.acceleration)
    return Message(f"description.changing-{path}", velocity=velocity, acceleration=change)


def _name_direction(along: Expression | None, subject: Subject) -> Text:
    """A direction in prose."""
    if along is None:
        return ""
    match along:
        case Call("direction", (Name(start), Name(end))):
            letter = subject.instance.letter
            return Message("description.way-points", start=letter(start), end=letter(end))
        case Number() | Name() | Operation() | Call():
            quarters = count_quarter_turns(along)
            if quarters is not None:
                return _WAYS[quarters]
            return Message("description.way-angle", angle=subject.text(along, degrees=True))
        case _:
            assert_never(along)
