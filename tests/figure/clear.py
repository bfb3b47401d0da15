"""What may be asked of every picture: symbols apart from each other and from bold lines, everything
on the paper.
"""

from __future__ import annotations

from itertools import combinations

from kinegrade.figure.placing.obstacles import Obstacles
from kinegrade.figure.scene import BOLD, Box, Disc, Label, Outline, Pen, Scene, Strokes, find_box
from kinegrade.mechanics.vector import Vector


def faults(scene: Scene, width: float, height: float) -> list[str]:
    """What is wrong with a picture, in words; nothing as a rule."""
    pairs = combinations(scene.labels, 2)
    found = [
        f"{one.symbol} on {other.symbol}"
        for one, other in pairs
        if overlap(find_box(one), find_box(other))
    ]
    lines = [part for part in scene.primitives if not isinstance(part, Label) and part.pen]
    bold = Obstacles.of(part for part in lines if part.pen and part.pen.width >= BOLD.width)
    for label in scene.labels:
        if bold.under_box(*label.centre, label.width, label.height):
            found.append(f"{label.symbol} on a bold line")
    for part in scene.primitives:
        box = find_box(part)
        if min(box.left, box.bottom) < -1e-6 or box.right > width + 1e-6 or box.top > height + 1e-6:
            found.append(f"{part} beyond the paper")
    return found


def overlap(one: Box, other: Box) -> bool:
    """Whether two boxes share any area."""
    across = one.left < other.right and other.left < one.right
    return across and one.bottom < other.top and other.bottom < one.top


def symbols(scene: Scene) -> list[str]:
    return sorted(label.symbol for label in scene.labels)


def lines(scene: Scene, pen: Pen) -> list[tuple[Vector, Vector]]:
    return [
        line
        for part in scene.primitives
        if isinstance(part, Strokes) and part.pen == pen
        for line in part.lines
    ]


def heads(scene: Scene, fill: str = "black") -> list[Outline]:
    """The arrowheads; the first corner is the tip."""
    outlines = (part for part in scene.primitives if isinstance(part, Outline))
    return [
        part for part in outlines if part.fill == fill and len(part.corners) == 3 and part.closed
    ]


def dots(scene: Scene) -> list[Vector]:
    return [
        part.centre for part in scene.primitives if isinstance(part, Disc) and part.fill == "black"
    ]
