"""What is said of a cycle: how far the input goes, strokes, time ratios, extremes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from decimal import Decimal
from typing import assert_never

from kinegrade.cycles.curves import Curve
from kinegrade.cycles.cycle import Cycle
from kinegrade.cycles.swings import Swing
from kinegrade.cycles.wording import name_point
from kinegrade.language import Language
from kinegrade.language.math.units import write_unit
from kinegrade.language.message import Message, Text, list_all
from kinegrade.mechanics.geometry import round_short
from kinegrade.motion.ends import Blocked, ChangePoint, Closed, End, Limit, Open, Receding
from kinegrade.problem.template.template import Ask
from kinegrade.worked.words.naming import Naming


def list_facts(
    cycle: Cycle, language: Language, name_ask: Callable[[Ask], str]
) -> Iterator[Message]:
    """A sentence for each thing worth saying of a cycle, in prose, with asks named as the
    reader knows them."""
    path, is_angle = cycle.path, cycle.path.input.is_angle
    for end in (path.start, path.end):
        if end is not None:
            yield _describe_end(end, is_angle)
    for change in path.changes:
        yield _describe_change(change, is_angle)
    naming = Naming(cycle.solution.template, language)
    for swing in cycle.swings:
        name = naming.body(swing.name) if swing.is_angle else name_point(swing.name)
        yield _describe_swing(swing, name, is_angle)
    for curve in cycle.curves:
        if not curve.is_steep:
            yield _describe_extremes(curve, name_ask(curve.ask), is_angle)
        yield from describe_gaps(curve, name_ask(curve.ask), is_angle)


def describe_gaps(curve: Curve, name: str, is_angle: bool) -> Iterator[Message]:
    """Where a curve breaks off, a sentence for each reason."""
    for together in dict.fromkeys(gap.together for gap in curve.gaps):
        places = list_all(
            _write_place(gap.displacement, is_angle)
            for gap in curve.gaps
            if gap.together == together
        )
        if together:
            points = list_all(map(name_point, together))
            yield Message("motion.gap-together", ask=name, places=places, points=points)
        else:
            yield Message("motion.gap", ask=name, places=places)


def _describe_end(end: End, is_angle: bool) -> Message:
    """Why the input goes no further."""
    place = _write_place(end.displacement, is_angle)
    match end:
        case Closed(turns=turns):
            return Message("motion.closed", turns=turns)
        case Limit(line=line):
            if line is None:
                return Message("motion.limit", place=place)
            return Message("motion.limit-in-line", place=place, line=line)
        case Receding():
            return Message("motion.receding", place=place)
        case Blocked():
            return Message("motion.blocked", place=place)
        case Open():
            return Message("motion.open", place=place)
        case _:
            assert_never(end)


def _describe_change(change: ChangePoint, is_angle: bool) -> Message:
    place = _write_place(change.displacement, is_angle)
    if change.line is None:
        return Message("motion.change-point", place=place)
    return Message("motion.change-point-in-line", place=place, line=change.line)


def _describe_swing(swing: Swing, name: Text, is_angle: bool) -> Message:
    """A stroke in m, or a swing in degrees, with its ends and its time ratio."""
    kind = "swing" if swing.is_angle else "stroke"
    stated = Message(
        f"motion.way-{kind}",
        name=name,
        extent=_write_place(swing.extent, swing.is_angle),
        start=_write_place(swing.at_least, is_angle),
        end=_write_place(swing.at_greatest, is_angle),
    )
    if swing.time_ratio is None:
        return stated
    ratio = round_short(swing.time_ratio)
    return Message("motion.with-ratio", swing=stated, ratio=ratio)


def _describe_extremes(curve: Curve, name: str, is_angle: bool) -> Message:
    """The least and the greatest value of a curve, and where they are."""
    least, greatest = (
        _describe_extreme(curve, number, is_angle) for number in (curve.least, curve.greatest)
    )
    return Message("motion.extremes", ask=name, least=least, greatest=greatest)


def _describe_extreme(curve: Curve, number: int, is_angle: bool) -> Message:
    """The value at a position; beside a gap, the one that it goes to there."""
    unit = "" if curve.ask.unit.text == "1" else write_unit(curve.ask.unit.text)
    limit = curve.find_limit(number)
    if limit is None:
        place = _write_place(float(curve.moved[number]), is_angle)
        value = _round(float(curve.values[number]))
        return Message("motion.extreme", value=value, unit=unit, place=place)
    gap, value_there = limit
    place = _write_place(gap.displacement, is_angle)
    return Message("motion.extreme-near", value=_round(value_there), unit=unit, place=place)


def _write_place(displacement: float, is_angle: bool) -> Message:
    """A displacement in degrees or m."""
    if is_angle:
        return Message("motion.degrees", number=_round(math.degrees(displacement)))
    return Message("motion.metres", number=_round(displacement))


def _round(value: float) -> Decimal | str:
    """Four significant figures; what rounding leaves of zero is zero."""
    return round_short(0.0 if abs(value) < 1e-9 else value)
