"""Contacts where nothing is any more: of a circle with a flank beyond its end, and of the pin of a
crank with a Geneva wheel whose slot it has left; and points that are now on a wheel, now beyond it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby

from kinegrade.figure.plane import length
from kinegrade.language.message import Message
from kinegrade.mechanics.joints.touching_pair import TouchingPair
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.shapes import Line
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.hints import Shape
from kinegrade.problem.template.template import Template

_NEAR = 1e-9  # m: less is what doubles leave
_GOING_ON: frozenset[Shape] = frozenset({"rope", "load", "rack", "through"})  # drawn further
_OFF_WHEEL = "point-off-wheel"
_Lost = tuple[str, dict[str, str]]  # what is told of a contact, and its parts


def note_lost_contacts(template: Template, examples: Sequence[Solution]) -> Iterator[Message]:
    """A remark for each contact that some instances have beyond the end of what is touched, and for
    each point that only some have outside its wheel: one that all have there is an arm.
    """
    mechanisms = [each.assembly.mechanism.map(float) for each in examples]
    found = [
        lost
        for each in mechanisms
        for lost in (
            *_find_past_flanks(each, template.figure.shapes),
            *_find_past_slots(each, template),
            *_find_off_wheels(each, template),
        )
    ]
    found.sort(key=str)
    for (kind, parts), those in groupby(found):
        number = len([*those])
        if kind != _OFF_WHEEL or number < len(examples):
            yield Message(f"template.{kind}", **parts, number=number, examined=len(examples))


def _find_past_flanks(mechanism: Mechanism, shapes: Mapping[str, Shape]) -> Iterator[_Lost]:
    """The circles that touch the line of a body beyond the outermost of its points there."""
    at = mechanism.points
    for joint in mechanism.joints:
        if not isinstance(joint, TouchingPair) or shapes.get(joint.of) in _GOING_ON:
            continue
        carriers = [body for body in mechanism.bodies if body.name == joint.of]
        if not carriers or not isinstance(joint.on, Line):
            continue
        start, along = joint.on.point, joint.on.direction
        unit = along * (1 / length(along))
        places = {
            unit.dot(at[name] - start): name
            for name in carriers[0].points
            if abs(unit.cross(at[name] - start)) <= _NEAR
        }
        contact = unit.dot(at[joint.circle.centre] - start)
        least, most = min(places, default=0.0), max(places, default=0.0)
        if len(places) > 1 and not least - _NEAR <= contact <= most + _NEAR:
            line = "".join(sorted((places[least], places[most])))
            yield "contact-past-line", {"body": joint.body, "of": joint.of, "line": line}


def _find_past_slots(mechanism: Mechanism, template: Template) -> Iterator[_Lost]:
    """The pins of cranks that are farther from a Geneva wheel than the mouths of its slots."""
    at = mechanism.points
    pivots = mechanism.find_pivots()
    for joint in template.scheme.joints:
        slotted = template.figure.shapes.get(joint.of) == "geneva" and joint.point != ""
        if slotted and {joint.body, joint.of} <= pivots.keys():
            centre = at[pivots[joint.of]]
            pivot = at[pivots[joint.body]]
            pin = at[joint.point]
            if (pin - centre).dot(pin - pivot) > _NEAR * (centre - pivot).squared():
                yield "pin-past-slot", {"point": joint.point, "of": joint.of}


def _find_off_wheels(mechanism: Mechanism, template: Template) -> Iterator[_Lost]:
    """The points of wheels that are outside the largest circle about the one centre and that no
    joint has: a bar leads to them.
    """
    at = mechanism.points
    drawn = {name for rim in template.figure.circles for name in (rim.centre, rim.through)}
    drawn |= {name for joint in mechanism.joints for name in joint.list_points()}
    for body in mechanism.bodies:
        rolling = [
            joint.circle
            for joint in mechanism.joints
            if isinstance(joint, TouchingPair) and joint.body == body.name
        ]
        centres = {circle.centre for circle in rolling}
        rims = [rim for rim in template.figure.circles if rim.body == body.name]
        if len(centres) != 1 or {rim.centre for rim in rims} - centres:
            continue
        (centre,) = centres
        radii = [circle.radius for circle in rolling]
        radii += [length(at[rim.through] - at[rim.centre]) for rim in rims]
        for name in body.points:
            if name not in drawn and length(at[name] - at[centre]) > max(radii) + _NEAR:
                yield _OFF_WHEEL, {"point": name, "body": body.name, "centre": centre}
