"""The pictures of a step: the mechanism with its vectors, the polygon of the equation, the
construction of a pole.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from decimal import Decimal

from kinegrade.figure.vectors.mechanism import PointArrow, draw_with_vectors
from kinegrade.figure.vectors.pole_construction import Pole, draw_pole_construction
from kinegrade.figure.vectors.polygon import Arrow, draw_polygon
from kinegrade.language.math.tree import Text, list_nodes
from kinegrade.language.message import Message
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.vector import Vector
from kinegrade.mechanics.vector_equation import Level, Part, VectorEquation
from kinegrade.problem.template.hints import Turning
from kinegrade.worked.case import Case
from kinegrade.worked.document import Picture, Pictures
from kinegrade.worked.formulas.atoms import Symbol
from kinegrade.worked.formulas.measures import NEGLIGIBLE
from kinegrade.worked.formulas.symbols import prime
from kinegrade.worked.steps.couplers import choose_method, find_coupler
from kinegrade.worked.steps.poles import name_pole
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import name_part


def draw_stage(stage: Stage) -> Iterator[Pictures]:
    """The pictures of a step: the mechanism with its vectors and the polygon, or the construction
    of a pole; none where no vectors are added.
    """
    coupler = find_coupler(stage)
    if coupler is not None and choose_method(coupler, stage.case) == "pole":
        rays = tuple(
            _find_point_arrows((coupler.base, coupler.point), coupler.equation, stage.case)
        )
        yield Pictures((_draw_pole(coupler.body, rays, stage.case),))
        return
    added = [equation for equation in stage.equations if _spans(equation)]
    if added:
        polygons = (_draw_equation(equation, stage) for equation in added)
        yield Pictures((_draw_vectors(stage.equations, stage), *polygons))


def _spans(equation: VectorEquation) -> bool:
    """Whether the vectors of an equation make a polygon, rather than the same vector twice."""
    return sum(_is_seen(part.value) for part in equation.parts) > 2


def _draw_vectors(equations: Sequence[VectorEquation], stage: Stage) -> Picture:
    """The mechanism with all vectors of the step at their points, and the rotations that the step
    gives.
    """
    case = stage.case
    mechanism = case.motion.frames.mechanism.map(float)
    arrows = {
        (arrow.symbol, arrow.at): arrow
        for equation in equations
        for arrow in _find_point_arrows(equation.parts, equation, case)
    }
    rates = dict.fromkeys(rate for equation in equations for rate in equation.unknowns)
    scene = draw_with_vectors(
        mechanism,
        case.template.figure,
        tuple(arrows.values()),
        _find_turnings(rates, case, stage.level),
    )
    return Picture(scene, _name_picture(stage.level, case))


def _find_point_arrows(
    parts: Iterable[Part], equation: VectorEquation, case: Case
) -> Iterator[PointArrow]:
    """The parts that do not vanish, each at its point."""
    for part in parts:
        if _is_seen(part.value):
            at = _make_floats(case.motion.points[part.point])
            yield PointArrow(
                case.text(name_part(equation, part, case)),
                at,
                _make_floats(part.value),
                part.unknown is None,
            )


def _find_turnings(rates: Iterable[Rate], case: Case, level: Level) -> tuple[Turning, ...]:
    """The rotations that a step gives, in their sense."""
    values = case.rates(level)
    return tuple(
        Turning(
            case.text(case.naming.turning(rate.body, level)),
            rate.body,
            "ccw" if float(values[rate]) > 0 else "cw",
        )
        for rate in rates
        if rate.kind == "turning" and float(values[rate]) and _is_short(rate, level, case)
    )


def _is_short(rate: Rate, level: Level, case: Case) -> bool:
    """Whether the symbol of a rotation has letters only, and no words that a figure has no room
    for.
    """
    symbol = case.naming.turning(rate.body, level)
    return not any(isinstance(node, Text) for node in list_nodes(symbol.row))


def _draw_equation(equation: VectorEquation, stage: Stage) -> Picture:
    """The polygon of a vector equation, to a scale that its caption states."""
    case = stage.case
    left, right = (_list_arrows(side, equation, case) for side in (equation.left, equation.right))
    scene = draw_polygon(left, right, _name_vertices(equation, case))
    scale = Decimal(f"{1 / scene.scale:.3g}")
    return Picture(scene, case.write(Message(f"solution.polygon-{stage.level}", scale=scale)))


def _list_arrows(side: Iterable[Part], equation: VectorEquation, case: Case) -> list[Arrow]:
    return [
        Arrow(
            case.text(name_part(equation, part, case)),
            _make_floats(part.value),
            part.unknown is None,
        )
        for part in side
        if _is_seen(part.value)
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
                shared = prime(case.naming.letter(part.point))
                vertices.setdefault(_write_small(shared, case), reached)
            reached = reached + _make_floats(part.value)
        if side and not side[-1].coincident:
            vertices.setdefault(_write_small(case.naming.letter(side[-1].point), case), reached)
    return vertices


def _write_small(letter: Symbol, case: Case) -> str:
    """A point's letter as a small one, as corners of polygons have."""
    text = case.text(letter)
    return text[:1].lower() + text[1:]


def _draw_pole(body: str, rays: Sequence[PointArrow], case: Case) -> Picture:
    """The construction of a pole from the velocities of points of the body."""
    mechanism = case.motion.frames.mechanism.map(float)
    still = case.arithmetic.is_zero(case.motion.omega(body))
    at = None if still else _make_floats(case.motion.pole(body, case.arithmetic))
    rotation = next(iter(_find_turnings([make_turning(body)], case, "velocity")), None)
    pole = Pole(case.naming.point(name_pole(body, case)), at)
    scene = draw_pole_construction(mechanism, case.template.figure, pole, rays, rotation)
    caption = Message("solution.picture-pole", body=case.naming.body(body))
    return Picture(scene, case.write(caption))


def _name_picture(level: Level, case: Case) -> str:
    """The caption of a picture of the mechanism with its vectors."""
    return case.write(Message(f"solution.picture-vectors-{level}"))


def _make_floats(vector: Vector) -> Vector:
    """A vector in doubles."""
    return Vector(float(vector.x), float(vector.y))


def _is_seen(vector: Vector) -> bool:
    """Whether a vector is large enough to draw, and not the rounding error of a zero."""
    return max(abs(float(vector.x)), abs(float(vector.y))) > NEGLIGIBLE
