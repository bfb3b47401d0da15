"""Slips in reading what is given, one given at a time: by them draws are held against each other.

They have no names, because nobody is told of them: unlike known mistakes they are not kept apart
from the truth, but a draw in which one of them changes nothing is easier than another.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import permutations
from typing import Any, Literal, assert_never

from flint import fmpq

from kinegrade.numbers.number import Arithmetic
from kinegrade.problem.template.template import Parameter, Template
from kinegrade.students.mistaking.misreadings import Givens
from kinegrade.students.mistaking.mistake_kinds import Mistake

_Slip = Literal["other-axis", "reversed", "forgotten"]


@dataclass(frozen=True)
class _Misread:
    """A given taken wrongly, or, where `other` is named, the other one taken in its place."""

    name: str
    slip: _Slip | None
    other: str = ""

    def __call__(self, template: Template, values: Givens, arithmetic: Arithmetic) -> Givens:
        """The parameters as they are taken."""
        if self.slip is None:
            return {**values, self.name: values[self.other]}
        return {**values, self.name: _take(self.slip, values[self.name], arithmetic)}


def list_unnamed_slips(template: Template) -> Iterator[Mistake]:
    """The slips in reading that a template gives occasion for: an angle counted from the other
    axis, a rate reversed or forgotten, one given taken for another of its kind.
    """
    alike: dict[tuple[int, int, int, bool], list[str]] = {}
    for name, parameter in template.parameters.items():
        for slip in _list_slips(parameter):
            yield Mistake("", givens=_Misread(name, slip))
        unit = parameter.unit
        alike.setdefault((unit.length, unit.time, unit.angle, unit.degrees), []).append(name)
    for names in alike.values():
        for one, other in permutations(names, 2):
            yield Mistake("", givens=_Misread(one, None, other))


def _list_slips(parameter: Parameter) -> tuple[_Slip, ...]:
    """How a given may be taken wrongly by itself."""
    if parameter.unit.degrees:
        return ("other-axis",)
    return ("reversed", "forgotten") if parameter.unit.time else ()


def _take(slip: _Slip, value: Any, arithmetic: Arithmetic) -> Any:
    """A value as it is taken wrongly."""
    match slip:
        case "other-axis":
            return arithmetic.turns(fmpq(1, 2)) - value
        case "reversed":
            return -value
        case "forgotten":
            return value * 0
        case _:
            assert_never(slip)
