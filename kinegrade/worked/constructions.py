"""The construction of a point in textbook words and equations: where it lies, and how its
coordinates are worked out.

Lines, circles and feet of perpendiculars are in `kinegrade.worked.intersections`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import assert_never

from kinegrade.expression import Call, Expression, Name, Number, Operation, list_parts
from kinegrade.language import Language
from kinegrade.worked.coordinates import ZERO, Pair, Step, length_of, minus, over, plus, scale
from kinegrade.worked.document import Block, Display, Heading, Pictures, Prose, Results, TermTable
from kinegrade.worked.formula_text import count_quarter_turns
from kinegrade.worked.instance_formulas import Instance
from kinegrade.worked.intersections import explain_foot, explain_meeting
from kinegrade.worked.position_words import PositionWords, load_position_words
from kinegrade.worked.vector_words import describe_vector, negate


@dataclass(frozen=True)
class _Coordinates:
    """Points given by their coordinates alone: one sentence with their equations."""

    points: tuple[str, ...]
    lines: tuple[str, ...]

    def blocks(self, words: PositionWords) -> tuple[Block, ...]:
        """The sentence and the equations."""
        points = words.listing.join(f"${point}$" for point in self.points)
        written = words.coordinates if len(self.points) == 1 else words.coordinates_of_several
        return Prose(written.format(points=points)), Display(self.lines)


def write_chapter(
    steps: Iterable[Step], instance: Instance, language: Language
) -> tuple[Block, ...]:
    """The blocks of all steps, the origin first; neighbouring points that are given by their
    coordinates share a sentence.
    """
    words, blocks = load_position_words(language), list[Block | _Coordinates]()
    for step in sorted(steps, key=lambda step: instance.axes.pair(step.tree) != (ZERO, ZERO)):
        written = _explain_construction(step, instance, language)
        before = blocks[-1] if blocks else None
        if isinstance(written, _Coordinates) and isinstance(before, _Coordinates):
            written = _Coordinates(before.points + written.points, before.lines + written.lines)
            blocks.pop()
        match written:
            case _Coordinates():
                blocks.append(written)
            case tuple():
                blocks += written
            case _:
                assert_never(written)
    return tuple(part for block in blocks for part in _write_out(block, words))


def _write_out(block: Block | _Coordinates, words: PositionWords) -> tuple[Block, ...]:
    """A block unchanged; coordinates with their sentence."""
    match block:
        case _Coordinates():
            return block.blocks(words)
        case Heading() | Prose() | Display() | TermTable() | Pictures() | Results():
            return (block,)
        case _:
            assert_never(block)


def _explain_construction(
    step: Step, instance: Instance, language: Language
) -> tuple[Block, ...] | _Coordinates:
    """The blocks of one step, or its coordinates where these are all there is to write."""
    words, tree = load_position_words(language), step.tree
    if isinstance(tree, Call) and tree.function == "meet":
        return explain_meeting(step, instance, language)
    if isinstance(tree, Call) and tree.function == "foot":
        return explain_foot(step, instance, language)
    if isinstance(tree, Call) and tree.function == "toward":
        return _explain_toward(step, instance, words)
    pair = instance.axes.pair(tree) or (ZERO, ZERO)
    if pair == (ZERO, ZERO):
        return (Prose(words.origin.format(point=instance.symbols[step.point])),)
    written, lines = (
        _write_sentence(step, instance, words),
        _write_coordinate_lines(step.point, pair, instance),
    )
    return (
        (Prose(written), Display(lines))
        if written
        else _Coordinates((instance.symbols[step.point],), lines)
    )


def _write_coordinate_lines(point: str, pair: Pair, instance: Instance) -> tuple[str, ...]:
    """x = ..., y = ... worked out."""
    name = instance.symbols[point]
    return tuple(
        line
        for axis, tree in zip("xy", pair, strict=True)
        for line in instance.equation(f"{axis}_{{{name}}}", tree)
    )


def _write_sentence(step: Step, instance: Instance, words: PositionWords) -> str:
    """Where the point of a step lies, for constructions whose coordinates follow at once; "" where
    the coordinates alone are enough.
    """
    point, tree = instance.symbols[step.point], step.tree
    match tree:
        case Name():
            return words.coincides.format(point=point, other=instance.symbols[tree.name])
        case Call(function="polar", arguments=(centre, radius, angle)):
            return _write_polar_sentence(point, (centre, radius, angle), instance, words)
        case Call(function="midpoint", arguments=(Name(first), Name(second))):
            return words.midpoint.format(
                point=point, first=instance.symbols[first], second=instance.symbols[second]
            )
        case Operation(sign="+" | "-", left=Name(base), right=right):
            vector = {"+": right, "-": negate(right, instance)}[tree.sign]
            return words.displaced.format(
                point=point,
                base=instance.symbols[base],
                vector=describe_vector(vector, instance, words),
            )
        case Number() | Operation() | Call():
            return ""
        case _:
            assert_never(tree)


def _write_polar_sentence(
    point: str,
    parts: tuple[Expression, Expression, Expression],
    instance: Instance,
    words: PositionWords,
) -> str:
    """Distance and direction from a centre; a negative distance becomes one in the opposite
    direction.
    """
    centre, radius, angle = parts
    quarters = count_quarter_turns(angle)
    against = instance.sign(radius) < 0
    texts = {
        "point": point,
        "centre": instance.symbolic(centre),
        "angle": instance.symbolic(angle, degrees=True),
        "radius": instance.symbolic(minus(ZERO, radius) if against else radius),
    }
    if quarters is not None:
        return words.beside[(quarters + 2 * against) % 4].format(**texts)
    return (words.polar_against if against else words.polar).format(**texts)


def _explain_toward(step: Step, instance: Instance, words: PositionWords) -> tuple[Block, ...]:
    """A point at a distance from one point towards another, or along a vector."""
    start, end, distance = list_parts(step.tree)
    vector = _write_way(start, end, instance)
    size, direction = length_of(vector, instance.axes), instance.axes.pair(vector)
    base = instance.axes.pair(start)
    texts = {
        "point": instance.symbols[step.point],
        "start": instance.symbolic(start),
        "end": instance.symbolic(end),
        "distance": instance.symbolic(distance),
    }
    match end:
        case Name():
            written = words.toward.format(**texts)
        case Number() | Operation() | Call():
            written = words.along.format(vector=describe_vector(vector, instance, words), **texts)
        case _:
            assert_never(end)
    if base is None or direction is None:
        return (Prose(written),)
    lines = write_length_lines(size, instance)
    reached = scale(direction, over(distance, size)) or (ZERO, ZERO)
    pair = plus(base[0], reached[0]), plus(base[1], reached[1])
    return Prose(written), Display((*lines, *_write_coordinate_lines(step.point, pair, instance)))


def _write_way(start: Expression, end: Expression, instance: Instance) -> Expression:
    """The vector from one point to another; a vector that is added to the first point is itself the
    result.
    """
    match end:
        case Operation(sign="+", left=same, right=added) if same == start:
            return added
        case Operation(sign="-", left=same, right=taken) if same == start:
            return negate(taken, instance)
        case Number() | Name() | Operation() | Call():
            return Operation("-", end, start)
        case _:
            assert_never(end)


def write_length_lines(size: Expression, instance: Instance) -> tuple[str, ...]:
    """AB = the root of the sum of squares, worked out; nothing for a length that is not the
    distance of two points.
    """
    if not isinstance(size, Call) or size.function != "distance":
        return ()
    first, second = size.arguments
    vector = instance.axes.pair(Operation("-", second, first)) or (ZERO, ZERO)
    return instance.equation(instance.symbolic(size), length_of(Call("", vector), instance.axes))
