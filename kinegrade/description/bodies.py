"""What the bodies are: their points, and the forms that the figure gives them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import assert_never

from kinegrade.description.subject import Subject
from kinegrade.language.message import Message
from kinegrade.mechanics.mechanism import Body
from kinegrade.problem.template.hints import Shape


def say_bodies(subject: Subject) -> Iterator[Message]:
    """The points of each body with its form, then the circles that no joint knows of, about points
    that the description names.
    """
    for body in subject.template.scheme.bodies:
        shape = subject.marks.shapes.get(body.name)
        form = None if shape is None else _say_form(body, shape, subject)
        if form is not None:
            yield form
        told = subject.keep_told(body)
        if told and not body.particle and shape != "bent":
            points = subject.list_points(told)
            yield Message("description.points", body=subject.body(body.name), points=points)
    for circle in subject.marks.circles:
        if {circle.centre, circle.through} <= subject.points & subject.named_points:
            yield Message(
                "description.rim",
                body=subject.body(circle.body),
                centre=subject.instance.letter(circle.centre),
                point=subject.instance.letter(circle.through),
            )


def _say_form(body: Body, shape: Shape, subject: Subject) -> Message | None:
    """What a body looks like; None where the name says it, or only its drawing
    is concerned."""
    name = subject.body(body.name)
    match shape:
        case "bent":
            points = subject.list_points(subject.keep_told(body))
            return Message("description.bent", body=name, points=points)
        case "disc":
            centre = subject.instance.letter(body.points[0])
            return Message("description.disc", body=name, centre=centre)
        case "gear" | "rope" | "load" | "geneva":
            return Message(f"description.form-{shape}", body=name)
        case "bar" | "bare" | "through" | "cylinder" | "arc" | "cam" | "jaw" | "rack":
            return None
        case _:
            assert_never(shape)
