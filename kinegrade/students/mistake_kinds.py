"""The mistakes that are known: what each does to the givens or to the mechanism's terms.

A mistake is data: shares of terms (`kinegrade.students.slips`) or a change of the givens; those of
the answer alone are in `written_mistakes`. `mistake_names` has its identifier and the sentence that
describes it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from flint import arb, fmpq

from kinegrade.expressions.tree import Name
from kinegrade.numbers.angle import Angle, Inexact
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.template.template import Ask, Template
from kinegrade.students.mistake_names import MistakeName
from kinegrade.students.slip_occasions import calls, find_share_occasions

Givens = Mapping[str, Any]  # parameters in SI

_Reading = Callable[[Template, Givens, Arithmetic], Givens]


def _take_as_given(template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
    """The parameters as they are."""
    return values


@dataclass(frozen=True)
class Mistake:
    """One way to go wrong on the way to all answers of an instance.

    `shares` are those of `Slips` that are not 1; `givens` gives the parameters as they are
    mistaken; `other_branch` takes the other common point of circles and lines;
    `_take_plain_lengths` works with the numbers of lengths as they stand.
    """

    identifier: MistakeName | Literal[""]  # "" for working without a mistake
    shares: Mapping[str, Any] = field(default_factory=dict)
    givens: _Reading = _take_as_given
    other_branch: bool = False
    plain_lengths: bool = False


def _complement_angles(template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
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


def _take_diameters(template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
    """Every given radius of a circle doubled."""
    return {**values, **{name: values[name] * 2 for name in _find_radii(template)}}


def _take_plain_rates(template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
    """Angular rates given in revolutions or radians per minute with their number taken for radians
    per second.
    """
    return {
        **values,
        **{
            name: values[name] / arithmetic.number(template.parameters[name].unit.factor)
            for name in _find_unconverted_rates(template)
        },
    }


def _take_plain_lengths(template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
    """Lengths, velocities and accelerations with the number that is given, whatever its unit."""
    return {
        **values,
        **{
            name: value / arithmetic.number(template.parameters[name].unit.factor)
            for name, value in values.items()
            if template.parameters[name].unit.length
        },
    }


MISTAKES = (
    Mistake("coriolis-dropped", {"coriolis": fmpq(0)}),
    Mistake("coriolis-halved", {"coriolis": fmpq(1, 2)}),
    Mistake("coriolis-reversed", {"coriolis": fmpq(-1)}),
    Mistake("coriolis-wrong-omega", {"frame_rate": fmpq(0)}),
    Mistake("relative-normal-dropped", {"relative_normal": fmpq(0)}),
    Mistake("relative-normal-outwards", {"relative_normal": fmpq(-1)}),
    Mistake("path-normal-dropped", {"path_normal": fmpq(0)}),
    Mistake("path-normal-outwards", {"path_normal": fmpq(-1)}),
    Mistake("omega-not-squared", {"square": fmpq(0)}),
    Mistake("tangential-dropped", {"tangential": fmpq(0)}),
    Mistake("relative-for-absolute", {"carried": fmpq(0)}),
    Mistake("absolute-for-relative", {"asked_relative": fmpq(0)}),
    Mistake("meshing-reversed", {"meshing": fmpq(-1)}),
    Mistake("belt-reversed", {"crossing": fmpq(-1)}),
    Mistake("arm-for-sum", {"arm": fmpq(0)}),
    Mistake("inverse-ratio", {"ratio": fmpq(0)}),
    Mistake("wrong-pole", {"pole": fmpq(0)}),
    Mistake("far-pivot-for-pole", {"far_pivot": fmpq(0)}),
    Mistake("far-end-for-pole", {"far_end": fmpq(0)}),
    Mistake("pole-on-velocities", {"across": fmpq(0)}),
    Mistake("neighbours-omega", {"neighbour": fmpq(0)}),
    Mistake("translation-assumed", {"rotation": fmpq(0)}),
    Mistake("centre-for-pole", {"centre": fmpq(0)}),
    Mistake("transport-for-absolute", {"relative": fmpq(0)}),
    Mistake("transport-of-other-frame", {"own_transport": fmpq(0)}),
    Mistake("added-as-scalars", {"vector_sum": fmpq(0)}),
    Mistake("other-branch", other_branch=True),
    Mistake("sine-for-cosine", givens=_complement_angles),
    Mistake("degrees-for-radians", givens=take_degrees_as_radians),
    Mistake("diameter-for-radius", givens=_take_diameters),
    Mistake("rpm-not-converted", givens=_take_plain_rates),
    Mistake("millimetres-for-metres", givens=_take_plain_lengths, plain_lengths=True),
)


def _find_radii(template: Template) -> set[str]:
    """The parameters that are the radius of a circle which joints speak of."""
    circles = [
        shape
        for joint in template.scheme.joints
        for shape in (joint.circle, joint.on)
        if shape is not None and shape.function == "circle"
    ]
    named = {
        tree.name for tree in (circle.arguments[1] for circle in circles) if isinstance(tree, Name)
    }
    return {
        name
        for name in named & set(template.parameters)
        if template.parameters[name].unit.length == 1
    }


def _find_unconverted_rates(template: Template) -> list[str]:
    """The parameters that are angular rates in other units than rad/s and rad/s^2."""
    return [
        name
        for name, parameter in template.parameters.items()
        if parameter.unit.angle and parameter.unit.time < 0 and parameter.unit.factor != 1
    ]


def find_candidates(template: Template, asks: Mapping[str, Ask]) -> Iterator[Mistake]:
    """The mistakes that are possible in the template, where these quantities are asked for."""
    occasions, others = find_share_occasions(template, asks), _find_given_occasions(template, asks)
    for mistake in MISTAKES:
        if others.get(
            mistake.identifier,
            template.scheme.drivers and any(occasions[share] for share in mistake.shares),
        ):
            yield mistake


def _find_given_occasions(template: Template, asks: Mapping[str, Ask]) -> dict[str, bool]:
    """For each mistake in reading what is given whether the template can be misread so."""
    units = {
        unit
        for unit in [
            *(parameter.unit for parameter in template.parameters.values()),
            *(ask.unit for ask in asks.values()),
        ]
        if unit.length
    }
    return {
        "other-branch": any(calls(tree, ("meet",), 3) for tree in template.scheme.points.values()),
        "sine-for-cosine": bool(template.angles),
        "degrees-for-radians": any(
            parameter.unit.degrees for parameter in template.parameters.values()
        ),
        "diameter-for-radius": bool(_find_radii(template)),
        "rpm-not-converted": bool(_find_unconverted_rates(template)),
        "millimetres-for-metres": len({unit.text.split("/")[0] for unit in units}) > 1,
    }
