"""The two ways to draw a radius: an arrow from the centre to the rim, and one from outside."""

from __future__ import annotations

import numpy as np
from msgspec import Struct

from kinegrade.figure.joints.symbol import Rim
from kinegrade.figure.placing.obstacles import Segment
from kinegrade.figure.placing.place import Wish, list_spots_around, list_spots_beside
from kinegrade.figure.plane import length, nearest_of, unit
from kinegrade.figure.scene import FIRM, THIN, Outline, Primitive, Strokes
from kinegrade.figure.symbols.arrows import HEAD_LENGTH, draw_arrowhead
from kinegrade.figure.teeth import TOOTH_TIP
from kinegrade.mechanics.vector import Vector

# Cost of an arrow across another wheel, and of one towards a centre that is in its own circle
_ACROSS, _TOWARD_CENTRE = 15.0, 1.5
_HALO = 0.6  # millimetres about an arrowhead that are free of hatching
_ALONG_STROKE = (0.0, 0.25, 0.5, 0.75, 1.0)  # shares of a stroke at which it may touch a head
# Millimetres of white on either side of a stroke that is left out, and from its edge's middle to it
_WHITE, _OFF_EDGE = 0.4, FIRM.width / 2 + 0.03
# Strokes of hatching between an arrow and an end of the arc that is hatched, which show that it is,
# and the demerit of fewer
_SHOWN, _BARE_END = 3, 12.0
_BESIDE = 1.2  # millimetres beside another wheel within which an arrow seems to lie on its rim
_PAST_TEETH = TOOTH_TIP + 1.0  # millimetres from a pitch circle to where an arrow is past its teeth
FROM_OUTSIDE = 7.0  # millimetres from a rim to the tail of an arrow from outside
# Millimetres between an arrow from a centre and its letter, and demerit of each step away from it,
# where the letter might be that of the centre
_GAPS, _OFF_ARROW = (0.5, 1.7, 3.1), 0.6
_TOUCHING = 0.99  # share of a radius: nearer is within the circle


class RadiusFromCentre(Struct, frozen=True):
    """An arrow from the centre to the rim."""

    centre: Vector
    radius: float
    toward: Vector
    symbol: str
    demerit: float
    others: tuple[Rim, ...]
    rough: bool
    hatching: tuple[Segment, ...]
    hatched_arc: bool = False
    shared: bool = False

    def rate_meetings(self) -> float:
        """How much worse the arrow is for running across other circles or towards their centres."""
        worse = 0.0
        for other in self.others:
            aside = other.at - self.centre
            missed = length(nearest_of(other.at, self.centre, self._end()) - other.at)
            if missed < other.radius + _BESIDE and other.radius < _TOUCHING * length(aside):
                worse += _ACROSS
            if length(aside) < self.radius:
                worse += _TOWARD_CENTRE * max(0.0, self.toward.dot(unit(aside)))
        return worse + _BARE_END * self._bares_end()

    def _bares_end(self) -> bool:
        """Whether it leaves so few strokes towards an end of the arc that this seems to be bare."""
        if not self.hatched_arc:
            return False
        left = [not self._meets(stroke) for stroke in self.hatching]
        return not all((*left[:_SHOWN], *left[-_SHOWN:]))

    def path(self) -> tuple[Segment, ...]:
        """The arrow without its ends, which touch the centre and the rim in any case, or teeth or
        another circle there.
        """
        clear = 1.5 if self.rough or self.others else 0.5
        return (
            (self.centre + self.toward * 2.0, self.centre + self.toward * (self.radius - clear)),
        )

    def wish(self) -> Wish:
        """Beside the arrow, where it is not within another circle first, and rather close to it."""
        gaps = [
            list_spots_beside(self.symbol, self.centre, self._end(), gaps=(gap,)) for gap in _GAPS
        ]
        spots = np.concatenate(gaps)
        off = _OFF_ARROW * np.repeat(np.arange(float(len(_GAPS))), len(gaps[0]))
        within = [
            any(length(Vector(*spot) - other.at) < other.radius for other in self.others)
            for spot in spots.tolist()
        ]
        order = np.argsort(within, kind="stable")
        return Wish(self.symbol, spots[order], demerits=off[order])

    def primitives(self) -> tuple[Primitive, ...]:
        """A thin line and its arrowhead, with white over the strokes of hatching that it meets."""
        shaft = (self.centre + self.toward * 1.3, self._end() - self.toward * HEAD_LENGTH * 0.8)
        met = (_hide_stroke(stroke, self.centre) for stroke in self.hatching if self._meets(stroke))
        return (*met, Strokes((shaft,), THIN), draw_arrowhead(self._end(), self.toward))

    def _meets(self, stroke: Segment) -> bool:
        """Whether a stroke of hatching touches the head, which is wider away from its tip."""
        foot, end = stroke
        for share in _ALONG_STROKE:
            back = self._end() - foot - (end - foot) * share
            depth, aside = back.dot(self.toward), abs(back.cross(self.toward))
            if aside < _HALO + min(depth, HEAD_LENGTH) / 4 and depth < HEAD_LENGTH + _HALO:
                return True
        return False

    def _end(self) -> Vector:
        return self.centre + self.toward * self.radius


class RadiusFromOutside(Struct, frozen=True):
    """An arrow that points at the rim from outside, where there is no room inside."""

    centre: Vector
    radius: float
    toward: Vector
    symbol: str
    demerit: float
    toothed: bool
    shared: bool = False

    def path(self) -> tuple[Segment, ...]:
        """The arrow without the tip, which touches the rim in any case, or is between teeth."""
        return ((self._out(_PAST_TEETH if self.toothed else 0.4), self._out(FROM_OUTSIDE)),)

    def wish(self) -> Wish:
        """Around the tail."""
        return Wish(
            self.symbol, list_spots_around(self.symbol, self._out(FROM_OUTSIDE), away=self.toward)
        )

    def primitives(self) -> tuple[Primitive, ...]:
        """A thin line and its arrowhead."""
        shaft = (self._out(HEAD_LENGTH * 0.8), self._out(FROM_OUTSIDE))
        return (Strokes((shaft,), THIN), draw_arrowhead(self._out(0.0), -self.toward))

    def _out(self, gap: float) -> Vector:
        return self.centre + self.toward * (self.radius + gap)


def _hide_stroke(stroke: Segment, centre: Vector) -> Outline:
    """White over a whole stroke of hatching, as its cut end would be a crumb; not over the edge."""
    foot, end = stroke
    step, outward = unit(end - foot), unit(foot - centre)
    near, far = foot - step * (_OFF_EDGE / step.dot(outward)), end + step * _WHITE
    aside = outward.turned() * _WHITE
    return Outline((near - aside, near + aside, far + aside, far - aside), None, "white")
