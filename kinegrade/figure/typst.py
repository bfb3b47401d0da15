"""A scene as Typst source: one self-contained box, drawn with Typst's own primitives."""

from __future__ import annotations

import re

import tylax

from kinegrade.errors import TypesetError
from kinegrade.figure.extent import FONT_SIZE
from kinegrade.figure.scene import (
    Bow,
    Disc,
    Fill,
    Label,
    Outline,
    Pen,
    Primitive,
    Scene,
    Strokes,
    moved,
)
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.hints import symbol_fault

_FILLS: dict[Fill, str] = {"none": "none", "white": "white", "grey": "luma(91%)", "black": "black"}


def to_typst(scene: Scene) -> str:
    """Typst markup for the scene: a box of its width and height.

    Raises TypesetError for a label that is no LaTeX symbol.
    """
    lines = [_write(_downward(primitive, scene.height)) for primitive in scene.primitives]
    body = "\n".join(f"  {line}" for line in lines)
    size = f"width: {_mm(scene.width)}, height: {_mm(scene.height)}"
    return f"#box({size}, {{\n  set text(size: {FONT_SIZE:g}pt)\n  set par(leading: 0pt)\n{body}\n}})"


def math_to_typst(symbol: str) -> str:
    """A LaTeX symbol as Typst math with its dollar signs.

    Raises TypesetError when it is none (nothing else may reach the typesetter).

    >>> math_to_typst("O_1")
    '$O_(1)$'
    """
    fault = symbol_fault(symbol)
    if fault:
        raise TypesetError(f"figure: label: {fault}")
    primes = re.sub(r"'+", lambda found: "^{" + r"\prime " * len(found.group()) + "}", symbol)
    return str(tylax.latex_to_typst(f"${primes}$"))


def _write(primitive: Primitive) -> str:
    if isinstance(primitive, Label):
        return _write_label(primitive)
    if isinstance(primitive, Disc):
        corner = primitive.centre - Vector(primitive.radius, primitive.radius)
        circle = f"circle(radius: {_mm(primitive.radius)}, {_style(primitive.pen, primitive.fill)})"
        return f"place(dx: {_mm(corner.x)}, dy: {_mm(corner.y)}, {circle})"
    if isinstance(primitive, Strokes):
        steps = [f"curve.move({_at(start)}), curve.line({_at(end)})" for start, end in primitive.lines]
        return f"place(curve({_style(primitive.pen, 'none')}, {', '.join(steps)}))"
    outline = (
        Outline(primitive.path(), primitive.pen, closed=False) if isinstance(primitive, Bow) else primitive
    )
    first, *rest = outline.corners
    steps = [f"curve.move({_at(first)})", *(f"curve.line({_at(corner)})" for corner in rest)]
    closing = ['curve.close(mode: "straight")'] if outline.closed else []
    return f"place(curve({_style(outline.pen, outline.fill)}, {', '.join(steps + closing)}))"


def _write_label(label: Label) -> str:
    corner = label.centre - Vector(label.width, label.height) / 2
    size = f"width: {_mm(label.width)}, height: {_mm(label.height)}"
    box = f"box({size}, align(center + horizon, box({math_to_typst(label.symbol)})))"
    return f"place(dx: {_mm(corner.x)}, dy: {_mm(corner.y)}, {box})"


def _downward(primitive: Primitive, height: float) -> Primitive:
    """The primitive in Typst's frame, whose y axis points down from the top."""
    if isinstance(primitive, Strokes):
        lines = tuple((_flip(start, height), _flip(end, height)) for start, end in primitive.lines)
        return Strokes(lines, primitive.pen)
    if isinstance(primitive, Bow):
        path = tuple(_flip(point, height) for point in primitive.path())
        return Outline(path, primitive.pen, closed=False)
    if isinstance(primitive, Outline):
        path = tuple(_flip(corner, height) for corner in primitive.corners)
        return Outline(path, primitive.pen, primitive.fill, primitive.closed)
    return moved(primitive, _flip(primitive.centre, height) - primitive.centre)


def _flip(point: Vector, height: float) -> Vector:
    return Vector(point.x, height - point.y)


def _style(pen: Pen | None, fill: Fill) -> str:
    return f"stroke: {_stroke(pen)}, fill: {_FILLS[fill]}"


def _stroke(pen: Pen | None) -> str:
    if pen is None:
        return "none"
    dash = "" if pen.dash == "solid" else f', dash: "{pen.dash}"'
    return f'(thickness: {_mm(pen.width)}, cap: "round", join: "round"{dash})'


def _at(point: Vector) -> str:
    return f"({_mm(point.x)}, {_mm(point.y)})"


def _mm(value: float) -> str:
    """Rounded twice, so that the last bits of a sine, which differ between machines, never show."""
    return f"{round(round(value, 6), 3) + 0.0:g}mm"
