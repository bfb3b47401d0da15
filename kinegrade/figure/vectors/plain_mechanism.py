"""The mechanism alone with its letters, as the background for the vectors of a worked solution."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from msgspec import structs

from kinegrade.figure.mechanism.fitting import Room, measure_span
from kinegrade.figure.mechanism.layers import Drawing, draw
from kinegrade.figure.mechanism.paper import scale_to_paper
from kinegrade.figure.mechanism.view import crop_to_view
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.scene import BOLD, Disc, Primitive, Strokes, find_common_box
from kinegrade.figure.symbols.pins import PIN
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.mechanics.vector import Vector
from kinegrade.problem.template.hints import FigureHints

PICTURE = Room(64.0, 44.0)  # smaller than the figure of the question: text stands beside it
LARGE = Room(80.0, 64.0)  # millimetres, for a picture that is too hard to read in less
_LARGEST_PIN = PIN + 0.1  # millimetres, radius of the symbol at a point
_BAR = structs.replace(BOLD, ink="grey")
_SURROUND = 12.0  # millimetres that symbols take beside the mechanism, as a first estimate


def _drop_givens(hints: FigureHints) -> FigureHints:
    """The hints about the mechanism itself: without dimensions, angles, radii, given motions and
    frames.
    """
    return replace(
        hints,
        lengths=(),
        angles=(),
        right_angles=(),
        radii=(),
        arrows=(),
        frames=(),
        axes=None,
    )


@dataclass(frozen=True)
class BareMechanism:
    """A mechanism (metres) without its givens; `beside` are further points that must be in the
    picture.
    """

    mechanism: Mechanism
    hints: FigureHints
    beside: tuple[Vector, ...] = ()

    @staticmethod
    def of(
        mechanism: Mechanism, hints: FigureHints, beside: Iterable[Vector] = ()
    ) -> BareMechanism:
        """The mechanism of a figure without its givens."""
        kept = _drop_givens(hints)
        return BareMechanism(crop_to_view(mechanism, kept), kept, tuple(beside))

    @property
    def span(self) -> tuple[float, float]:
        """Width and height of the scaled part, m."""
        return measure_span(self.mechanism, self.hints, self.beside)

    def first_scale(self, room: Room = PICTURE) -> float:
        """The largest scale, in millimetres per metre, at which the mechanism's symbols fit the
        room.
        """
        across, upward = (max(size, 1e-9) for size in self.span)
        guess = min((room.width - _SURROUND) / across, (room.height - _SURROUND) / upward)
        drawn = find_common_box(self.at(guess)[1].primitives)
        return guess * min(1.0, room.width / drawn.width, room.height / drawn.height)

    def at(self, scale: float) -> tuple[Mechanism, Drawing]:
        """The mechanism in millimetres on paper, and its drawing with grey bars: an arrow along one
        is seen upon it.
        """
        paper = scale_to_paper(self.mechanism, scale)
        drawing = draw(paper, self.hints)
        return paper, structs.replace(drawing, primitives=tuple(map(_fade, drawing.primitives)))


def _fade(primitive: Primitive) -> Primitive:
    if isinstance(primitive, Strokes) and primitive.pen.width >= BOLD.width:
        return structs.replace(primitive, pen=_BAR)
    return primitive


def find_bold_lines(primitives: Iterable[Primitive]) -> Iterator[Segment]:
    """The straight bold lines, on which no thin line would be visible."""
    for primitive in primitives:
        if isinstance(primitive, Strokes) and primitive.pen.width >= BOLD.width:
            yield from primitive.lines


def find_pins(primitives: Iterable[Primitive]) -> tuple[Primitive, ...]:
    """The small circles of pins and marked points, to be drawn again on top of arrows that start
    there.
    """
    discs = (part for part in primitives if isinstance(part, Disc) and part.fill != "none")
    return tuple(disc for disc in discs if disc.radius <= _LARGEST_PIN)
