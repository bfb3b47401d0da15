"""One curve of a cycle as a graph: axes with round ticks, the curve, the instant marked."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from kinegrade.cycles.curves import Curve
from kinegrade.cycles.cycle import Cycle
from kinegrade.cycles.ticks import Axis, make_axis, make_turn_axis
from kinegrade.figure.placing.extent import EM
from kinegrade.figure.scene import FIRM, Box, Disc, Label, Outline, Pen, Primitive, Strokes
from kinegrade.language import Language
from kinegrade.language.decimal_mark import write_decimals_of_math
from kinegrade.mechanics.vector import Vector
from kinegrade.motion.path import Array, MotionPath

_GRID, _TICK, _AXIS = Pen(0.08), Pen(0.18), Pen(0.25)
_INSTANT = Pen(0.18, "dashed")
_DOT = 0.8  # millimetres
_TICK_LENGTH, _BELOW, _BESIDE = 1.2, 2.9, 1.5  # millimetres from an axis, to its numbers
_WIDTHS = {".": 0.28, "-": 0.8}  # of what numbers are made of, in em
_DIGIT = 0.5


@dataclass(frozen=True)
class Panel:
    """Where a graph stands: its axes, and the frame between them, mm."""

    across: Axis
    upward: Axis
    frame: Box

    def locate(self, across: float, upward: float) -> Vector:
        """The place of two values."""
        frame = self.frame
        return Vector(
            frame.left + self.across.place(across) * frame.width,
            frame.bottom + self.upward.place(upward) * frame.height,
        )


def choose_across(path: MotionPath, most: int) -> Axis:
    """The axis of the input, with about so many ticks."""
    low, high = convert_displacements(path, path.spread(2)).tolist()
    return (make_turn_axis if path.input.is_angle else make_axis)(low, high, most)


def convert_displacements(path: MotionPath, moved: Array) -> Array:
    """Displacements of the input as they are shown: angles in degrees, ways in m."""
    return np.asarray(np.degrees(moved)) if path.input.is_angle else moved


def choose_upward(curve: Curve, most: int) -> Axis:
    """The axis of a curve; values that grow beyond bounds at dead points are cut off."""
    known = np.isfinite(curve.values)
    if not known.any():
        return make_axis(0.0, 1.0, most)
    if curve.constant is not None:
        return make_axis(curve.constant, curve.constant, most)
    low, high = float(curve.values[known].min()), float(curve.values[known].max())
    if curve.is_steep:
        width = curve.usual[1] - curve.usual[0]
        low, high = max(low, curve.usual[0] - width / 2), min(high, curve.usual[1] + width / 2)
    return make_axis(low, high, most)


def draw_graph(panel: Panel, cycle: Cycle, number: int, language: Language) -> Iterator[Primitive]:
    """The graph of a curve of the cycle."""
    yield from _draw_axes(panel)
    upward = panel.upward
    yield Strokes((_span(panel, (0.0, upward.low), (0.0, upward.high)),), _INSTANT)
    curve, instant = cycle.curves[number], cycle.instant[number]
    moved = convert_displacements(cycle.path, curve.moved)
    for part in _cut_off(moved, curve.values, upward):
        yield Outline(tuple(panel.locate(*place) for place in part), FIRM, closed=False)
    if upward.low <= instant <= upward.high:
        yield Disc(panel.locate(0.0, instant), _DOT, None, "black")
    yield from _number_axes(panel, language)


def _draw_axes(panel: Panel) -> Iterator[Strokes]:
    """The axes with a mark at each tick of the lower one, and a thin line across at each of the
    other.
    """
    across, upward = panel.across, panel.upward
    bases = {0.0, upward.low}
    lines = {tick: _span(panel, (across.low, tick), (across.high, tick)) for tick in upward.ticks}
    left = _span(panel, (across.low, upward.low), (across.low, upward.high))
    feet = [panel.locate(tick, upward.low) for tick in across.ticks]
    yield Strokes(tuple(line for tick, line in lines.items() if tick not in bases), _GRID)
    yield Strokes((left, *(line for tick, line in lines.items() if tick in bases)), _AXIS)
    yield Strokes(tuple((foot, foot - Vector(0.0, _TICK_LENGTH)) for foot in feet), _TICK)


def _span(
    panel: Panel, start: tuple[float, float], end: tuple[float, float]
) -> tuple[Vector, Vector]:
    return panel.locate(*start), panel.locate(*end)


def _number_axes(panel: Panel, language: Language) -> Iterator[Label]:
    """The numbers of the ticks."""
    across, upward = panel.across, panel.upward
    for tick in upward.ticks:
        text = upward.write(tick)
        aside = _BESIDE + _measure(text) / 2
        yield _write_number(panel.locate(across.low, tick) - Vector(aside, 0.0), text, language)
    for tick in across.ticks:
        below = panel.locate(tick, upward.low) - Vector(0.0, _BELOW)
        yield _write_number(below, across.write(tick), language)


def _write_number(centre: Vector, text: str, language: Language) -> Label:
    return Label(write_decimals_of_math(text, language), centre, _measure(text), 0.8 * EM)


def _measure(text: str) -> float:
    """Millimetres that a number takes, which is to end beside its axis."""
    return EM * sum(_WIDTHS.get(character, _DIGIT) for character in text)


def _cut_off(moved: Array, values: Array, upward: Axis) -> Iterator[list[tuple[float, float]]]:
    """The parts of a curve between the ends of an axis."""
    inside = (upward.low <= values) & (values <= upward.high)
    part: list[tuple[float, float]] = []
    for number in range(len(moved)):
        leaves = number > 0 and inside[number] != inside[number - 1]
        if leaves and np.isfinite(values[number - 1 : number + 1]).all():
            part.append(
                _cross(moved[number - 1 : number + 1], values[number - 1 : number + 1], upward)
            )
        if inside[number]:
            part.append((float(moved[number]), float(values[number])))
        elif part:
            yield part
            part = []
    if part:
        yield part


def _cross(moved: Array, values: Array, upward: Axis) -> tuple[float, float]:
    """Where a stretch of a curve crosses the end of an axis."""
    bound = upward.high if values.max() > upward.high else upward.low
    share = (bound - values[0]) / (values[1] - values[0])
    return float(moved[0] + share * (moved[1] - moved[0])), bound
