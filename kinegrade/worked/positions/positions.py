"""The chapter on positions of a worked solution: where each point is at the instant, and the
distances and directions between points.

Everything follows the constructions of the template, in its order, with this paper's numbers.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass

from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.numbers.angle import Angle
from kinegrade.worked.case import Case
from kinegrade.worked.construction_steps import Step, select_needed
from kinegrade.worked.document import Block
from kinegrade.worked.positions.algebra import ZERO
from kinegrade.worked.positions.constructions import explain_constructions
from kinegrade.worked.positions.instance import METRE, RADIAN, Instance, make_instance
from kinegrade.worked.positions.parts import (
    Derived,
    Part,
    Stated,
    select_used,
    write_parts,
)


@dataclass(frozen=True)
class Positions:
    """The chapter: the named lengths, which come first, and a part for each point."""

    case: Case
    parts: tuple[Part, ...]

    def write(self) -> tuple[Block, ...]:
        """A sentence and equations for each point."""
        return write_parts(self.parts, self.case)

    def write_used(self, later: Iterable[Row]) -> tuple[Block, ...]:
        """The same without coordinates and lengths to which no formula `later` refers."""
        return write_parts(select_used(self.parts, later), self.case)


def explain_positions(case: Case, wanted: Collection[str]) -> Positions:
    """Where the points `wanted` are, and those they are constructed from.

    Coordinates in metres, x to the right, y upwards.
    """
    instance = make_instance(case)
    steps = _add_origin(select_needed(instance.steps, wanted), instance)
    parts = (*_explain_named_lengths(instance), *explain_constructions(steps, instance))
    return Positions(case, parts)


def _add_origin(steps: Sequence[Step], instance: Instance) -> tuple[Step, ...]:
    """The steps with the point at the origin, where none of them is one: they have coordinates."""
    origins = [step for step in instance.steps if instance.axes.pair(step.tree) == (ZERO, ZERO)]
    if not origins or set(origins) & set(steps):
        return tuple(steps)
    return (origins[0], *steps)


def _explain_named_lengths(instance: Instance) -> Iterator[Stated]:
    """The lengths that follow from the given quantities; a reason that the author gives for one in
    the language stands before it and before those that follow without one.
    """
    template, language = instance.case.template, instance.case.language
    groups = [(Message("solution.lengths"), list[Derived]())]
    for name in template.scheme.lengths:
        reason = template.words.reasons.get(name)
        if reason is not None and reason.has(language):
            text = reason.in_language(language)
            groups.append((Message("solution.because", reason=text), []))
        groups[-1][1].append(_state_length(name, instance))
    yield from (Stated(saying, tuple(found)) for saying, found in groups if found)


def _state_length(name: str, instance: Instance) -> Derived:
    """A named length in symbols, in numbers, and its value."""
    unit = RADIAN if isinstance(instance.values[name], Angle) else METRE
    tree = instance.case.template.scheme.lengths[name]
    symbol = instance.symbols[name]
    return Derived(symbol, instance.equation(symbol, tree, unit))
