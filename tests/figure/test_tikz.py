"""The TikZ back end's own ways: arcs as curves, pens named where they change, labels at their
centres.
"""

from __future__ import annotations

import re
from math import hypot, pi

from kinegrade.figure.back_ends.tikz import write_tikz
from kinegrade.figure.scene import BOLD, PITCH, THIN, Bow, Disc, Label, Outline, Scene, Strokes
from kinegrade.mechanics.vector import Vector

ORIGIN = Vector(0.0, 0.0)


def drawn(*primitives: Strokes | Outline | Disc | Bow | Label) -> str:
    return write_tikz(Scene(30.0, 20.0, 1.0, primitives))


def points_of(text: str) -> list[tuple[float, float]]:
    found = re.findall(r"\\pgfqpoint\{([-\d.]+)mm\}\{([-\d.]+)mm\}", text)
    return [(float(x), float(y)) for x, y in found]


def test_the_picture_has_the_size_of_the_scene() -> None:
    source = drawn()
    assert source.startswith("\\begin{tikzpicture}")
    assert (
        "\\pgfpathrectangle{\\pgfpointorigin}{\\pgfqpoint{30mm}{20mm}}\\pgfusepath{use as bounding "
        "box}" in source
    )


def test_a_pen_is_named_where_it_changes() -> None:
    line = ((ORIGIN, Vector(1.0, 0.0)),)
    source = drawn(
        Strokes(line, BOLD), Strokes(line, BOLD), Strokes(line, PITCH), Strokes(line, THIN)
    )
    assert [line for line in source.split("\n") if line.startswith(r"\pgfsetlinewidth")] == [
        r"\pgfsetlinewidth{0.8mm}",
        r"\pgfsetlinewidth{0.18mm}\pgfsetdash{{3pt}{2pt}{0.01pt}{2pt}}{0pt}",
        r"\pgfsetlinewidth{0.18mm}\pgfsetdash{}{0pt}",
    ]


def test_an_arc_is_made_of_curves_that_stay_on_the_circle() -> None:
    source = drawn(Bow(Vector(10.0, 10.0), 5.0, 0.3, 1.5 * pi, THIN))
    (begin, *rest) = points_of(source.split("\\pgfpathmoveto")[1])
    assert len(rest) == 9
    before = begin
    for first, second, end in zip(rest[::3], rest[1::3], rest[2::3], strict=True):
        middle = [
            (a + 3 * b + 3 * c + d) / 8
            for a, b, c, d in zip(before, first, second, end, strict=True)
        ]
        assert abs(hypot(middle[0] - 10, middle[1] - 10) - 5) < 0.005
        assert abs(hypot(end[0] - 10, end[1] - 10) - 5) < 0.002
        before = end


def test_fills_and_outlines() -> None:
    square = (ORIGIN, Vector(1.0, 0.0), Vector(1.0, 1.0))
    source = drawn(
        Outline(square, THIN, "white"),
        Outline(square, None, "black"),
        Outline(square, THIN, closed=False),
        Disc(ORIGIN, 0.5, THIN, "grey"),
        Outline(square, None),
    )
    assert re.findall(r"\\pgfusepath\{([^}]*)\}", source)[1:] == [
        "fill,stroke",
        "fill",
        "stroke",
        "fill,stroke",
        "discard",
    ]
    assert re.findall(r"\\pgfsetfillcolor\{([^}]*)\}", source) == ["white", "black", "black!9"]
    assert source.count("\\pgfpathclose") == 3


def test_a_label_stands_at_its_centre() -> None:
    source = drawn(Label(r"\omega_{AB}", Vector(3.0, 4.0), 5.0, 3.0))
    assert r"\pgftext[at={\pgfqpoint{3mm}{4mm}}]{$\omega_{AB}$}" in source
