"""The mistakes that are known: what each does to the givens or to the mechanism's terms.

A mistake is data: shares of terms (`slips`) or a change of the givens; those of the answer alone
are in `written_mistakes`. `mistake_names` has its identifier and the sentence that describes it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from flint import fmpq

from kinegrade.expressions.tree import Expression
from kinegrade.problem.template.template import Ask, Template
from kinegrade.stated_marking import join_label
from kinegrade.students.mistaking.misreadings import (
    Reading,
    complement_angles,
    find_radii,
    find_unconverted_rates,
    take_as_given,
    take_degrees_as_radians,
    take_diameters,
    take_plain_lengths,
    take_plain_rates,
)
from kinegrade.students.mistaking.mistake_names import MistakeName
from kinegrade.students.mistaking.one_given_misread import list_misreadings
from kinegrade.students.mistaking.slip_occasions import calls, find_share_occasions


@dataclass(frozen=True)
class Mistake:
    """One way to go wrong on the way to all answers of an instance.

    `shares` are those of `Slips` that are not 1; `givens` gives the parameters as they are
    mistaken; `other_branch` takes the other common point of circles and lines;
    `plain_lengths` works with the numbers of lengths as they stand; `given` names the parameter
    that alone is misread, where it is one. `own` is the identifier of a mistake that the author of
    a question knows, which takes `steps` for something else.
    """

    identifier: MistakeName | Literal[""]  # "" for working without a mistake
    shares: Mapping[str, Any] = field(default_factory=dict)
    givens: Reading = take_as_given
    other_branch: bool = False
    plain_lengths: bool = False
    given: str = ""
    steps: Mapping[str, Expression] = field(default_factory=dict)
    own: str = ""

    @property
    def label(self) -> str:
        """What tells it from all other mistakes in a template: `find_identifier` gives the
        identifier back.
        """
        return self.own or join_label(self.identifier, self.given)


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
    Mistake("sine-for-cosine", givens=complement_angles),
    Mistake("degrees-for-radians", givens=take_degrees_as_radians),
    Mistake("diameter-for-radius", givens=take_diameters),
    Mistake("rpm-not-converted", givens=take_plain_rates),
    Mistake("millimetres-for-metres", givens=take_plain_lengths, plain_lengths=True),
)


def find_candidates(template: Template, asks: Mapping[str, Ask]) -> Iterator[Mistake]:
    """The mistakes that are possible in the template, where these quantities are asked for."""
    occasions, others = find_share_occasions(template, asks), _find_given_occasions(template, asks)
    for mistake in MISTAKES:
        if others.get(
            mistake.identifier,
            template.scheme.drivers and any(occasions[share] for share in mistake.shares),
        ):
            yield mistake
    for each in list_misreadings(template):
        yield Mistake(each.identifier, givens=each.reading, given=each.given)
    for own in template.scheme.mistakes:
        yield Mistake("", steps=own.steps, own=own.identifier)


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
        "diameter-for-radius": bool(find_radii(template)),
        "rpm-not-converted": bool(find_unconverted_rates(template)),
        "millimetres-for-metres": len({unit.text.split("/")[0] for unit in units}) > 1,
    }
