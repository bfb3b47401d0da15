"""What is said of a cycle: how far the input goes, strokes, time ratios, extremes."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import assert_never

from kinegrade.cycles.curves import Curve, Extreme
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
        yield from _describe_values(cycle, curve, name_ask(curve.ask), written)
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


def _describe_values(
    cycle: Cycle, curve: Curve, name: str, written: Quantities
) -> Iterator[Message]:
    """The one value of a curve, or the least and the greatest, and where they are."""
    unit = curve.ask.unit.text
    if curve.constant is not None:
        yield Message("motion.constant", ask=name, value=written.write(curve.constant, unit))
    elif curve.ask.name in cycle.extremes:
        least, greatest = (
            _describe_extreme(each, unit, written) for each in cycle.extremes[curve.ask.name]
        )
        yield Message("motion.extremes", ask=name, least=least, greatest=greatest)


def _describe_extreme(extreme: Extreme, unit: str, written: Quantities) -> Message:
    value, place = written.write(extreme.value, unit), written.place(extreme.displacement)
    key = "motion.extreme-near" if extreme.is_near else "motion.extreme"
    return Message(key, value=value, place=place)
