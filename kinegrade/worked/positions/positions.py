"""The chapter on positions of a worked solution: where each point is at the instant, and the
distances and directions between points.

Everything follows the constructions of the template, in its order, with this paper's numbers.
"""

from __future__ import annotations

from collections.abc import Collection

from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.numbers.angle import Angle
from kinegrade.problem.solving import Solution
from kinegrade.worked.document import Block, Display, say
from kinegrade.worked.formulas.coordinates import select_needed
from kinegrade.worked.formulas.instance import METRE, RADIAN, Instance, make_instance
from kinegrade.worked.positions.constructions import write_chapter


def explain_positions(
    solution: Solution, wanted: Collection[str], language: Language
) -> tuple[Block, ...]:
    """Where the points `wanted` are, and those they are constructed from: a sentence and equations
    for each.

    Coordinates in metres, x to the right, y upwards. Named lengths of the template come first.
    """
    instance = make_instance(solution)
    steps = select_needed(instance.steps, wanted)
    return _explain_named_lengths(instance, language) + write_chapter(steps, instance, language)


def _explain_named_lengths(instance: Instance, language: Language) -> tuple[Block, ...]:
    """The lengths that follow from the given quantities."""
    lines: tuple[str, ...] = ()
    for name, tree in instance.solution.template.scheme.lengths.items():
        unit = RADIAN if isinstance(instance.values[name], Angle) else METRE
        lines += instance.equation(instance.symbols[name], tree, unit)
    return (say(Message("solution.lengths"), language), Display(lines)) if lines else ()
