"""What is given, misread as a whole: every angle, radius, rate or length alike.

Each function gives the parameters as they are taken. `one_given_misread` has those of one angle,
length or radius alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from flint import arb, fmpq

from kinegrade.expressions.tree import Name
from kinegrade.numbers.angle import Angle
from kinegrade.numbers.number import Arithmetic
from kinegrade.numbers.refusals import Inexact
from kinegrade.problem.template.template import Template

Givens = Mapping[str, Any]  # parameters in SI
Reading = Callable[[Template, Givens, Arithmetic], Givens]


def take_as_given(template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
    """The parameters as they are."""
    return values


def complement_angles(template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
    """Every given angle counted from the other axis, which swaps its sine and its cosine."""
    quarter = arithmetic.turns(fmpq(1, 2))
    return {**values, **{name: quarter - values[name] for name in template.angles}}


def take_degrees_as_radians(template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
    """Every angle given in degrees with its number taken for radians."""
    names = [name for name, parameter in template.parameters.items() if parameter.unit.degrees]
    return {**values, **{name: _count_degrees(values[name], arithmetic) for name in names}}


def _count_degrees(angle: Any, arithmetic: Arithmetic) -> Any:
    """How many degrees an angle has. Raises Inexact in the exact field, where a number of radians
    is no angle.
    """
    if isinstance(angle, Angle):
        raise Inexact  # a number of radians
    return angle * 180 / (arb.pi() if isinstance(angle, arb) else arithmetic.turns(1))


def take_diameters(template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
    """Every given radius of a circle doubled."""
    return {**values, **{name: values[name] * 2 for name in find_radii(template)}}


def take_plain_rates(template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
    """Angular rates given in revolutions or radians per minute with their number taken for radians
    per second.
    """
    return {
        **values,
        **{
            name: values[name] / arithmetic.scale(template.parameters[name].unit.scale)
            for name in find_unconverted_rates(template)
        },
    }


def take_plain_lengths(template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
    """Lengths, velocities and accelerations with the number that is given, whatever its unit."""
    return {
        **values,
        **{
            name: value / arithmetic.scale(template.parameters[name].unit.scale)
            for name, value in values.items()
            if template.parameters[name].unit.length
        },
    }


def find_radii(template: Template) -> set[str]:
    """The parameters that are the radius of a circle which joints speak of or the figure labels."""
    circles = [
        shape
        for joint in template.scheme.joints
        for shape in (joint.circle, joint.on)
        if shape is not None and shape.function == "circle"
    ]
    named = {
        tree.name for tree in (circle.arguments[1] for circle in circles) if isinstance(tree, Name)
    }
    labelled = {radius.symbol for radius in template.figure.radii}
    return {
        name
        for name, parameter in template.parameters.items()
        if parameter.is_size and (name in named or parameter.symbol in labelled)
    }


def find_unconverted_rates(template: Template) -> list[str]:
    """The parameters that are angular rates in other units than rad/s and rad/s^2."""
    return [
        name
        for name, parameter in template.parameters.items()
        if parameter.unit.angle and parameter.unit.time < 0 and not parameter.unit.is_si
    ]
