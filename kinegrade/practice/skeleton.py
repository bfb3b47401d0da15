"""What moves in the figure of a practice sheet: a mechanism as points, and what is drawn between
them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import assert_never

from kinegrade.cycles.centrodes import find_poled_bodies, list_unpinned_bodies
from kinegrade.figure.back_ends.svg import write_symbol_spans
from kinegrade.figure.marks.names import write_point_symbol
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import EqualRotation, GuidedBody, GuidedPoint, SharedPoint
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.shapes import Circle, Line
from kinegrade.motion.path import MotionPath
from kinegrade.problem.pole_names import name_poles
from kinegrade.problem.template.hints import FigureHints
from kinegrade.problem.template.template import Template


@dataclass(frozen=True)
class Guide:
    """A straight line of the body `of`, along which `rider` moves: a point, or the first point of
    a body; `is_block` where it is drawn as one that slides.
    """

    rider: str
    of: str
    line: Line
    is_block: bool


@dataclass(frozen=True)
class PracticePole:
    """The velocity pole of the body that has these two places, a point and its mark; lines lead to
    it from the body's points, `lines`. Its `letter` is SVG.
    """

    letter: str
    points: tuple[int, int]
    lines: tuple[int, ...]


@dataclass(frozen=True)
class PracticeSkeleton:
    """A mechanism by the places of its points among `labels` (SVG, "" for points without a letter);
    behind them two points for each guide, and a mark on each body that no pin holds. `bars` join
    the points of each body, `circles` have their centres, `pivots` are fixed; `riders` move along
    the guides, those that are `blocks` drawn as such.
    """

    labels: tuple[str, ...]
    bars: tuple[tuple[int, ...], ...]
    circles: tuple[int, ...]
    pivots: tuple[int, ...]
    riders: tuple[int, ...]
    blocks: tuple[bool, ...]
    poles: tuple[PracticePole, ...]
    input: str  # what moves it, in words
    unit: str  # of the displacements that are shown: "°" or "m"


def list_guides(mechanism: Mechanism) -> tuple[Guide, ...]:
    """The lines along which points or bodies move."""
    centres = {circle.centre for circle in list_circles(mechanism)}
    found = dict.fromkeys(_find_guides(mechanism))
    return tuple(replace(each, is_block=False) if each.rider in centres else each for each in found)


def _find_guides(mechanism: Mechanism) -> Iterator[Guide]:
    for condition in mechanism.list_conditions():
        match condition:
            case GuidedPoint(point=point, of=of, track=Line() as line, in_slot=in_slot):
                yield Guide(point, of, line, in_slot or of == GROUND)
            case GuidedBody(body=body, of=of, line=line):
                yield Guide(mechanism.body(body).points[0], of, line, is_block=True)
            case GuidedPoint() | SharedPoint() | EqualRotation():
                pass  # no straight line
            case _:
                assert_never(condition)


def list_circles(mechanism: Mechanism) -> tuple[Circle, ...]:
    """The circles of joints: rims, tracks, profiles."""
    return tuple(
        dict.fromkeys(circle for joint in mechanism.joints for circle in joint.list_circles())
    )


def list_marked(path: MotionPath) -> dict[str, tuple[int, int]]:
    """The places of the first point and of the mark of each body that no pin holds."""
    mechanism = path.motion.frames.mechanism
    order = list(mechanism.points)
    first = len(order) + 2 * len(list_guides(mechanism))
    return {
        body.name: (order.index(body.points[0]), first + number)
        for number, body in enumerate(list_unpinned_bodies(path))
    }


def make_skeleton(path: MotionPath, template: Template, moves: str, unit: str) -> PracticeSkeleton:
    """The skeleton of a mechanism that moves. Raises TypesetError for a symbol that is none."""
    mechanism, hints = path.motion.frames.mechanism, template.figure
    order = {name: place for place, name in enumerate(mechanism.points)}
    carried = {name for body in mechanism.bodies for name in body.points}
    guides = list_guides(mechanism)
    pivots = sorted(order[point] for point in set(mechanism.find_pivots().values()))
    return PracticeSkeleton(
        labels=tuple(_write_label(name, carried, hints) for name in order),
        bars=tuple(
            tuple(order[name] for name in body.points)
            for body in mechanism.bodies
            if len(body.points) > 1
        ),
        circles=tuple(order[circle.centre] for circle in list_circles(mechanism)),
        pivots=tuple(pivots),
        riders=tuple(order[guide.rider] for guide in guides),
        blocks=tuple(guide.is_block for guide in guides),
        poles=tuple(_list_poles(path, order, template)),
        input=moves,
        unit=unit,
    )


def _list_poles(
    path: MotionPath, order: Mapping[str, int], template: Template
) -> Iterator[PracticePole]:
    """The poles, each with a point of its body and the mark."""
    mechanism, marked = path.motion.frames.mechanism, list_marked(path)
    for body, name in name_poles(find_poled_bodies(path), template).items():
        points = tuple(order[point] for point in mechanism.body(body).points)
        symbol = write_symbol_spans(write_point_symbol(name))
        yield PracticePole(symbol, marked[body], points)


def _write_label(name: str, carried: set[str], hints: FigureHints) -> str:
    """The letter of a point that some body has, if the figure has one."""
    symbol = hints.labels.get(name, write_point_symbol(name))
    return write_symbol_spans(symbol) if name in carried and symbol else ""
