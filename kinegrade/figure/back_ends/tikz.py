r"""A scene as LaTeX source: one `tikzpicture`, drawn with PGF's basic layer.

The basic layer (`\pgfpathmoveto` and its kin) sets the same figure eight times as fast as TikZ's
own `\draw`, because nothing is parsed; an editor may put `\draw` beside it, in the same
millimetres, where `x=1mm,y=1mm`.
"""

from __future__ import annotations

from itertools import chain
from math import ceil, cos, pi, sin, tan
from typing import assert_never

from kinegrade.figure.back_ends.required_symbol import require_symbol
from kinegrade.figure.placing.extent import FONT_SIZE
from kinegrade.figure.scene import (
    Bow,
    Disc,
    Fill,
    Ink,
    Label,
    Outline,
    Pen,
    Primitive,
    Scene,
    Strokes,
    find_fill,
)
from kinegrade.language.math.latex import write_latex_math
from kinegrade.mechanics.vector import Vector

_INKS: dict[Ink, str] = {"black": "black", "grey": "black!35"}
_FILLS: dict[Fill, str] = {"none": "", "white": "white", "grey": "black!9", "black": "black"}
_DASHES = {"solid": "", "dashed": "{3pt}{3pt}", "dash-dotted": "{3pt}{2pt}{0.01pt}{2pt}"}
# The longest sweep of one Bezier curve: it leaves the circle by 0.03 % of the radius
_BEND = pi / 2


def write_tikz(scene: Scene) -> str:
    r"""LaTeX for the scene: a box of its width and height, its lower edge on the baseline.

    It needs the package tikz and nothing else. Raises TypesetError for a label that is not a LaTeX
    symbol.
    """
    commands = chain.from_iterable(_write_commands(scene.primitives))
    size = _write_corner(Vector(scene.width, scene.height))
    return "\n".join(
        (
            r"\begin{tikzpicture}[x=1mm,y=1mm]",
            rf"\pgfpathrectangle{{\pgfpointorigin}}{{{size}}}\pgfusepath{{use as bounding box}}",
            r"\pgfsetroundcap\pgfsetroundjoin"
            rf"\fontsize{{{FONT_SIZE:g}}}{{{FONT_SIZE:g}}}\selectfont",
            *commands,
            r"\end{tikzpicture}",
        )
    )


def _write_commands(primitives: tuple[Primitive, ...]) -> list[list[str]]:
    """The commands of each primitive; pen and fill are named only where they change."""
    lines: list[list[str]] = []
    pen: Pen | None = None
    fill: Fill = "none"
    for primitive in primitives:
        match primitive:
            case Label():
                lines.append([_write_label(primitive)])
            case Strokes() | Outline() | Disc() | Bow():
                chosen, inside = [], find_fill(primitive)
                if primitive.pen and primitive.pen != pen:
                    chosen.append(_write_pen(primitive.pen, pen))
                    pen = primitive.pen
                if inside not in ("none", fill):
                    chosen.append(rf"\pgfsetfillcolor{{{_FILLS[inside]}}}")
                    fill = inside
                lines.append([*chosen, _write_path(primitive) + _write_use(primitive.pen, inside)])
            case _:
                assert_never(primitive)
    return lines


def _write_pen(pen: Pen, before: Pen | None) -> str:
    width = rf"\pgfsetlinewidth{{{_write_millimetres(pen.width)}}}"
    if pen.ink != (before.ink if before else "black"):
        width += rf"\pgfsetstrokecolor{{{_INKS[pen.ink]}}}"
    same = pen.dash == (before.dash if before else "solid")
    return width if same else rf"{width}\pgfsetdash{{{_DASHES[pen.dash]}}}{{0pt}}"


def _write_use(pen: Pen | None, fill: Fill) -> str:
    actions = [
        name for name, wanted in (("fill", fill != "none"), ("stroke", pen is not None)) if wanted
    ]
    return rf"\pgfusepath{{{','.join(actions) or 'discard'}}}"


def _write_path(primitive: Strokes | Outline | Disc | Bow) -> str:
    match primitive:
        case Disc():
            return (
                rf"\pgfpathcircle{{{_write_corner(primitive.centre)}}}{{"
                rf"{_write_millimetres(primitive.radius)}}}"
            )
        case Strokes():
            return "".join(_write_polyline(line) for line in primitive.lines)
        case Outline():
            return _write_polyline(primitive.corners) + (
                r"\pgfpathclose" if primitive.closed else ""
            )
        case Bow():
            return _write_arc(primitive)
        case _:
            assert_never(primitive)


def _write_polyline(corners: tuple[Vector, ...]) -> str:
    first, *rest = corners
    steps = (rf"\pgfpathlineto{{{_write_corner(corner)}}}" for corner in rest)
    return rf"\pgfpathmoveto{{{_write_corner(first)}}}" + "".join(steps)


def _write_arc(bow: Bow) -> str:
    """The arc as Bezier curves, with control points along the tangents."""
    count = max(1, ceil(abs(bow.sweep) / _BEND - 1e-9))
    turn = bow.sweep / count
    reach = bow.radius * 4 / 3 * tan(turn / 4)
    path = rf"\pgfpathmoveto{{{_write_corner(_find_point_on_arc(bow, bow.start))}}}"
    for index in range(count):
        begin, end = bow.start + turn * index, bow.start + turn * (index + 1)
        handles = (
            _find_point_on_arc(bow, begin) + _find_tangent(begin) * reach,
            _find_point_on_arc(bow, end) - _find_tangent(end) * reach,
        )
        path += "\\pgfpathcurveto" + "".join(
            f"{{{_write_corner(point)}}}" for point in (*handles, _find_point_on_arc(bow, end))
        )
    return path


def _find_point_on_arc(bow: Bow, angle: float) -> Vector:
    return bow.centre + Vector(cos(angle), sin(angle)) * bow.radius


def _find_tangent(angle: float) -> Vector:
    return Vector(-sin(angle), cos(angle))


def _write_label(label: Label) -> str:
    require_symbol(label.symbol)
    symbol = write_latex_math(label.symbol, "figure.labels")
    return rf"\pgftext[at={{{_write_corner(label.centre)}}}]{{${symbol}$}}"


def _write_corner(point: Vector) -> str:
    return rf"\pgfqpoint{{{_write_millimetres(point.x)}}}{{{_write_millimetres(point.y)}}}"


def _write_millimetres(value: float) -> str:
    """Rounded twice, so that the last bits of a sine, which differ between machines, never
    appear.
    """
    return f"{round(round(value, 6), 3) + 0.0:.6g}mm"
