"""A scene as SVG, written directly, for browsers: a millisecond, and no typesetter.

It is black on white whatever the page around it, is self-contained, and holds no script, link or
style sheet.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from html import escape
from math import ceil, cos, pi, sin
from typing import assert_never

from kinegrade.figure.back_ends.required_symbol import require_symbol
from kinegrade.figure.placing.extent import EM
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
from kinegrade.language.math.runs import Run, split_symbol
from kinegrade.mechanics.vector import Vector

FONTS = "Libertinus Serif, STIX Two Text, Times New Roman, Times, Liberation Serif, serif"
_INKS: dict[Ink, str] = {"black": "", "grey": ' stroke="#a6a6a6"'}
_FILLS: dict[Fill, str] = {"none": "", "white": "#fff", "grey": "#e8e8e8", "black": "#000"}
_DASHES: dict[Dash, str] = {
    "solid": "",
    "dashed": "1.06 1.06",
    "dash-dotted": "1.06 .7 .01 .7",
}  # millimetres
CLOSE = "</g>\n</svg>\n"  # the end of a document
_HALF = pi * 0.999  # the longest sweep of one arc, whose two ends must determine its circle


def to_svg(scene: Scene, description: str = "") -> str:
    """An SVG document for the scene, of its width and height in millimetres, with a text that is
    read in its place.

    Raises TypesetError for a label that is not a LaTeX symbol.
    """
    document = _write_document(scene.width, scene.height, scene.primitives)
    if not description:
        return document
    return document.replace("<svg ", f'<svg role="img" aria-label="{escape(description)}" ', 1)


@lru_cache(maxsize=256)
def _write_document(width: float, height: float, primitives: tuple[Primitive, ...]) -> str:
    """The document of a figure, cached; the papers of a class hold many equal figures."""
    return "\n".join((open_document(width, height), write_parts(primitives, height), CLOSE))


def open_document(width: float, height: float) -> str:
    """The beginning of a document of that width and height in millimetres."""
    across, upward = _write_millimetres(width), _write_millimetres(height)
    return "\n".join(
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{across}mm" height="{upward}mm" '
            f'viewBox="0 0 {across} {upward}">',
            f'<rect width="{across}" height="{upward}" fill="#fff"/>',
            '<g fill="none" stroke="#000" stroke-linecap="round" stroke-linejoin="round" '
            f'font-family="{FONTS}" font-size="{_write_millimetres(EM)}">',
        )
    )


def write_parts(primitives: Iterable[Primitive], height: float) -> str:
    """Primitives as elements within a document of that height in millimetres. Raises
    TypesetError.
    """
    return "\n".join(_write_primitive(primitive, height) for primitive in primitives)


def _write_primitive(primitive: Primitive, height: float) -> str:
    """The primitive in SVG's frame, whose y axis points down from the top of the figure."""
    match primitive:
        case Label():
            return _label(primitive, height)
        case Disc(centre, radius):
            place = (
                f'cx="{_write_millimetres(centre.x)}" cy="{_write_millimetres(height - centre.y)}" '
                f'r="{_write_millimetres(radius)}"'
            )
            return f"<circle {place}{_write_style(primitive.pen, primitive.fill)}/>"
        case Strokes():
            path = "".join(_write_polyline(line, height) for line in primitive.lines)
            return f'<path d="{path}"{_write_style(primitive.pen, "none")}/>'
        case Outline():
            path = _write_polyline(primitive.corners, height) + ("Z" if primitive.closed else "")
            return f'<path d="{path}"{_write_style(primitive.pen, primitive.fill)}/>'
        case Bow():
            return (
                f'<path d="{_write_arc(primitive, height)}"{_write_style(primitive.pen, "none")}/>'
            )
        case _:
            assert_never(primitive)


def _write_polyline(corners: tuple[Vector, ...], height: float) -> str:
    first, *rest = (_write_point(corner, height) for corner in corners)
    return f"M{first}" + "".join(f"L{corner}" for corner in rest)


def _write_arc(bow: Bow, height: float) -> str:
    """The arc in parts of less than half a circle each."""
    count = max(1, ceil(abs(bow.sweep) / _HALF))
    ends = [bow.start + bow.sweep * index / count for index in range(count + 1)]
    points = [
        _write_point(bow.centre + Vector(cos(end), sin(end)) * bow.radius, height) for end in ends
    ]
    sense = int(bow.sweep < 0)
    return f"M{points[0]}" + "".join(
        f"A{_write_millimetres(bow.radius)} {_write_millimetres(bow.radius)} 0 0 {sense} {end}"
        for end in points[1:]
    )


@lru_cache(maxsize=64)
def _write_style(pen: Pen | None, fill: Fill) -> str:
    inside = f' fill="{_FILLS[fill]}"' if _FILLS[fill] else ""
    if pen is None:
        return f'{inside} stroke="none"'
    dash = f' stroke-dasharray="{_DASHES[pen.dash]}"' if _DASHES[pen.dash] else ""
    return f'{inside}{_INKS[pen.ink]} stroke-width="{_write_millimetres(pen.width)}"{dash}'


def _label(label: Label, height: float) -> str:
    """The symbol, centred in its box by the actual height and depth of its letters."""
    runs = _write_runs(label.symbol)
    middle = (max(run.top for run in runs) + min(run.bottom for run in runs)) / 2 * EM
    place = (
        f'x="{_write_millimetres(label.centre.x)}" '
        f'y="{_write_millimetres(height - label.centre.y + middle)}"'
    )
    return f'<text {place} text-anchor="middle" fill="#000" stroke="none">{_spans(runs)}</text>'


@lru_cache(maxsize=1024)
def _write_runs(symbol: str) -> tuple[Run, ...]:
    require_symbol(symbol)
    return split_symbol(symbol, "figure.labels")


def write_symbol_spans(symbol: str) -> str:
    """A LaTeX symbol as the content of a text element. Raises TypesetError for another label."""
    return _spans(_write_runs(symbol))


def _spans(runs: tuple[Run, ...]) -> str:
    spans, baseline = [], 0.0
    for run in runs:
        styles = [
            ("dx", _write_millimetres(-run.back * EM) if run.back else ""),
            (
                "dy",
                _write_millimetres((baseline - run.shift) * EM) if run.shift != baseline else "",
            ),
            ("font-size", _write_millimetres(run.size * EM) if run.size != 1 else ""),
            ("font-style", "italic" if run.italic else ""),
            ("font-weight", "bold" if run.bold else ""),
        ]
        written = "".join(f' {name}="{value}"' for name, value in styles if value)
        spans.append(f"<tspan{written}>{escape(run.text)}</tspan>")
        baseline = run.shift
    return "".join(spans)


def _write_point(point: Vector, height: float) -> str:
    return f"{_write_millimetres(point.x)} {_write_millimetres(height - point.y)}"


def _write_millimetres(value: float) -> str:
    """To a hundredth, rounded twice, so that the last bits of a sine, which differ between
    machines, never appear.
    """
    return f"{round(round(value, 6), 2) + 0.0:g}"
