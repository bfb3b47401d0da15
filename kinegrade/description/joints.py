"""How bodies are joined: a sentence for each joint."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal, assert_never

from kinegrade.description.subject import Subject
from kinegrade.language.message import Message
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.joints import (
    Arc,
    Belt,
    Contact,
    Joint,
    Mesh,
    Parallel,
    Pin,
    Roll,
    Sleeve,
    Slide,
)
from kinegrade.problem.template.sentences import JointSentence
from kinegrade.worked.positions.shapes import describe_circle, describe_line


def say_joints(subject: Subject) -> Iterator[Message]:
    """The joints in the order of the template; one that pins several bodies to the ground has a
    sentence for each.
    """
    for joint, sentence in subject.joints:
        yield from _say_joint(joint, sentence, subject)


def _say_joint(joint: Joint, sentence: JointSentence, subject: Subject) -> Iterator[Message]:
    match joint:
        case Pin(point=point, bodies=bodies):
            yield from _say_pin(point, bodies, subject)
        case Slide():
            (line,) = _name_shapes(sentence, subject)
            yield _say_slide(joint, line, subject)
        case Arc(point=point, body=body, of=of):
            (circle,) = _name_shapes(sentence, subject)
            names = {"point": subject.place(point, body), "of": subject.body(of)}
            yield Message("description.arc", circle=circle, **names)
        case Contact() | Roll():
            profile = joint.find_profile()
            if profile is not None and profile.of_curvature:
                yield Message("description.curvature", body=subject.body(profile.body))
            yield _say_touching(joint, sentence, subject)
        case Mesh() | Belt():
            yield _say_carried(joint, sentence, subject)
        case Sleeve(body=body, of=of):
            (line,) = _name_shapes(sentence, subject)
            names = {"body": subject.body(body), "of": subject.body(of)}
            yield Message("description.sleeve", line=line, **names)
        case Parallel(body=body, of=of) if of == GROUND:
            yield Message("description.parallel-ground", body=subject.body(body))
        case Parallel(body=body, of=of):
            names = {"body": subject.body(body), "of": subject.body(of)}
            yield Message("description.parallel", **names)
        case _:
            assert_never(joint)


def _say_pin(point: str, bodies: tuple[str, ...], subject: Subject) -> Iterator[Message]:
    letter = subject.instance.letter(point)
    moving = [body for body in bodies if body != GROUND]
    if GROUND not in bodies:
        names = subject.bodies(moving)
        yield Message("description.pin", bodies=names, point=letter)
        return
    for body in moving:
        yield Message("description.pin-ground", body=subject.body(body), point=letter)


def _say_slide(slide: Slide, line: Message, subject: Subject) -> Message:
    of = subject.body(slide.of)
    if slide.body == GROUND:
        point = subject.instance.letter(slide.point)
        return Message("description.slide-fixed-point", line=line, of=of, point=point)
    place = subject.place(slide.point, slide.body)
    if slide.of == GROUND:
        return Message("description.slide-ground", point=place, line=line)
    return Message("description.slide", point=place, of=of, line=line)


def _say_touching(joint: Contact | Roll, sentence: JointSentence, subject: Subject) -> Message:
    """The circle of one body, and what it touches of the other."""
    circle, shape = _name_shapes(sentence, subject)
    names = {
        "circle": circle,
        "body": subject.body(sentence.body),
        "shape": shape,
        "of": subject.body(sentence.of),
    }
    within: Literal["contact", "contact-inside", "roll", "roll-inside"]
    match joint:
        case Contact():
            within = "contact-inside" if joint.inside else "contact"
        case Roll():
            within = "roll-inside" if joint.inside else "roll"
        case _:
            assert_never(joint)
    return Message(f"description.touching-{within}", **names)


def _say_carried(joint: Mesh | Belt, sentence: JointSentence, subject: Subject) -> Message:
    """The circles of two bodies, and the body that carries them."""
    circle, other = _name_shapes(sentence, subject)
    names = {
        "circle": circle,
        "body": subject.body(sentence.body),
        "other": other,
        "of": subject.body(sentence.of),
        "carrier": subject.body(sentence.carrier),
    }
    run: Literal["mesh", "mesh-inside", "belt-open", "belt-crossed"]
    match joint:
        case Mesh():
            run = "mesh-inside" if joint.inside else "mesh"
        case Belt():
            run = "belt-crossed" if joint.crossed else "belt-open"
        case _:
            assert_never(joint)
    return Message(f"description.carried-{run}", **names)


def _name_shapes(sentence: JointSentence, subject: Subject) -> Iterator[Message]:
    """The lines and circles of a joint in prose, in the order of its sentence."""
    for shape in (sentence.circle, sentence.on):
        if shape is None:
            continue
        named = subject.numbers.name_in_call(shape)
        if shape.function == "circle":
            yield describe_circle(named, subject.telling)
        else:
            yield describe_line(named, subject.telling)
