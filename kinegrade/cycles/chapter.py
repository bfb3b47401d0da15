"""What a worked solution may end with: small graphs of its answers over the cycle, the instant
marked.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinegrade.cycles.curves import find_followed
from kinegrade.cycles.cycle import Cycle, make_cycle
from kinegrade.cycles.facts import describe_gaps
from kinegrade.cycles.graph import Panel, choose_across, choose_upward, draw_graph
from kinegrade.cycles.wording import Quantities, name_input
from kinegrade.figure.scene import Box, Scene, find_common_box, move
from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.language.sentence import write_sentence
from kinegrade.mechanics.vector import Vector
from kinegrade.motion.path import MotionPath, find_path
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Ask
from kinegrade.worked.document import Block, Heading, Picture, Pictures, say

_FRAME = Box(0.0, 0.0, 62.0, 24.0)  # millimetres
_ACROSS, _UPWARD = 5, 3  # ticks, about


def write_cycle_chapter(
    solution: Solution, asks: Sequence[str], language: Language
) -> tuple[Block, ...]:
    """The chapter for these asks; empty where nothing moves, or none of them has a curve."""
    drawn = _select_followed(solution, asks)
    if not drawn or not isinstance(find_path(solution.motion), MotionPath):
        return ()
    return tuple(_write_blocks(make_cycle(solution, drawn), language))


def require_graphs(solution: Solution, asks: Sequence[str]) -> None:
    """Raises MechanismError where nothing moves, TemplateError where none of the asks has a
    curve.
    """
    make_cycle(solution, _select_followed(solution, asks) or asks)


def _select_followed(solution: Solution, asks: Sequence[str]) -> tuple[str, ...]:
    """Those of the asks that have curves."""
    followed = find_followed(solution)
    return tuple(name for name in asks if name in followed)


def _write_blocks(cycle: Cycle, language: Language) -> Iterator[Block]:
    yield Heading(write_sentence(Message("solution.cycle"), language), 1)
    axis = name_input(cycle.path, cycle.solution.template, language)
    yield say(Message("solution.cycle-axis", axis=axis), language)
    if any(curve.is_steep for curve in cycle.curves):
        yield say(Message("solution.cycle-cut-off"), language)
    written = Quantities(language, cycle.path.input.is_angle)
    for curve in cycle.curves:
        for gap in describe_gaps(curve, f"${curve.ask.symbol}$", written):
            yield say(gap, language)
    graphs = (
        Picture(_draw(cycle, number, language), _name_curve(curve.ask))
        for number, curve in enumerate(cycle.curves)
    )
    yield Pictures(tuple(graphs))


def _draw(cycle: Cycle, number: int, language: Language) -> Scene:
    upward = choose_upward(cycle.curves[number], _UPWARD)
    panel = Panel(choose_across(cycle.path, _ACROSS), upward, _FRAME)
    parts = tuple(draw_graph(panel, cycle, number, language))
    box = find_common_box(parts)
    corner = Vector(-box.left, -box.bottom)
    return Scene(box.width, box.height, 1.0, tuple(move(part, corner) for part in parts))


def _name_curve(ask: Ask) -> str:
    """The symbol with its unit, in prose."""
    unit = ask.unit.text
    return f"${ask.symbol}$" if unit == "1" else f"${ask.symbol}$ ($\\unit{{{unit}}}$)"
