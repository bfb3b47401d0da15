r"""A scene as LaTeX source: one `tikzpicture`, drawn with PGF's basic layer.

The basic layer (`\pgfpathmoveto` and its kin) sets the same figure eight times as fast as TikZ's
own `\draw`, because nothing is parsed; an editor may put `\draw` beside it, in the same
millimetres, where `x=1mm,y=1mm`.
"""

from __future__ import annotations

from itertools import chain
from math import ceil, cos, pi, sin, tan
from typing import assert_never

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
    fill_of,
)
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.symbols import symbol_fault

_FILLS: dict[Fill, str] = {"none": "", "white": "white", "grey": "black!9", "black": "black"}
_DASHES = {"solid": "", "dashed": "{3pt}{3pt}", "dash-dotted": "{3pt}{2pt}{0.01pt}{2pt}"}
# The longest sweep of one Bezier curve: it leaves the circle by 0.03 % of the radius
_BEND = pi / 2


def to_tikz(scene: Scene) -> str:
    r"""LaTeX for the scene: a box of its width and height, its lower edge on the baseline.

    It needs the package tikz and nothing else. Raises TypesetError for a label that is not a LaTeX
    symbol.
    """
    commands = chain.from_iterable(_commands(scene.primitives))
    size = _corner(Vector(scene.width, scene.height))
    return "\n".join(
        (
            r"\begin{tikzpicture}[x=1mm,y=1mm]",
            rf"\pgfpathrectangle{{\pgfpointorigin}}{{{size}}}\pgfusepath{{use as bounding box}}",
            rf"\pgfsetroundcap\pgfsetroundjoin\fontsize{{{FONT_SIZE:g}}}{{{FONT_SIZE:g}}}\selectfont",
            *commands,
            r"\end{tikzpicture}",
        )
    )


def _commands(primitives: tuple[Primitive, ...]) -> list[list[str]]:
    """The commands of each primitive; pen and fill are named only where they change."""
    lines: list[list[str]] = []
    pen: Pen | None = None
    fill: Fill = "none"
    for primitive in primitives:
        match primitive:
            case Label():
                lines.append([_label(primitive)])
            case Strokes() | Outline() | Disc() | Bow():
                chosen, inside = [], fill_of(primitive)
                if primitive.pen and primitive.pen != pen:
                    chosen.append(_pen(primitive.pen, pen))
                    pen = primitive.pen
                if inside not in ("none", fill):
                    chosen.append(rf"\pgfsetfillcolor{{{_FILLS[inside]}}}")
                    fill = inside
                lines.append([*chosen, _path(primitive) + _use(primitive.pen, inside)])
            case _:
                assert_never(primitive)
    return lines


def _pen(pen: Pen, before: Pen | None) -> str:
    width = rf"\pgfsetlinewidth{{{_mm(pen.width)}}}"
    same = pen.dash == (before.dash if before else "solid")
    return width if same else rf"{width}\pgfsetdash{{{_DASHES[pen.dash]}}}{{0pt}}"


def _use(pen: Pen | None, fill: Fill) -> str:
    actions = [
        name for name, wanted in (("fill", fill != "none"), ("stroke", pen is not None)) if wanted
    ]
    return rf"\pgfusepath{{{','.join(actions) or 'discard'}}}"


def _path(primitive: Strokes | Outline | Disc | Bow) -> str:
    match primitive:
        case Disc():
            return rf"\pgfpathcircle{{{_corner(primitive.centre)}}}{{{_mm(primitive.radius)}}}"
        case Strokes():
            return "".join(_polyline(line) for line in primitive.lines)
        case Outline():
            return _polyline(primitive.corners) + (r"\pgfpathclose" if primitive.closed else "")
        case Bow():
            return _arc(primitive)
        case _:
            assert_never(primitive)


def _polyline(corners: tuple[Vector, ...]) -> str:
    first, *rest = corners
    steps = (rf"\pgfpathlineto{{{_corner(corner)}}}" for corner in rest)
    return rf"\pgfpathmoveto{{{_corner(first)}}}" + "".join(steps)


def _arc(bow: Bow) -> str:
    """The arc as Bezier curves, with control points along the tangents."""
    count = max(1, ceil(abs(bow.sweep) / _BEND - 1e-9))
    turn = bow.sweep / count
    reach = bow.radius * 4 / 3 * tan(turn / 4)
    path = rf"\pgfpathmoveto{{{_corner(_on(bow, bow.start))}}}"
    for index in range(count):
        begin, end = bow.start + turn * index, bow.start + turn * (index + 1)
        handles = _on(bow, begin) + _tangent(begin) * reach, _on(bow, end) - _tangent(end) * reach
        path += "\\pgfpathcurveto" + "".join(
            f"{{{_corner(point)}}}" for point in (*handles, _on(bow, end))
        )
    return path


def _on(bow: Bow, angle: float) -> Vector:
    return bow.centre + Vector(cos(angle), sin(angle)) * bow.radius


def _tangent(angle: float) -> Vector:
    return Vector(-sin(angle), cos(angle))


def _label(label: Label) -> str:
    fault = symbol_fault(label.symbol)
    if fault:
        raise TypesetError(f"figure: label: {fault}")
    return rf"\pgftext[at={{{_corner(label.centre)}}}]{{${label.symbol}$}}"


def _corner(point: Vector) -> str:
    return rf"\pgfqpoint{{{_mm(point.x)}}}{{{_mm(point.y)}}}"


def _mm(value: float) -> str:
    """Rounded twice, so that the last bits of a sine, which differ between machines, never
    appear.
    """
    return f"{round(round(value, 6), 3) + 0.0:.6g}mm"
