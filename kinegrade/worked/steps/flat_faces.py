"""Circles that touch a flat face: their centres are the moving points.

Where of a profile only the curvature at the contact is known, the circle is that of curvature. It
takes the place of the profile to second order: at this instant, for velocities and accelerations.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language.message import Message
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block


def explain_flat_face(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """Why the centre of a circle is the moving point where the circle touches a flat face."""
    if equation.level != "velocity":
        return
    for relative in equation.compositions:
        sentence = case.joint(relative.term) if relative.term else None
        if sentence and sentence.stated.TOUCHES and relative.part == "":
            point, frame = case.naming.point(relative.point), case.naming.body(relative.frame)
            curved = find_curved_body(relative, case)
            if curved is None:
                yield case.say(Message("solution.contact-face", point=point, frame=frame))
            else:
                body = case.naming.body(curved)
                said = Message("solution.contact-curved", point=point, frame=frame, body=body)
                yield case.say(said)


def find_curved_body(relative: Part, case: Case) -> str | None:
    """The body that touches the frame, where of its profile only the curvature there is known."""
    sentence = case.joint(relative.term) if relative.term else None
    if sentence is None or not sentence.stated.TOUCHES:
        return None
    figure = case.template.figure
    traced = {circle.body for circle in figure.circles}
    known = figure.shapes.get(sentence.body) != "cam" or sentence.body in traced
    return None if known else sentence.body
