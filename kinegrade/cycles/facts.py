"""What is said of a cycle: how far the input goes, strokes, time ratios, extremes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import assert_never

from kinegrade.cycles.curves import Curve
from kinegrade.cycles.cycle import Cycle
from kinegrade.cycles.swings import Swing
from kinegrade.cycles.wording import Quantities, name_point
from kinegrade.language import Language
from kinegrade.language.message import Message, Text, list_all
from kinegrade.motion.ends import Blocked, ChangePoint, Closed, End, Limit, Open, Receding
from kinegrade.problem.template.template import Ask
from kinegrade.worked.words.naming import Naming


def list_facts(
    cycle: Cycle, language: Language, name_ask: Callable[[Ask], str]
) -> Iterator[Message]:
    """A sentence for each thing worth saying of a cycle, in prose, with asks named as the
    reader knows them."""
    path, written = cycle.path, Quantities(language, cycle.path.input.is_angle)
    for end in (path.start, path.end):
        if end is not None:
            yield _describe_end(end, written)
    for change in path.changes:
        yield _describe_change(change, written)
    naming = Naming(cycle.solution.template, language)
    for swing in cycle.swings:
        name = naming.body(swing.name) if swing.is_angle else name_point(swing.name)
        yield _describe_swing(swing, name, written)
    for curve in cycle.curves:
        if not curve.is_steep:
            yield _describe_extremes(curve, name_ask(curve.ask), written)
        yield from describe_gaps(curve, name_ask(curve.ask), written)


def describe_gaps(curve: Curve, name: str, written: Quantities) -> Iterator[Message]:
    """Where a curve breaks off, a sentence for each reason."""
    for together in dict.fromkeys(gap.together for gap in curve.gaps):
        places = list_all(
            written.place(gap.displacement) for gap in curve.gaps if gap.together == together
        )
        if together:
            points = list_all(map(name_point, together))
            yield Message("motion.gap-together", ask=name, places=places, points=points)
        else:
            yield Message("motion.gap", ask=name, places=places)


def _describe_end(end: End, written: Quantities) -> Message:
    """Why the input goes no further."""
    place = written.place(end.displacement)
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


def _describe_change(change: ChangePoint, written: Quantities) -> Message:
    place = written.place(change.displacement)
    if change.line is None:
        return Message("motion.change-point", place=place)
    return Message("motion.change-point-in-line", place=place, line=change.line)


def _describe_swing(swing: Swing, name: Text, written: Quantities) -> Message:
    """A stroke in m, or a swing in degrees, with its ends and its time ratio."""
    kind = "swing" if swing.is_angle else "stroke"
    stated = Message(
        f"motion.way-{kind}",
        name=name,
        extent=replace(written, is_angle=swing.is_angle).place(swing.extent),
        start=written.place(swing.at_least),
        end=written.place(swing.at_greatest),
    )
    if swing.time_ratio is None:
        return stated
    ratio = written.write(swing.time_ratio)
    return Message("motion.with-ratio", swing=stated, ratio=ratio)


def _describe_extremes(curve: Curve, name: str, written: Quantities) -> Message:
    """The least and the greatest value of a curve, and where they are."""
    least, greatest = (
        _describe_extreme(curve, number, written) for number in (curve.least, curve.greatest)
    )
    return Message("motion.extremes", ask=name, least=least, greatest=greatest)


def _describe_extreme(curve: Curve, number: int, written: Quantities) -> Message:
    """The value at a position; beside a gap, the one that it goes to there."""
    unit, limit = curve.ask.unit.text, curve.find_limit(number)
    if limit is None:
        value = written.write(float(curve.values[number]), unit)
        place = written.place(float(curve.moved[number]))
        return Message("motion.extreme", value=value, place=place)
    gap, value_there = limit
    value, place = written.write(value_there, unit), written.place(gap.displacement)
    return Message("motion.extreme-near", value=value, place=place)
