"""The pictures of a step: the mechanism with its velocities, beside it the polygon of the equation;
of accelerations the polygon alone; the construction of a pole.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import assert_never

from kinegrade.figure.plane import length
from kinegrade.figure.scene import Label
from kinegrade.figure.vectors.mechanism import PointArrow, draw_with_vectors
from kinegrade.figure.vectors.pole_construction import Pole, draw_pole_construction
from kinegrade.language.math.tree import Text, list_nodes
from kinegrade.language.message import Message
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.rates import Rate, make_turning
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.problem.template.hints import Turning
from kinegrade.worked.case import Case
from kinegrade.worked.document import Picture, Pictures, Prose
from kinegrade.worked.steps.couplers import choose_method, find_coupler
from kinegrade.worked.steps.poles.poles import name_pole
from kinegrade.worked.steps.polygons import (
    describe,
    draw_equation,
    explain_corners,
    is_seen,
    spans_polygon,
)
from kinegrade.worked.steps.rigid import find_rigid_triangle
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import name_part

# Times the longest velocity of a step: beside one that is asked and longer, those would be dots
_LONGER = 1.5


def draw_stage(
    stage: Stage, scale: float | None = None, asked: Sequence[PointArrow] = ()
) -> Iterator[Pictures | Prose]:
    """The pictures of a step: the mechanism with its velocities, those `asked` among them, and the
    polygon to that scale, the polygon alone of accelerations, whose table and polygon leave a
    sketch nothing to say, with what its letters mark, or the construction of a pole unless it is at
    infinity; none where no vectors are added.
    """
    coupler = find_coupler(stage)
    if coupler is not None and choose_method(coupler, stage.case) == "pole":
        if not stage.case.arithmetic.is_zero(stage.case.motion.omega(coupler.body)):
            arrows = _find_point_arrows((coupler.base, coupler.point), coupler.equation, stage.case)
            yield Pictures((_draw_pole(coupler.body, tuple(arrows), stage.case),))
        return
    added = [equation for equation in stage.equations if spans_polygon(equation)]
    if added and find_rigid_triangle(stage) is None:
        polygons = [draw_equation(equation, stage, scale) for equation in added]
        match stage.level:
            case "velocity":
                yield Pictures((_draw_velocities(stage.equations, stage, asked), *polygons))
            case "acceleration":
                yield Pictures(tuple(polygons))
            case _:
                assert_never(stage.level)
        for equation in added:
            yield from explain_corners(equation, stage.case)


def _draw_velocities(
    equations: Sequence[VectorEquation], stage: Stage, asked: Iterable[PointArrow]
) -> Picture:
    """The mechanism with all velocities of the step at their points and those that are asked, those
    too short for it named below, and the rotations that are worked out.
    """
    case = stage.case
    arrows = {
        (arrow.symbol, arrow.at): arrow
        for equation in equations
        for arrow in _find_point_arrows(equation.parts, equation, case)
    }
    longest = max(length(arrow.value) for arrow in arrows.values())
    for one in asked:
        drawn = any(_are_same(one, other) for other in arrows.values())
        if is_seen(one.value) and not drawn and length(one.value) < _LONGER * longest:
            arrows[one.symbol, one.at] = one
    rates = dict.fromkeys(
        rate for equation in equations for rate in equation.unknowns if not stage.leaves_out(rate)
    )
    shown = tuple(arrows.values())
    turnings = tuple(replace(turning, sought=True) for turning in _find_turnings(rates, case))
    scene = case.drawings.find(
        (draw_with_vectors, shown, turnings),
        lambda: draw_with_vectors(_find_mechanism(case), case.template.figure, shown, turnings),
    )
    symbols = [arrow.symbol for arrow in arrows.values()]
    picture = describe(scene, Message("solution.picture-velocities"), symbols, case)
    return replace(picture, kind="velocities")


def _are_same(one: PointArrow, other: PointArrow) -> bool:
    """Whether two velocities are drawn as one: v_a of a composition is that of its point."""
    return not is_seen(one.at - other.at) and not is_seen(one.value - other.value)


def _find_point_arrows(
    parts: Iterable[Part], equation: VectorEquation, case: Case
) -> Iterator[PointArrow]:
    """The parts that do not vanish, each at its point."""
    for part in parts:
        if is_seen(part.value):
            at = case.motion.points[part.point].map(float)
            yield PointArrow(
                case.text(name_part(equation, part, case)),
                at,
                part.value.map(float),
                part.unknown is None,
            )


def _find_turnings(rates: Iterable[Rate], case: Case) -> tuple[Turning, ...]:
    """The rotations that a step gives, in their sense."""
    values = case.motion.rates
    return tuple(
        Turning(
            case.text(case.naming.omega(rate.body)),
            rate.body,
            "ccw" if float(values[rate]) > 0 else "cw",
        )
        for rate in rates
        if rate.kind == "turning" and float(values[rate]) and _is_short(rate, case)
    )


def _is_short(rate: Rate, case: Case) -> bool:
    """Whether the symbol of a rotation has letters only, and no words that a figure has no room
    for.
    """
    symbol = case.naming.omega(rate.body)
    return not any(isinstance(node, Text) for node in list_nodes(symbol.row))


def _find_mechanism(case: Case) -> Mechanism:
    """The mechanism in doubles."""
    return case.motion.frames.mechanism.map(float)


def _draw_pole(body: str, rays: tuple[PointArrow, ...], case: Case) -> Picture:
    """The construction of a pole from the velocities of points of the body."""
    at = case.motion.pole(body, case.arithmetic).map(float)
    rotation = next(iter(_find_turnings([make_turning(body)], case)), None)
    pole = Pole(case.naming.point(name_pole(body, case)), at)
    scene = case.drawings.find(
        (draw_pole_construction, pole, rays, rotation),
        lambda: draw_pole_construction(
            _find_mechanism(case), case.template.figure, pole, rays, rotation
        ),
    )
    named = any(isinstance(part, Label) and part.symbol == pole.symbol for part in scene.primitives)
    kind = "solution.picture-pole" if named else "solution.picture-pole-outside"
    caption = Message(kind, body=case.naming.body(body), pole=pole.symbol)
    return Picture(scene, case.write(caption))
