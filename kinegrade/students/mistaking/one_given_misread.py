"""One given misread, all others taken as they are: the supplement of an angle, another length for
a length, the diameter for a radius.

A mistake of one identifier has as many readings here as a template has givens that can be misread
so; `mistake_kinds.find_candidates` makes a mistake of each.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, partial
from itertools import permutations

import numpy as np
from flint import fmpq

from kinegrade.expressions.reading import read_expression
from kinegrade.expressions.tree import Call, Expression, Name, find_names
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.assembling.parameters import read_parameter
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.students.mistaking.misreadings import Givens, Reading, find_radii
from kinegrade.students.mistaking.mistake_names import MistakeName


@dataclass(frozen=True)
class OneGivenMisread:
    """A mistake that misreads one given: `given` names it, and what it is taken for."""

    identifier: MistakeName
    given: str
    reading: Reading


def list_misreadings(template: Template) -> Iterator[OneGivenMisread]:
    """All givens of a template that can be misread alone."""
    for name in _find_inner_angles(template):
        reading = partial(_take_supplement, name)
        yield OneGivenMisread("supplementary-angle", name, reading)
    for name, other in _find_alike_lengths(template):
        reading = partial(_take_other, name, other)
        yield OneGivenMisread("one-length-for-another", f"{name}.{other}", reading)
    radii = sorted(find_radii(template))
    for name in radii if len(radii) > 1 else ():
        yield OneGivenMisread("diameter-for-radius", name, partial(_take_diameter, name))


def _take_supplement(
    name: str, template: Template, values: Givens, arithmetic: Arithmetic
) -> Givens:
    """A given angle taken as 180 degrees minus it; a right angle cannot be misread so."""
    other = arithmetic.turns(fmpq(1)) - values[name]
    if not arithmetic.certified:
        other = np.where(np.isclose(other, values[name]), np.nan, other)
    return {**values, name: other}


def _take_other(
    name: str, other: str, template: Template, values: Givens, arithmetic: Arithmetic
) -> Givens:
    """A given length taken as long as another."""
    return {**values, name: values[other]}


def _take_diameter(name: str, template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
    """A given radius doubled."""
    return {**values, name: values[name] * 2}


def _find_inner_angles(template: Template) -> Iterator[str]:
    """The given angles that are always between 0 and 180 degrees, as those between two lines are;
    a direction that turns further has no supplement that could be read off a figure.
    """
    for name in sorted(template.angles):
        if _is_inner_angle(template.parameters[name]):
            yield name


@cache
def _is_inner_angle(parameter: Parameter) -> bool:
    floats = Floats()
    angles = [
        read_parameter(parameter, read_expression(choice), floats) for choice in parameter.choices
    ]
    return bool(min(angles) > 0 and max(angles) < np.pi * (1 - 1e-12))


def _find_alike_lengths(template: Template) -> Iterator[tuple[str, str]]:
    """Each given length with one that it may be confused with: what a joint's circles are made of.

    These are the radii of two circles that roll, mesh or carry a belt, and the radius of a single
    circle with the lengths that place its centre, as the distance of the contact of a cam is.
    """
    pairs: dict[tuple[str, str], None] = {}
    for joint in template.scheme.joints:
        shapes = (joint.circle, joint.on)
        circles = [shape for shape in shapes if shape is not None and shape.function == "circle"]
        trees = [circle.arguments[1] for circle in circles]
        if len(circles) == 1:
            trees += _find_centre(template, circles[0])
        names = [name for tree in trees for name in find_names(tree)]
        lengths = sorted({name for name in names if _is_length(template, name)})
        pairs.update(dict.fromkeys(permutations(lengths, 2)))
    yield from pairs


def _find_centre(template: Template, circle: Call) -> list[Expression]:
    """How the centre of a circle is constructed, where it is a point of the template."""
    centre = circle.arguments[0]
    return [template.scheme.points[centre.name]] if isinstance(centre, Name) else []


def _is_length(template: Template, name: str) -> bool:
    parameter = template.parameters.get(name)
    return parameter is not None and parameter.is_size
