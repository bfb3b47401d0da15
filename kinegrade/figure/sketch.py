"""From a mechanism to its figure: `sketch` is the way in, `typst` (and its siblings) the way out."""

from __future__ import annotations

from kinegrade.figure.layers import draw
from kinegrade.figure.marks import marks
from kinegrade.figure.names import wishes
from kinegrade.figure.paper import to_paper
from kinegrade.figure.place import Obstacles, Wish, around, place
from kinegrade.figure.rims import rims
from kinegrade.figure.scene import (
    THIN,
    Box,
    Primitive,
    Scene,
    Strokes,
    box_around,
    moved,
)
from kinegrade.figure.symbols import arrowhead
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.hints import FigureHints

WIDTH, HEIGHT = 75.0, 55.0  # millimetres a figure may take
SURROUND = 14.0  # millimetres that symbols and labels take beside the mechanism, as a first guess
ATTEMPTS = 6
PLAIN = FigureHints()


def sketch(mechanism: Mechanism, hints: FigureHints = PLAIN) -> Scene:
    """The figure of a mechanism whose numbers are floats in metres: to scale, within WIDTH x HEIGHT.

    Raises TemplateError for a hint about something that the mechanism does not have.
    """
    span = _span(mechanism, hints)
    scale = min((WIDTH - SURROUND) / max(span[0], 1e-9), (HEIGHT - SURROUND) / max(span[1], 1e-9))
    primitives = _compose(mechanism, hints, scale)
    for _ in range(ATTEMPTS):
        box = box_around(primitives)
        if box.width <= WIDTH and box.height <= HEIGHT:
            break
        scale *= min(_shrink(box.width, WIDTH, span[0] * scale), _shrink(box.height, HEIGHT, span[1] * scale))
        primitives = _compose(mechanism, hints, scale)
    return _trimmed(primitives, scale)


def _compose(mechanism: Mechanism, hints: FigureHints, scale: float) -> tuple[Primitive, ...]:
    """Mechanism, then marks, then labels, each against what is already there."""
    paper = to_paper(mechanism, scale)
    drawing = draw(paper, hints.shapes)
    drawn = Obstacles(drawing.primitives)
    marked, mark_wishes = marks(paper, hints, drawing, drawn)
    lines = (*drawing.primitives, *marked)
    frame, frame_wishes = _axes(box_around(lines)) if hints.axes else ((), ())
    wanted = (*mark_wishes, *frame_wishes, *wishes(paper, hints, drawing))
    return (*lines, *frame, *place(wanted, drawn.with_drawn((*marked, *frame))))


def _axes(box: Box) -> tuple[tuple[Primitive, ...], tuple[Wish, ...]]:
    """A small frame x, y at the lower left, outside everything else."""
    corner, reach = Vector(box.left - 4.0, box.bottom - 1.0), 7.0
    ends = {"x": corner + Vector(reach, 0.0), "y": corner + Vector(0.0, reach)}
    lines = Strokes(tuple((corner, end) for end in ends.values()), THIN)
    heads = (arrowhead(ends["x"], Vector(1.0, 0.0)), arrowhead(ends["y"], Vector(0.0, 1.0)))
    labels = (
        Wish("x", around("x", ends["x"])),
        Wish("y", around("y", ends["y"])),
    )
    return (lines, *heads), labels


def _span(mechanism: Mechanism, hints: FigureHints) -> tuple[float, float]:
    """Width and height in metres of what scales: points and circles, but no cam's circle of curvature."""
    boxes = [(point, 0.0) for point in mechanism.points.values()]
    boxes += [(rim.at, rim.radius) for rim in rims(mechanism, hints.shapes) if rim.kind != "cam"]
    across = [at.x + side * radius for at, radius in boxes for side in (-1, 1)]
    upward = [at.y + side * radius for at, radius in boxes for side in (-1, 1)]
    return max(across) - min(across), max(upward) - min(upward)


def _shrink(size: float, limit: float, scaled: float) -> float:
    """The factor that brings a size within its limit when only its scaled part shrinks."""
    if size <= limit or scaled <= 0:
        return 1.0
    return min(0.98, max(0.5, (limit - (size - scaled)) / scaled))


def _trimmed(primitives: tuple[Primitive, ...], scale: float) -> Scene:
    box = box_around(primitives)
    home = Vector(-box.left, -box.bottom)
    return Scene(box.width, box.height, scale, tuple(moved(primitive, home) for primitive in primitives))
