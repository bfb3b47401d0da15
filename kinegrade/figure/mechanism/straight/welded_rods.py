"""Rods welded to the slotted bar of their own body, as of a scotch yoke: a rod ends at the edge of
the bar, and the slot runs on past the axis of the rod.
"""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

from kinegrade.figure.mechanism.straight_parts import Bar, Part, Rod, find_half_width
from kinegrade.figure.plane import NEAR, length, on_line, unit
from kinegrade.mechanics.joints import Line

_PAST_ROD = 2.8  # millimetres of a slotted bar past the axis of a rod that meets it at its end


def weld_rods(parts: Sequence[Part], rods: Sequence[Rod]) -> tuple[Part, ...]:
    """All parts, where rods and the slotted bars of their bodies are as they meet."""
    bars = [part for part in parts if isinstance(part, Bar)]
    return (
        *(_run_past(part, rods) if isinstance(part, Bar) else part for part in parts),
        *(_end_at_edge(rod, bars) for rod in rods),
    )


def is_welded(rod: Rod, bar: Bar) -> bool:
    """Whether a rod begins at a slotted bar of its body, on its axis or its edge."""
    along = unit(bar.end - bar.start)
    apart = abs((rod.start - bar.start).cross(along))
    of_one_body = bar.use == "slot" and bar.body == rod.body
    across = abs(unit(rod.end - rod.start).cross(along)) > NEAR
    return of_one_body and across and apart < find_half_width(bar) + NEAR


def _run_past(bar: Bar, rods: Sequence[Rod]) -> Bar:
    for rod in rods:
        if is_welded(rod, bar):
            along = unit(bar.end - bar.start) * _PAST_ROD
            if length(rod.start - bar.start) < NEAR:
                bar = replace(bar, start=bar.start - along, free=(*bar.free, bar.start - along))
            elif length(rod.start - bar.end) < NEAR:
                bar = replace(bar, end=bar.end + along, free=(*bar.free, bar.end + along))
    return bar


def _end_at_edge(rod: Rod, bars: Sequence[Bar]) -> Rod:
    for bar in bars:
        on_axis = on_line(rod.start, Line(bar.start, bar.end - bar.start))
        if is_welded(rod, bar) and on_axis:
            toward = unit(rod.end - rod.start)
            aside = abs(toward.cross(unit(bar.end - bar.start)))
            return replace(rod, start=rod.start + toward * (find_half_width(bar) / aside))
    return rod
