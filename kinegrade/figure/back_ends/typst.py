"""A scene as Typst source: one self-contained box, drawn by Typst itself, or faster with an SVG
picture in it.
"""

from __future__ import annotations

from functools import lru_cache
from math import sqrt
from typing import assert_never

from kinegrade.figure.back_ends.required_symbol import require_symbol
from kinegrade.figure.back_ends.svg import to_svg
from kinegrade.figure.placing.extent import FONT_SIZE
from kinegrade.figure.scene import (
    Bow,
    Dash,
    Disc,
    Fill,
    Ink,
    Label,
    Outline,
    Pen,
    Primitive,
    Scene,
    Strokes,
)
from kinegrade.language.math.typst.formula import write_typst_math
from kinegrade.mechanics.vector import Vector

_DASHES: dict[Dash, str] = {
    "solid": "",
    "dashed": ', dash: "dashed"',
    "dash-dotted": ', dash: "dash-dotted"',
}
_SAGITTA = 0.02  # millimetres that the chords of an arc leave it at most
_INKS: dict[Ink, str] = {"black": "", "grey": ", paint: luma(65%)"}
_FILLS: dict[Fill, str] = {"none": "none", "white": "white", "grey": "luma(91%)", "black": "black"}


def write_typst(scene: Scene) -> str:
    """Typst markup for the scene: a box of its width and height.

    Raises TypesetError for a label that is not a LaTeX symbol.
    """
    return _write_box(scene.width, scene.height, scene.primitives)


@lru_cache(maxsize=256)
def _write_box(width: float, height: float, primitives: tuple[Primitive, ...]) -> str:
    """The box of a figure, cached; the papers of a class hold many equal figures."""
    lines = [_write(primitive, height) for primitive in primitives]
    body = "\n".join(f"  {line}" for line in lines)
    size = f"width: {_write_millimetres(width)}, height: {_write_millimetres(height)}"
    return (
        f"#box({size}, {{\n  set text(size: {FONT_SIZE:g}pt)\n  set par(leading: 0pt)\n{body}\n}})"
    )


def write_typst_picture(scene: Scene) -> str:
    """The same box with the lines as one SVG picture and the symbols over it: Typst sets it three
    times as fast.

    Raises TypesetError for a label that is not a LaTeX symbol.
    """
    return _write_picture(scene.width, scene.height, scene.primitives)


@lru_cache(maxsize=256)
def _write_picture(width: float, height: float, primitives: tuple[Primitive, ...]) -> str:
    """The picture in its box, hidden from screen readers, as lines are; labels are topmost in every
    scene.
    """
    lines = tuple(primitive for primitive in primitives if not isinstance(primitive, Label))
    drawing = to_svg(Scene(width, height, 1.0, lines)).replace('"', "'")
    symbols = "\n".join(
        f"  {_write_label(label, height)}" for label in primitives if isinstance(label, Label)
    )
    size = f"width: {_write_millimetres(width)}, height: {_write_millimetres(height)}"
    return (
        f"#box({size}, {{\n  set text(size: {FONT_SIZE:g}pt)\n  set par(leading: 0pt)\n"
        f'  place(pdf.artifact(image(bytes("{drawing}"), format: "svg", {size})))\n{symbols}\n}})'
    )


@lru_cache(maxsize=1024)
def translate_symbol(symbol: str) -> str:
    """A LaTeX symbol as Typst math with its dollar signs.

    Raises TypesetError for anything else (only symbols may reach the typesetter).

    >>> translate_symbol("O_1")
    '$O_(1)$'
    """
    require_symbol(symbol)
    return f"${write_typst_math(symbol, 'figure.labels')}$"


def _write(primitive: Primitive, height: float) -> str:
    """The primitive in Typst's frame, whose y axis points down from the top of the figure."""
    match primitive:
        case Label():
            return _write_label(primitive, height)
        case Disc(centre=centre, radius=radius):
            corner = _write_position(centre.x - radius, height - centre.y - radius)
            style = _write_style(primitive.pen, primitive.fill)
            return f"{corner}, circle(radius: {_write_millimetres(radius)}, {style}))"
        case Strokes():
            steps = [
                (
                    f"curve.move({_write_point(start, height)}), "
                    f"curve.line({_write_point(end, height)})"
                )
                for start, end in primitive.lines
            ]
            return f"place(curve({_write_style(primitive.pen, 'none')}, {', '.join(steps)}))"
        case Bow():
            path = primitive.path(min(0.17, sqrt(8 * _SAGITTA / primitive.radius)))
            return _write_outline(Outline(path, primitive.pen, closed=False), height)
        case Outline():
            return _write_outline(primitive, height)
        case _:
            assert_never(primitive)


def _write_outline(outline: Outline, height: float) -> str:
    first, *rest = (_write_point(corner, height) for corner in outline.corners)
    steps = [f"curve.move({first})", *(f"curve.line({corner})" for corner in rest)]
    closing = ['curve.close(mode: "straight")'] if outline.closed else []
    return f"place(curve({_write_style(outline.pen, outline.fill)}, {', '.join(steps + closing)}))"


def _write_label(label: Label, height: float) -> str:
    corner = _write_position(
        label.centre.x - label.width / 2, height - label.centre.y - label.height / 2
    )
    size = f"width: {_write_millimetres(label.width)}, height: {_write_millimetres(label.height)}"
    return f"{corner}, box({size}, align(center + horizon, box({translate_symbol(label.symbol)}))))"


@lru_cache(maxsize=64)
def _write_style(pen: Pen | None, fill: Fill) -> str:
    return f"stroke: {_write_stroke(pen)}, fill: {_FILLS[fill]}"


def _write_stroke(pen: Pen | None) -> str:
    if pen is None:
        return "none"
    more = _DASHES[pen.dash] + _INKS[pen.ink]
    return f'(thickness: {_write_millimetres(pen.width)}, cap: "round", join: "round"{more})'


def _write_position(across: float, downward: float) -> str:
    return f"place(dx: {_write_millimetres(across)}, dy: {_write_millimetres(downward)}"


def _write_point(point: Vector, height: float) -> str:
    return f"({_write_millimetres(point.x)}, {_write_millimetres(height - point.y)})"


def _write_millimetres(value: float) -> str:
    """Rounded twice, so that the last bits of a sine, which differ between machines, never
    appear.
    """
    return f"{round(round(value, 6), 3) + 0.0:g}mm"
