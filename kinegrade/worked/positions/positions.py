"""The chapter on positions of a worked solution: where each point is at the instant, and the
distances and directions between points.

Everything follows the constructions of the template, in its order, with this paper's numbers.
"""

from __future__ import annotations

from collections.abc import Collection

from kinegrade.language.math.tree import Row
from kinegrade.language.message import Message
from kinegrade.numbers.angle import Angle
from kinegrade.worked.case import Case
from kinegrade.worked.document import Block, Display
from kinegrade.worked.positions.construction_steps import select_needed
from kinegrade.worked.positions.constructions import write_chapter
from kinegrade.worked.positions.instance import METRE, RADIAN, Instance, make_instance


def explain_positions(case: Case, wanted: Collection[str]) -> tuple[Block, ...]:
    """Where the points `wanted` are, and those they are constructed from: a sentence and equations
    for each.

    Coordinates in metres, x to the right, y upwards. Named lengths of the template come first.
    """
    instance = make_instance(case)
    steps = select_needed(instance.steps, wanted)
    return _explain_named_lengths(instance) + write_chapter(steps, instance)


def _explain_named_lengths(instance: Instance) -> tuple[Block, ...]:
    """The lengths that follow from the given quantities."""
    lines: tuple[Row, ...] = ()
    for name, tree in instance.case.template.scheme.lengths.items():
        unit = RADIAN if isinstance(instance.values[name], Angle) else METRE
        lines += instance.equation(instance.symbols[name], tree, unit)
    return (instance.say(Message("solution.lengths")), Display(lines)) if lines else ()
