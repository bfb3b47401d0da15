"""The chapter on positions of a worked solution: where each point is at the instant, and the
distances and directions between points.

Everything follows the constructions of the template, in its order, with this paper's numbers.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.numbers.angle import Angle
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Display
from kinegrade.worked.positions.construction_steps import select_needed
from kinegrade.worked.positions.constructions import explain_constructions
from kinegrade.worked.positions.instance import METRE, RADIAN, Instance, make_instance
from kinegrade.worked.positions.parts import Part, list_lines, select_used, write_parts


@dataclass(frozen=True)
class Positions:
    """The chapter: the named lengths, which come first, and a part for each point."""

    case: Case
    lengths: tuple[Block, ...]
    parts: tuple[Part, ...]

    def write(self) -> tuple[Block, ...]:
        """A sentence and equations for each point."""
        return self.lengths + write_parts(self.parts, self.case)

    def write_used(self, later: Sequence[Block]) -> tuple[Block, ...]:
        """The same without coordinates to which nothing `later` in the solution refers."""
        used = select_used(self.parts, (*list_lines(later), *self.case.findings.told))
        return self.lengths + write_parts(used, self.case)


def explain_positions(case: Case, wanted: Collection[str]) -> Positions:
    """Where the points `wanted` are, and those they are constructed from.

    Coordinates in metres, x to the right, y upwards.
    """
    instance = make_instance(case)
    steps = select_needed(instance.steps, wanted)
    lengths = _explain_named_lengths(instance)
    return Positions(case, lengths, explain_constructions(steps, instance))


def _explain_named_lengths(instance: Instance) -> tuple[Block, ...]:
    """The lengths that follow from the given quantities."""
    lines: tuple[Row, ...] = ()
    for name, tree in instance.case.template.scheme.lengths.items():
        unit = RADIAN if isinstance(instance.values[name], Angle) else METRE
        lines += instance.equation(instance.symbols[name], tree, unit)
    return (instance.say(Message("solution.lengths")), Display(lines)) if lines else ()
