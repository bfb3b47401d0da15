"""Where the points are: by their constructions, and where these would tell more than the figure, by
what the figure marks.

A construction by distances, directions and common points of lines and circles says how a person
would draw the figure. Coordinates with sines in them work something out already: they are said only
where joints and marks leave a position open.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import assert_never

from kinegrade.description.determined import (
    Rank,
    joint_condition,
    mark_condition,
    place_condition,
)
from kinegrade.description.directions import say_direction
from kinegrade.description.marks import Mark, list_ends, list_marks, say_frame, say_mark, say_side
from kinegrade.description.places import say_place
from kinegrade.description.subject import Subject
from kinegrade.expressions.tree import Call, Expression, Name, Number, Operation, find_names, walk
from kinegrade.language.message import Message
from kinegrade.worked.construction_steps import Step

_TAKEN_FROM_TRIANGLES = frozenset({"sin", "cos", "tan", "asin", "acos", "atan"})


def say_positions(subject: Subject) -> Iterator[Message]:
    """A sentence for each point that is constructed simply; then further constructions and marks as
    far as they are needed; then the frames of axes on bodies.
    """
    told = choose_told(subject)
    for step in told.steps:
        direction = say_direction(step, told.find_named(step), subject)
        named = replace(step, tree=subject.numbers.name(step.tree))
        yield direction or say_place(named, subject.telling)
    yield from (say_mark(mark, subject) for mark in told.marks)
    for point in told.placed:
        side = say_side(point, _find_neighbour(point, told.marks, subject), subject)
        yield from () if side is None else (side,)
    for frame in subject.marks.frames:
        if {frame.at, frame.start} <= subject.points:
            yield say_frame(frame, subject)


@dataclass(frozen=True)
class Told:
    """The constructions and marks that are said, and the points that marks and joints place."""

    steps: tuple[Step, ...]
    marks: tuple[Mark, ...]
    placed: tuple[str, ...]

    def find_named(self, step: Step) -> set[str]:
        """The points that marks and the other constructions name."""
        named = {name for other in self.steps for name in find_names(other.tree) if other != step}
        return named | {end for mark in self.marks for end in list_ends(mark)}


def choose_told(subject: Subject) -> Told:
    """Simple constructions and joints are said anyway; of the others those without which marks
    leave a position open, and points at a named distance from which simple ones start; then the
    marks that say more than constructions: what joints say on top may leave two positions where a
    mark leaves one.
    """
    simple = [step for step in subject.steps if not works_out(step.tree, subject)]
    others = [step for step in subject.steps if step not in simple]
    if not others:
        return Told(_drop_idle(simple, (), subject), (), ())
    rank = _rank_steps(simple, subject)
    _add_joints(rank, subject)
    for mark in list_marks(subject):
        rank.add(mark_condition(mark, subject))
    starts = {name for step in simple for name in find_names(step.tree)}
    conditions = [(step, place_condition(step, subject)) for step in others]
    needed = [step for step, one in conditions if rank.add(one) or _is_told_start(step, starts)]
    rank = _rank_steps([*simple, *needed], subject)
    marks = tuple(mark for mark in list_marks(subject) if rank.add(mark_condition(mark, subject)))
    placed = tuple(step.point for step in others if step not in needed)
    return Told(_drop_idle([*simple, *needed], marks, subject), marks, placed)


def _is_told_start(step: Step, starts: set[str]) -> bool:
    """Whether other constructions start from a point that lies at a named distance in a
    direction.
    """
    match step.tree:
        case Call(function="polar", arguments=(_, Name(), _)):
            return step.point in starts
        case Call() | Name() | Number() | Operation():
            return False
        case _:
            assert_never(step.tree)


def _rank_steps(steps: Iterable[Step], subject: Subject) -> Rank:
    """What constructions say."""
    rank = Rank(subject)
    for step in steps:
        rank.add(place_condition(step, subject))
    return rank


def _add_joints(rank: Rank, subject: Subject) -> None:
    """What the joints say on top."""
    for joint, sentence in subject.joints:
        condition = joint_condition(joint, sentence, subject)
        if condition is not None:
            rank.add(condition)


def _drop_idle(steps: Iterable[Step], marks: Iterable[Mark], subject: Subject) -> tuple[Step, ...]:
    """The steps in the template's order, without the auxiliary points that nothing names."""
    said = set(steps)
    named = subject.named_points | {end for mark in marks for end in list_ends(mark)}
    named |= {name for step in said for name in find_names(step.tree)}
    return tuple(step for step in subject.steps if step in said and step.point in named)


def works_out(tree: Expression, subject: Subject) -> bool:
    """Whether a construction has coordinates or distances that are worked out with sines, or
    lengths that follow.
    """
    lengths = subject.template.scheme.lengths
    if not lengths.keys().isdisjoint(find_names(tree)):
        return True
    calls = [part for part in walk(tree) if isinstance(part, Call)]
    return any(call.function in _TAKEN_FROM_TRIANGLES for call in calls)


def _find_neighbour(point: str, told: Iterable[Mark], subject: Subject) -> str:
    """Another point of a mark that places a point; the first point where there is none."""
    ends = [list_ends(mark) for mark in told if point in list_ends(mark)]
    others = [other for each in ends for other in each if other != point]
    return (others or [subject.steps[0].point])[0]
