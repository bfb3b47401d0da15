"""The curves of a cycle as graphs one below the other, in SVG, below the figure of the instant
where that is wanted. It is black on white and holds no script, link or style sheet.
"""

from __future__ import annotations

from html import escape

from kinegrade.cycles.curves import Curve
from kinegrade.cycles.cycle import Cycle
from kinegrade.cycles.graph import Panel, choose_across, choose_upward, draw_graph
from kinegrade.cycles.moving_figure import draw_cycle
from kinegrade.cycles.wording import say_input
from kinegrade.figure.back_ends.svg import (
    CLOSE,
    FONTS,
    open_document,
    write_parts,
    write_symbol_spans,
)
from kinegrade.figure.scene import Box
from kinegrade.language import Language
from kinegrade.language.math.units import write_unit

_WIDTH, _HEIGHT = 160.0, 36.0  # millimetres, of one graph with its numbers
_LEFT, _RIGHT, _TOP, _BOTTOM = 18.0, 4.0, 6.5, 6.0
_FOOT = 5.0  # below the last graph, for what is drawn to the right
_ACROSS, _UPWARD = 9, 4  # ticks, about
_FAMILIES = f"{FONTS}, Noto Serif CJK SC, Songti SC, SimSun"


def draw_graphs(cycle: Cycle, language: Language, *, with_figure: bool = False) -> str:
    """The graphs of all curves as an SVG document. Raises TypesetError for a symbol that is
    none.
    """
    figure = draw_cycle(cycle) if with_figure else None
    above = figure.height if figure else 0.0
    height = above + _HEIGHT * len(cycle.curves) + _FOOT
    parts = [write_parts(figure.at_instant, figure.height)] if figure else []
    across = choose_across(cycle.path, _ACROSS)
    for number, curve in enumerate(cycle.curves):
        top = above + number * _HEIGHT
        frame = Box(_LEFT, height - top - _HEIGHT + _BOTTOM, _WIDTH - _RIGHT, height - top - _TOP)
        panel = Panel(across, choose_upward(curve, _UPWARD), frame)
        parts.append(_write_title(_LEFT, top + _TOP - 2.2, curve))
        parts.append(write_parts(draw_graph(panel, cycle, number, language), height))
    title = escape(say_input(cycle.path, cycle.solution.template, language))
    parts.append(_write_text(_WIDTH - _RIGHT, height - 1.2, title, "end"))
    return "\n".join((open_document(_WIDTH, height), *parts, CLOSE))


def _write_title(x: float, y: float, curve: Curve) -> str:
    """The symbol with its unit."""
    unit = curve.ask.unit.text
    shown = "" if unit == "1" else f'<tspan dx="1.2">({escape(write_unit(unit))})</tspan>'
    spans = f"<tspan>{write_symbol_spans(curve.ask.symbol)}</tspan>{shown}"
    return _write_text(x, y, spans, "start")


def _write_text(x: float, y: float, text: str, anchor: str) -> str:
    place = f'x="{x:.2f}" y="{y:.2f}" text-anchor="{anchor}" font-family="{_FAMILIES}"'
    return f'<text {place} fill="#000" stroke="none">{text}</text>'
