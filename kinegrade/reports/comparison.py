"""Two marks folders compared: which students change, by how much, and why.

`compare` is called by `kinegrade diff`. A student goes up or down by share of the points, which
means by points where both markings have the same maximum.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import msgspec

from kinegrade.grading.verdict_names import name_verdict
from kinegrade.language.message import Message, Part, list_plainly
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.hand_marks import list_hand_marks
from kinegrade.marks_folder.rows import MarkedAnswer, StudentTotal
from kinegrade.numbers.amounts import write_amount

_SUBTRACTED, _GRADE = "subtracted", "grade"  # of a total, in the column of what changes
_NOTHING = MarkedAnswer("", "", "", "", "", "", "", Fraction(0), Fraction(0), "")
_Answers = Mapping[tuple[str, str], MarkedAnswer]  # by student and answer column
_AS_BEFORE: Mapping[str, str] = {}
Worth = tuple[Fraction, Fraction]  # points, and the maximum


@dataclass(frozen=True, slots=True)
class AskChange:
    """One answer that is judged differently; a side is None where that marking does not have the
    ask.
    """

    column: str
    before: MarkedAnswer | None
    after: MarkedAnswer | None

    @property
    def sides(self) -> tuple[MarkedAnswer, MarkedAnswer]:
        """The answer before and after; where that marking does not have the ask, nothing."""
        return self.before or _NOTHING, self.after or _NOTHING

    @property
    def worth(self) -> tuple[Worth | None, Worth | None]:
        """Points and their maximum, before and after."""
        return _worth(self.before), _worth(self.after)

    @property
    def change(self) -> Fraction:
        """Points gained; negative where points are lost."""
        before, after = self.sides
        return after.points - before.points

    @property
    def why(self) -> Part:
        """The answer before and after, and the reason for the new verdict."""
        before, after = self.sides
        parts: list[Part] = []
        if before.typed != after.typed:
            parts.append(f'"{before.typed}" -> "{after.typed}"')
        judged = [name_verdict(each.judged) for each in (before, after) if each.judged] or [""]
        was, now = judged[0], judged[-1]
        parts.append(now if was == now else Message("marks.from-to", before=was, after=now))
        if before.out_of != after.out_of:
            worth = write_amount(before.out_of), write_amount(after.out_of)
            parts.append(Message("marks.worth", before=worth[0], after=worth[1]))
        changes = list_plainly(parts)
        if not after.reason_given:
            return changes
        return Message("marks.why", changes=changes, reason=after.reason_given)


@dataclass(frozen=True, slots=True)
class StudentChange:
    """One student with any change; a side is None where that marking does not have the student."""

    student: str
    before: StudentTotal | None
    after: StudentTotal | None
    asks: tuple[AskChange, ...]

    @property
    def worth(self) -> tuple[Worth | None, Worth | None]:
        """The total and its maximum, before and after."""
        return _worth(self.before), _worth(self.after)

    @property
    def is_other_total(self) -> bool:
        """Whether the total is another, of points or of a maximum, or earns another grade."""
        before, after = self.worth
        return before != after or any(self.list_changes())

    @property
    def lost(self) -> tuple[str, str]:
        """The points subtracted before and after, "" for none."""
        sides = (each.subtracted if each else Fraction(0) for each in (self.before, self.after))
        before, after = (write_amount(each) if each else "" for each in sides)
        return before, after

    def list_changes(self) -> Iterator[tuple[str, str, str]]:
        """What else of the total changed, before and after: what is subtracted, and the grade."""
        if self.lost[0] != self.lost[1]:
            yield (_SUBTRACTED, *self.lost)
        if self.grades[0] != self.grades[1]:
            yield (_GRADE, *self.grades)

    @property
    def grades(self) -> tuple[str, str]:
        """The grades before and after, "" where there is none."""
        before, after = self.before, self.after
        return before.grade if before else "", after.grade if after else ""

    @property
    def name(self) -> str:
        """The name in the newer marking, if it has the student."""
        total = self.after or self.before
        return total.name if total else ""


@dataclass(frozen=True, slots=True)
class Comparison:
    """Every student with any change, in the order of the markings, and the number of students in
    both.

    `up` and `down` count students by share of the points; the means are over the students in both,
    in points and in percentage points.
    """

    changes: tuple[StudentChange, ...]
    students: int
    up: int
    down: int
    mean_points: Fraction
    mean_percent: Fraction


def compare(
    first: MarksFolder, second: MarksFolder, now: Mapping[str, str] = _AS_BEFORE
) -> Comparison:
    """Compares two marks folders; `now` gives the ids that students of the first one have by now.
    Raises TableError.
    """
    had, after = first.totals.by_student, second.totals.by_student
    before = {now.get(student, student): total for student, total in had.items()}
    asks = _ask_changes(*_list_answers(first, second, now))
    found = (
        StudentChange(
            student, before.get(student), after.get(student), tuple(asks.get(student, ()))
        )
        for student in {**before, **after}
    )
    both = [(before[student], after[student]) for student in before if student in after]
    return Comparison(
        tuple(change for change in found if change.asks or change.is_other_total),
        len(both),
        sum(new.share > old.share for old, new in both),
        sum(new.share < old.share for old, new in both),
        _mean([new.total - old.total for old, new in both]),
        _mean([100 * (new.share - old.share) for old, new in both]),
    )


def describe_moved(
    before: Sequence[StudentTotal], marks: MarksFolder, now: Mapping[str, str]
) -> Iterator[Message]:
    """How many totals went up and down, by their share of the points; nothing where none is
    compared. `now` gives the ids that students have by now.
    """
    if not before:  # as for most, whose new totals need not be read
        return
    after = marks.totals.by_student
    same = [(old, after.get(now.get(old.student, old.student))) for old in before]
    shares = [(old.share, new.share) for old, new in same if new is not None]
    up, down = sum(new > old for old, new in shares), sum(new < old for old, new in shares)
    if shares:
        yield Message("marks.moved-totals", up=up, down=down, unchanged=len(shares) - up - down)


def _list_answers(
    first: MarksFolder, second: MarksFolder, now: Mapping[str, str]
) -> tuple[_Answers, _Answers]:
    """The answers of both markings, by the ids that students have by now."""
    had = {new: old for old, new in now.items() if old in first.totals.by_student}
    whole = {(now.get(student, student), each) for student, each in _list_whole(first)}
    whole.update(_list_whole(second))
    before = _answers(first, {(had.get(student, student), each) for student, each in whole})
    renamed = {(now.get(student, student), each): said for (student, each), said in before.items()}
    return renamed, _answers(second, whole)


def _answers(marks: MarksFolder, whole: Iterable[tuple[str, str]]) -> _Answers:
    """The answers, and the questions that either marking has as a whole by hand."""
    answers = {(answer.student, answer.column): answer for answer in marks.answers()}
    possible = {each.student: each.out_of.by_question for each in marks.sums} if whole else {}
    totals = marks.totals.by_student
    for student, question in whole:
        total, mark = totals.get(student), marks.by_hand.get(student, {}).get(question)
        if total is not None and question in total.points:
            answers[student, question] = msgspec.structs.replace(
                _NOTHING,
                student=student,
                question=question,
                points=total.points[question],
                out_of=possible[student].get(question, Fraction(0)),
                by_hand=mark,
            )
    return answers


def _list_whole(marks: MarksFolder) -> Iterator[tuple[str, str]]:
    """The questions that have a mark by hand as a whole, with whose it is."""
    for mark in list_hand_marks(marks.by_hand):
        if not mark.ask:
            yield mark.student, mark.question


def _ask_changes(before: _Answers, after: _Answers) -> Mapping[str, list[AskChange]]:
    found: dict[str, list[AskChange]] = {}
    for place in {**before, **after}:
        student, column = place
        change = AskChange(column, before.get(place), after.get(place))
        if _said(change.before) != _said(change.after):
            found.setdefault(student, []).append(change)
    return found


def _said(answer: MarkedAnswer | None) -> tuple[object, ...] | None:
    """The part of a verdict that matters; the wording of its reason does not."""
    return (answer.judged, answer.points, answer.out_of) if answer else None


def _worth(side: MarkedAnswer | StudentTotal | None) -> Worth | None:
    return side.worth if side else None


def _mean(amounts: Sequence[Fraction]) -> Fraction:
    return sum(amounts, Fraction(0)) / len(amounts) if amounts else Fraction(0)
