"""The curves of a cycle as graphs one below the other, in SVG: axes with units and round ticks, the
instant marked. It is black on white and holds no script, link or style sheet.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from html import escape

import numpy as np

from kinegrade.cycles.curves import Curve
from kinegrade.cycles.cycle import Cycle
from kinegrade.cycles.moving_figure import MovingFigure, draw_cycle
from kinegrade.cycles.ticks import Axis, make_axis, make_turn_axis
from kinegrade.cycles.wording import say_input
from kinegrade.figure.back_ends.svg import FONTS, write_parts, write_symbol_spans
from kinegrade.figure.placing.extent import EM
from kinegrade.language import Language
from kinegrade.language.decimal_mark import write_decimal_text
from kinegrade.language.math.units import write_unit
from kinegrade.motion.path import Array, MotionPath

_WIDTH, _HEIGHT = 160.0, 36.0  # millimetres, of one graph with its ticks
_LEFT, _RIGHT, _TOP, _BOTTOM = 18.0, 4.0, 6.5, 6.0
_FOOT = 5.0  # below the last graph, for what is drawn to the right
_SMALL = EM * 0.85
_ACROSS, _UPWARD = 9, 4  # ticks, about
_FAMILIES = f"{FONTS}, Noto Serif CJK SC, Songti SC, SimSun"
_INK = 'fill="#000" stroke="none"'
_Place = tuple[float, float]  # millimetres from the left and from above


@dataclass(frozen=True)
class _Panel:
    """Where one graph stands: its axes, and the height of its upper edge in the picture."""

    across: Axis
    upward: Axis
    top: float

    def x(self, value: float) -> float:
        """Millimetres from the left."""
        return _LEFT + self.across.place(value) * (_WIDTH - _LEFT - _RIGHT)

    def y(self, value: float) -> float:
        """Millimetres from above."""
        height = _HEIGHT - _TOP - _BOTTOM
        return self.top + _TOP + (1 - self.upward.place(value)) * height

    def corner(self, across: float, upward: float) -> _Place:
        """The place of two values."""
        return self.x(across), self.y(upward)


def draw_graphs(cycle: Cycle, language: Language, *, with_figure: bool = False) -> str:
    """The graphs of all curves as an SVG document, below the figure of the instant where that is
    wanted. Raises TypesetError for a symbol that is none.
    """
    figure = draw_cycle(cycle) if with_figure else None
    above = figure.height if figure else 0.0
    moved = convert_displacements(cycle.path, cycle.path.spread(2)[[0, 1]])
    make = make_turn_axis if cycle.path.input.is_angle else make_axis
    across = make(float(moved[0]), float(moved[1]), _ACROSS)
    parts = [_write_figure(figure)] if figure else []
    for number, curve in enumerate(cycle.curves):
        panel = _Panel(across, _choose_range(curve), above + number * _HEIGHT)
        parts += _draw_panel(panel, cycle, number, language)
    height = above + _HEIGHT * len(cycle.curves) + _FOOT
    title = escape(say_input(cycle.path, cycle.solution.template, language))
    parts.append(_write_text(_WIDTH - _RIGHT, height - 1.2, title, "end"))
    return "\n".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH:g}mm" height="{height:g}mm" '
            f'viewBox="0 0 {_WIDTH:g} {height:g}">',
            f'<rect width="{_WIDTH:g}" height="{height:g}" fill="#fff"/>',
            f'<g fill="none" stroke="#000" stroke-linejoin="round" font-family="{_FAMILIES}">',
            *parts,
            "</g>",
            "</svg>",
            "",
        )
    )


def _write_figure(figure: MovingFigure) -> str:
    """The drawing of the instant, at the top."""
    parts = write_parts(figure.at_instant, figure.height)
    return f'<g stroke-linecap="round" font-size="{EM:.2f}">{parts}</g>'


def convert_displacements(path: MotionPath, moved: Array) -> Array:
    """Displacements of the input as they are shown: angles in degrees, ways in m."""
    return np.asarray(np.degrees(moved)) if path.input.is_angle else moved


def _choose_range(curve: Curve) -> Axis:
    """The axis of a curve; values that grow beyond bounds at dead points are cut off."""
    known = np.isfinite(curve.values)
    if not known.any():
        return make_axis(0.0, 1.0, _UPWARD)
    low, high = float(curve.values[known].min()), float(curve.values[known].max())
    if curve.is_steep:
        width = curve.usual[1] - curve.usual[0]
        low, high = max(low, curve.usual[0] - width / 2), min(high, curve.usual[1] + width / 2)
    return make_axis(low, high, _UPWARD)


def _draw_panel(panel: _Panel, cycle: Cycle, number: int, language: Language) -> Iterator[str]:
    """One graph: its axes, the instant, the curve."""
    yield from _draw_axes(panel, language)
    curve = cycle.curves[number]
    start, end = panel.corner(0.0, panel.upward.high), panel.corner(0.0, panel.upward.low)
    yield _write_title(panel.x(panel.across.low), panel.top + _TOP - 2.2, curve)
    yield _write_line(start, end, 0.18, "1.2 1")
    left, top = panel.corner(panel.across.low, panel.upward.high)
    right, bottom = panel.corner(panel.across.high, panel.upward.low)
    yield (
        f'<clipPath id="graph-{number}"><rect x="{left:.2f}" y="{top - 0.4:.2f}" '
        f'width="{right - left:.2f}" height="{bottom - top + 0.8:.2f}"/></clipPath>'
    )
    path = _trace(panel, convert_displacements(cycle.path, curve.moved), curve.values)
    yield f'<path d="{path}" stroke-width=".4" clip-path="url(#graph-{number})"/>'
    if panel.upward.low <= cycle.instant[number] <= panel.upward.high:
        x, y = panel.corner(0.0, cycle.instant[number])
        yield f'<circle cx="{x:.2f}" cy="{y:.2f}" r=".8" {_INK}/>'


def _draw_axes(panel: _Panel, language: Language) -> Iterator[str]:
    """The axes with their ticks, and a thin line across at each."""
    across, upward = panel.across, panel.upward
    for tick in upward.ticks:
        start, end = panel.corner(across.low, tick), panel.corner(across.high, tick)
        yield _write_line(start, end, 0.25 if tick in (0.0, upward.low) else 0.08)
        text = write_signed(upward.write(tick), language)
        yield _write_text(start[0] - 1.5, start[1] + 1.0, text, "end")
    for tick in across.ticks:
        x, y = panel.corner(tick, upward.low)
        yield _write_line((x, y), (x, y - 1.2), 0.18)
        yield _write_text(x, y + 3.8, write_signed(across.write(tick), language), "middle")
    corner = panel.corner(across.low, upward.low)
    yield _write_line(panel.corner(across.low, upward.high), corner, 0.25)


def _trace(panel: _Panel, moved: Array, values: Array) -> str:
    """The curve as a path that pauses where no value is finite, or far outside."""
    room = panel.upward.high - panel.upward.low
    low, high = panel.upward.low - room, panel.upward.high + room
    parts: list[str] = []
    drawn = False
    for x, y in zip(moved, values, strict=True):
        if np.isfinite(y):
            place = f"{panel.x(float(x)):.2f} {panel.y(float(min(max(y, low), high))):.2f}"
            parts.append(f"{'L' if drawn else 'M'}{place}")
        drawn = bool(np.isfinite(y))
    return "".join(parts)


def _write_title(x: float, y: float, curve: Curve) -> str:
    """The symbol with its unit."""
    unit = curve.ask.unit.text
    shown = "" if unit == "1" else f'<tspan dx="1.2">({escape(write_unit(unit))})</tspan>'
    spans = f"<tspan>{write_symbol_spans(curve.ask.symbol)}</tspan>{shown}"
    return f'<text x="{x:.2f}" y="{y:.2f}" font-size="{EM:.2f}" {_INK}>{spans}</text>'


def write_signed(number: str, language: Language) -> str:
    """A number with the minus sign, and with the decimal mark of a language."""
    return write_decimal_text(number, language).replace("-", "\u2212")


def _write_line(start: _Place, end: _Place, width: float, dash: str = "") -> str:
    dashed = f' stroke-dasharray="{dash}"' if dash else ""
    path = f"M{start[0]:.2f} {start[1]:.2f}L{end[0]:.2f} {end[1]:.2f}"
    return f'<path d="{path}" stroke-width="{width:g}"{dashed}/>'


def _write_text(x: float, y: float, text: str, anchor: str) -> str:
    place = f'x="{x:.2f}" y="{y:.2f}" text-anchor="{anchor}" font-size="{_SMALL:.2f}"'
    return f"<text {place} {_INK}>{text}</text>"
