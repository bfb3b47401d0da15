"""The symbol of a length at the end of a leader to the line that is drawn between its points."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, pi

from msgspec.structs import replace

from kinegrade.figure.marks.in_angles import lies_in_angle, list_arcs
from kinegrade.figure.marks.lengths.dimension_lines import Leader
from kinegrade.figure.marks.straight.motions import list_arrows
from kinegrade.figure.placing.aligned import list_thin_lines, runs_on
from kinegrade.figure.placing.layout import Layout
from kinegrade.figure.placing.obstacles import Obstacles, Segment
from kinegrade.figure.plane import angle_of, unit
from kinegrade.figure.scene import THIN, Bow, Strokes

_REACHES = (4.0, 6.0, 9.0)  # millimetres
_TURNS = tuple(turn * pi / 6 for turn in range(12))
_ALONG_PAPER = _TURNS[::3]
# Parts of the line at which a leader may end, with their demerits
_STATIONS = {0.5: 0.0, 0.38: 0.5, 0.62: 0.5, 0.28: 1.0, 0.72: 1.0}
_ALONG = cos(pi / 5)  # of the angle between a leader and its line from which on they are told apart
_AROUND = 1.3  # millimetres about the end of a leader in which nothing but its own line should be
# Demerits of a leader across the arrow, arc or line of another mark, of one that runs on from a
# thin line, and of one in an angle, of which it would seem to be a side
_ACROSS, _RUNS_ON, _IN_ANGLE = 15.0, 12.0, 15.0
_UPRIGHT = 4.0  # demerit of an upright or level leader, which would seem to be a line of reference
_SHORTEST = 3.0  # demerit of a short leader, which is more than that of a symbol beside its line


def list_leaders(layout: Layout, bar: Segment, symbol: str, dear: float) -> Iterator[Leader]:
    """Leaders to the line between two points with demerits below `dear`; the worse the more there
    is where they end and the more marks they cross.
    """
    start, end = bar
    toward = unit(end - start)
    across = toward.turned() * _AROUND
    places = [start + (end - start) * share for share in _STATIONS]
    around = [layout.obstacles.along(((at - across, at + across),), shared=False) for at in places]
    turns = [turn for turn in _TURNS if abs(cos(turn - angle_of(toward))) < _ALONG]
    lines = list_thin_lines(layout.lines)
    marks, arcs = _gather_marks(layout, lines), tuple(list_arcs(layout.marks))
    for at, there, less in zip(places, around, _STATIONS.values(), strict=True):
        worse = less + there - min(around) + _SHORTEST
        if worse + _REACHES[0] >= dear:
            continue
        for leader in [Leader(at, turn, reach, symbol) for reach in _REACHES for turn in turns]:
            across_marks = _ACROSS * (marks.along(leader.path(), shared=False) > 0)
            run_on = _RUNS_ON * runs_on(leader.line(), lines)
            upright = _UPRIGHT * (leader.angle in _ALONG_PAPER)
            in_angle = _IN_ANGLE * lies_in_angle(leader.line(), arcs)
            yield replace(leader, worse=worse + across_marks + run_on + in_angle + upright)


def _gather_marks(layout: Layout, lines: tuple[Segment, ...]) -> Obstacles:
    """The arrows of motions, the arcs of angles and thin lines."""
    arrows = list_arrows(layout.marks)
    arcs = [part for part in layout.lines if isinstance(part, Bow) and part.pen == THIN]
    return Obstacles.of(
        [Strokes(lines, THIN), *arcs, *(part for arrow in arrows for part in arrow.primitives())]
    )
