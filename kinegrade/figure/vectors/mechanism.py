"""The mechanism to scale with velocities or accelerations as arrows at its points, and rotations as
curved arrows.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cache, partial

from kinegrade.figure.marks.body_names import add_body_names
from kinegrade.figure.marks.names import label_points
from kinegrade.figure.marks.turning.rotations import add_rotations
from kinegrade.figure.mechanism.fitting import Room, find_fitting_scale, fit_scene
from kinegrade.figure.mechanism.layers import Drawing
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.place import Wish
from kinegrade.figure.plane import length
from kinegrade.figure.scene import Primitive, Scene
from kinegrade.figure.vectors.arrows import VectorArrow, put_side_by_side
from kinegrade.figure.vectors.leaders import WALLS, write_symbol
from kinegrade.figure.vectors.plain_mechanism import LARGE, PICTURE, BareMechanism, find_pins
from kinegrade.figure.vectors.symbols import foresee_symbol, wish_at_tip
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints, Turning

# Millimetres, of the longest arrow; of one that starts at a point with more than FEW
LONGEST, CROWDED = (16.0, 21.0)
_FEW = 3
_SHORTEST = 1.2  # millimetres: a shorter arrow would not be visible and is left out
_LEAST_SCALE = 0.6  # of the scale without arrows: a smaller mechanism is not told apart
_TOO_SMALL = 2  # as bad as so many crowded symbols
_AT_POINT = 1.5  # millimetres from a point within which an arrow seems to be the point's
# Millimetres between arrows on one line
_OFFSETS = (1.5, -1.5, 3.0, -3.0, 4.5)


@dataclass(frozen=True)
class PointArrow:
    """A velocity (m/s) or an acceleration (m/s^2) at a point (m), x right, y up; `known` before
    solving.
    """

    symbol: str
    at: Vector
    value: Vector
    known: bool = True


@dataclass(frozen=True)
class _Size:
    """The room of a picture, and the length of its arrows as a share of their full length."""

    room: Room
    share: float


_SIZES = (
    _Size(PICTURE, 1.0),
    _Size(PICTURE, 0.75),
    _Size(LARGE, 1.0),
    _Size(LARGE, 1.4),
    _Size(LARGE, 0.75),
)


def draw_with_vectors(
    mechanism: Mechanism,
    hints: FigureHints,
    arrows: Sequence[PointArrow],
    turnings: Sequence[Turning] = (),
) -> Scene:
    """The mechanism (floats, metres) with its letters but without its givens, and all arrows to one
    scale.

    The longest arrow is 16 mm long (21 mm where many start at one point); vectors that are zero or
    too short to be visible are left out. Where the arrows leave the mechanism or the symbols too
    little room, the picture is larger, then its arrows shorter. `turnings` are the curved arrows of
    rotations, each with its sense. The scale of the scene is that of the mechanism.

    Raises TemplateError for a hint about something that the mechanism does not have.
    """
    plain = BareMechanism.of(mechanism, hints, (arrow.at for arrow in arrows))
    bare = plain.first_scale()
    span = plain.span
    rated: list[tuple[int, Scene]] = []
    for size in _SIZES:
        stage_at = cache(partial(_Stage.of, plain, arrows, size.share))
        fitting = find_fitting_scale(_foresee(stage_at), bare, span, size.room)
        if fitting < _LEAST_SCALE * bare and size is not _SIZES[-1]:
            continue
        for symbols_first in (False, True):
            compose = _compose(stage_at, turnings, symbols_first=symbols_first)
            scene = fit_scene(compose, fitting, span, size.room)
            rated.append((_rate_faults(scene, stage_at(scene.scale), bare), scene))
            if not rated[-1][0]:
                return scene
    return min(rated, key=lambda one: one[0])[1]


def _rate_faults(scene: Scene, stage: _Stage, bare: float) -> int:
    """How many symbols are crowded, and arrows lead to the points of others; more where the
    mechanism is too small, whose scale without arrows is `bare`.
    """
    small = _TOO_SMALL * (scene.scale < _LEAST_SCALE * bare)
    return len(scene.crowded) + stage.count_misleading() + small


def place_arrows(
    arrows: Sequence[PointArrow],
    scale: float,
    *,
    shortest: float = _SHORTEST,
    share: float = 1.0,
) -> tuple[VectorArrow, ...]:
    """The arrows on paper to one common scale, next to each other where they would hide one
    another, the longest first; `share` of their full length.
    """
    longest = max((length(arrow.value) for arrow in arrows), default=0.0)
    most = max(Counter(arrow.at for arrow in arrows).values(), default=0)
    reach = share * (CROWDED if most > _FEW else LONGEST)
    visible = [arrow for arrow in arrows if length(arrow.value) * reach > shortest * longest]
    ordered = sorted(visible, key=lambda arrow: -round(length(arrow.value) / longest, 6))
    on_paper = [
        VectorArrow(
            arrow.symbol,
            arrow.at * scale,
            arrow.at * scale + arrow.value * (reach / longest),
            arrow.known,
        )
        for arrow in ordered
    ]
    return put_side_by_side(on_paper, _OFFSETS, nested=True)


def add_arrows(layout: Layout, arrows: Sequence[VectorArrow], drawing: Drawing) -> Layout:
    """The arrows without their symbols, drawn below the pins at which they start."""
    parts = tuple(part for arrow in arrows for part in arrow.primitives())
    return layout.drawn((*parts, *find_pins(drawing.primitives)))


def add_symbols(layout: Layout, arrows: Sequence[VectorArrow]) -> Layout:
    """The symbols of the arrows, starting with the shortest: it has the fewest places to choose
    from.
    """
    for arrow in sorted(arrows, key=lambda arrow: length(arrow.end - arrow.start)):
        layout = write_symbol(layout, arrow, arrows, WALLS, wish_at_tip(arrow, arrows))
    return layout


def _foresee(stage_at: Callable[[float], _Stage]) -> Callable[[float], Iterable[Primitive]]:
    return lambda scale: stage_at(scale).foresee()


def _compose(
    stage_at: Callable[[float], _Stage], turnings: Sequence[Turning], *, symbols_first: bool
) -> Callable[[float], Layout]:
    return lambda scale: stage_at(scale).write(turnings, symbols_first=symbols_first)


def _passes(arrow: VectorArrow, at: Vector) -> bool:
    """Whether an arrow is drawn over a point or ends near it."""
    start, tip = arrow.line
    share = (at - start).dot(tip - start) / length(tip - start) ** 2
    return length(start + (tip - start) * min(max(share, 0.0), 1.0) - at) < _AT_POINT


@dataclass(frozen=True)
class _Stage:
    """A mechanism on paper with its arrows, before a label stands; `letters` are those of its
    points.
    """

    paper: Mechanism
    hints: FigureHints
    drawing: Drawing
    arrows: tuple[VectorArrow, ...]
    letters: tuple[Wish, ...]

    @staticmethod
    def of(
        plain: BareMechanism, arrows: Sequence[PointArrow], share: float, scale: float
    ) -> _Stage:
        """The mechanism at a scale, the arrows with that `share` of their full length."""
        paper, drawing = plain.at(scale)
        placed = place_arrows(arrows, scale, share=share)
        letters = tuple(label_points(paper, plain.hints, drawing))
        return _Stage(paper, plain.hints, drawing, placed, letters)

    def foresee(self) -> tuple[Primitive, ...]:
        """The lines, and the labels where each would stand first, to know the scale before labels
        are placed.
        """
        lines = (part for arrow in self.arrows for part in arrow.primitives())
        symbols = (foresee_symbol(arrow) for arrow in self.arrows)
        letters = (letter.label_at(0) for letter in self.letters)
        return (*self.drawing.primitives, *lines, *symbols, *letters)

    def count_misleading(self) -> int:
        """How many arrows lead to a point of the mechanism, or past it, and so may be read as its
        velocity.
        """
        points = self.paper.points.values()
        return sum(
            any(_passes(arrow, at) for at in points if length(at - arrow.start) > _AT_POINT)
            for arrow in self.arrows
        )

    def write(self, turnings: Sequence[Turning], *, symbols_first: bool) -> Layout:
        """The mechanism and its arrows, then the labels with the fewest possible places first:
        letters, symbols, names of bodies; symbols before letters where these leave them no place.
        """
        layout = add_arrows(Layout.of(self.drawing.primitives), self.arrows, self.drawing)
        early, late = ((), self.letters) if symbols_first else (self.letters, ())
        layout = add_symbols(layout.written(early), self.arrows).written(late)
        layout = add_rotations(layout, self.paper, turnings, self.drawing, self.letters)
        return add_body_names(layout, self.paper, self.hints, self.drawing)
