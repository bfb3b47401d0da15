"""The polygons of vector equations, with the letters of points at their corners."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal

from kinegrade.figure.scene import Outline, Scene
from kinegrade.figure.vectors.chains import Arrow, find_order, find_scale
from kinegrade.figure.vectors.corners import name_origin
from kinegrade.figure.vectors.polygon import draw_polygon
from kinegrade.language.message import Message, list_all
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Part, VectorEquation, is_whole
from kinegrade.numbers.units import read_unit
from kinegrade.worked.case import Case
from kinegrade.worked.document import Picture, Prose
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.measures import NEGLIGIBLE
from kinegrade.worked.formulas.symbols import prime
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import UNITS, name_part


def find_common_scale(stages: Iterable[Stage]) -> float | None:
    """The scale to which all polygons of the steps fit; None where there are none."""
    scales = [
        find_scale(*_list_sides(equation, stage.case))
        for stage in stages
        for equation in stage.equations
        if spans_polygon(equation)
    ]
    return min(scales, default=None)


def spans_polygon(equation: VectorEquation) -> bool:
    """Whether the vectors of an equation make a polygon, rather than the same vector twice, whole
    or in parts.
    """
    sides = equation.left, equation.right
    alike = all(map(is_whole, sides)) and len({part.point for part in equation.parts}) == 1
    return not alike and sum(is_seen(part.value) for part in equation.parts) > 2


def draw_equation(equation: VectorEquation, stage: Stage, scale: float | None) -> Picture:
    """The polygon of a vector equation, to a scale that its caption states."""
    case = stage.case
    sides = _list_sides(order_vectors(equation, case), case)
    vertices = _name_vertices(equation, case)
    shown = (draw_polygon, *map(tuple, sides), tuple(vertices.items()), scale)
    scene = case.drawings.find(shown, lambda: draw_polygon(*sides, vertices, scale))
    scale_words = Message(
        f"solution.polygon-{stage.level}",
        scale=Decimal(f"{1 / scene.scale:.3g}"),
        unit=read_unit(case.notation.name(UNITS[stage.level, False])).printed,
    )
    symbols = [arrow.symbol for side in sides for arrow in side]
    caption = _explain_outlines(scene, scale_words)
    return replace(describe(scene, caption, symbols, case), kind="polygon")


def _explain_outlines(scene: Scene, caption: Message) -> Message:
    """The caption with what an arrow means that is drawn as an outline, without a filling."""
    outlines = (part for part in scene.primitives if isinstance(part, Outline))
    hollow = [part for part in outlines if part.fill == "none"]
    if not hollow:
        return caption
    if len(hollow) > 1:
        return Message("solution.picture-outlines", picture=caption)
    return Message("solution.picture-outlined", picture=caption)


def describe(scene: Scene, caption: Message, symbols: Iterable[str], case: Case) -> Picture:
    """A drawing of vectors with its caption, which names those that are too short to be drawn: an
    arrow without them would be taken for the sum that it leads to.
    """
    drawn = {label.symbol for label in scene.labels}
    short = [f"${symbol}$" for symbol in symbols if symbol not in drawn]
    if short:
        caption = Message("solution.picture-without", picture=caption, short=list_all(short))
    return Picture(scene, case.write(caption))


def order_vectors(equation: VectorEquation, case: Case) -> VectorEquation:
    """The equation with its vectors in the order in which its polygon is readable: as they stand,
    unless some would run along others. Vectors too small to be drawn keep their places.
    """
    vertices = _name_vertices(equation, case)
    left, right = find_order(*_list_sides(equation, case), vertices)
    return replace(
        equation, left=_reorder(equation.left, left), right=_reorder(equation.right, right)
    )


def _reorder(parts: Sequence[Part], order: Sequence[int]) -> tuple[Part, ...]:
    """The parts with those that are drawn in another order."""
    seen = [part for part in parts if is_seen(part.value)]
    following = (seen[place] for place in order)
    return tuple(next(following) if is_seen(part.value) else part for part in parts)


def _list_sides(equation: VectorEquation, case: Case) -> tuple[list[Arrow], list[Arrow]]:
    left, right = (_list_arrows(side, equation, case) for side in (equation.left, equation.right))
    return left, right


def _list_arrows(side: Iterable[Part], equation: VectorEquation, case: Case) -> list[Arrow]:
    return [
        Arrow(
            case.text(name_part(equation, part, case)),
            part.value.map(float),
            part.unknown is None,
        )
        for part in side
        if is_seen(part.value)
    ]


def _name_vertices(equation: VectorEquation, case: Case) -> dict[str, Vector]:
    """The letters of the points of whose velocities or accelerations the tips are corners of the
    polygon: of a base point, of the point of a moving frame, of the point itself.
    """
    vertices: dict[str, Vector] = {}
    for side in (equation.left, equation.right):
        reached = Vector(0.0, 0.0)
        for part in side:
            if part.role == "rotation" and part.base:
                vertices.setdefault(_write_small(case.naming.letter(part.base), case), reached)
            if part.role == "relative":
                vertices.setdefault(name_shared_corner(part, equation, case), reached)
            reached = reached + part.value.map(float)
        if side and not side[-1].coincident:
            vertices.setdefault(_write_small(case.naming.letter(side[-1].point), case), reached)
    return vertices


def name_shared_corner(relative: Part, equation: VectorEquation, case: Case) -> str:
    """The letter of the moving frame's point at which the point of a composition is: b' of B, and
    b'' in the second frame of the same point.
    """
    same = (each for each in equation.compositions if each.point == relative.point)
    frames = list(dict.fromkeys(each.frame for each in same))
    letter = case.naming.letter(relative.point)
    for _ in range(frames.index(relative.frame) + 1):
        letter = prime(letter)
    return _write_small(letter, case)


def explain_corners(equation: VectorEquation, case: Case) -> Iterator[Prose]:
    """What the letters of points in a polygon mark, said once for each letter of its origin."""
    vertices = _name_vertices(equation, case)
    origin = name_origin(vertices)
    if vertices and origin not in case.findings.corners:
        case.findings.corners.add(origin)
        yield replace(case.say(Message("solution.corners", origin=origin)), on_polygon=True)


def has_corner(letter: str, equation: VectorEquation, case: Case) -> bool:
    """Whether a letter stands at a corner of the polygon of an equation."""
    place = _name_vertices(order_vectors(equation, case), case).get(letter)
    return place is not None and is_seen(place)


def _write_small(letter: Symbol, case: Case) -> str:
    return write_corner(case.text(letter))


def write_corner(letter: str) -> str:
    """A point's letter as a small one, as corners of polygons have."""
    return letter[:1].lower() + letter[1:]


def is_seen(vector: Vector) -> bool:
    """Whether a vector is large enough to draw, and not the rounding error of a zero."""
    return max(abs(float(vector.x)), abs(float(vector.y))) > NEGLIGIBLE
