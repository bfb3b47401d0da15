"""Circles that touch a flat face: their centres are the moving points.

Where of a profile only the curvature at the contact is known, the circle is that of curvature. It
takes the place of the profile to second order: at this instant, for velocities and accelerations.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language.message import Message
from kinegrade.mechanics.shapes import Profile
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block


def explain_flat_face(equation: VectorEquation, case: Case) -> Iterator[Block]:
    """Why the centre of a circle is the moving point where the circle touches a flat face."""
    if equation.level != "velocity":
        return
    for relative in equation.compositions:
        profile = find_profile(relative, case)
        if profile is None or relative.part:
            continue
        point, frame = case.naming.point(relative.point), case.naming.body(relative.frame)
        if profile.of_curvature:
            body = case.naming.body(profile.body)
            yield case.say(Message("solution.contact-curved", point=point, frame=frame, body=body))
        else:
            yield case.say(Message("solution.contact-face", point=point, frame=frame))


def find_profile(relative: Part, case: Case) -> Profile | None:
    """The profile that touches the frame and may slip on it; None where none does."""
    frames = case.motion.frames
    number = frames.guiding.get(relative.term.rate) if relative.term else None
    return None if number is None else frames.mechanism.joints[number].find_profile()
