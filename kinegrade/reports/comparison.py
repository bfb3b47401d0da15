"""Two marks folders compared: which students change, by how much, and why.

`compare` is called by `kinegrade diff`. `write_comparison_csv` gives its file,
`write_comparison_text` its output for people. A student goes up or down by share of the points,
which means by points where both markings have the same maximum.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from kinegrade.files.csv_writing import encode_for_people, neutralise, write_csv_text
from kinegrade.grading.verdict_names import name_verdict
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import (
    Listing,
    Message,
    Part,
    Text,
    list_plainly,
    list_statements,
)
from kinegrade.language.terminal_lines import align, cut
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.hand_marks import list_hand_marks
from kinegrade.marks_folder.rows import MarkedAnswer, StudentTotal
from kinegrade.numbers.amounts import write_amount, write_change

HEADER = (
    "student", "name", "what", "before", "after", "change", "out_of_before", "out_of_after",
    "verdict_before", "verdict_after", "response_before", "response_after",
    "reason_before", "reason_after",
)  # fmt: skip
_ONLY_FIRST = Message("marks.only-first")
_ONLY_SECOND = Message("marks.only-second")
_SUBTRACTED, _GRADE = "subtracted", "grade"  # of a total, in the column of what changes
_WIDEST_NAME = 24
_NOTHING = MarkedAnswer("", "", "", "", "", "", "", Fraction(0), Fraction(0), "")
_Answers = Mapping[tuple[str, str], MarkedAnswer]  # by student and answer column
_Worth = tuple[Fraction, Fraction]  # points, and the maximum


@dataclass(frozen=True, slots=True)
class _AskChange:
    """One answer that is judged differently; a side is None where that marking does not have the
    ask.
    """

    column: str
    before: MarkedAnswer | None
    after: MarkedAnswer | None

    @property
    def change(self) -> Fraction:
        """Points gained; negative where points are lost."""
        return (self.after or _NOTHING).points - (self.before or _NOTHING).points

    @property
    def why(self) -> Part:
        """The answer before and after, and the reason for the new verdict."""
        before, after = self.before or _NOTHING, self.after or _NOTHING
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
class _StudentChange:
    """One student with any change; a side is None where that marking does not have the student."""

    student: str
    before: StudentTotal | None
    after: StudentTotal | None
    asks: tuple[_AskChange, ...]

    @property
    def is_other_total(self) -> bool:
        """Whether the total is another, of points or of a maximum, or earns another grade."""
        return _worth(self.before) != _worth(self.after) or any(self.list_changes())

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

    changes: tuple[_StudentChange, ...]
    students: int
    up: int
    down: int
    mean_points: Fraction
    mean_percent: Fraction


def compare(first: MarksFolder, second: MarksFolder) -> Comparison:
    """Compares two marks folders. Raises TableError."""
    before, after = first.totals.by_student, second.totals.by_student
    whole = {*_list_whole(first), *_list_whole(second)}
    asks = _ask_changes(_answers(first, whole), _answers(second, whole))
    found = (
        _StudentChange(
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


def write_comparison_csv(comparison: Comparison, words: Catalogue) -> bytes:
    """A CSV file: for each student the total, followed by the answers that are judged
    differently.
    """
    sides = zip(list_amounts(comparison), _list_texts(comparison, words), strict=True)
    rows = ((*amounts, *map(neutralise, texts)) for amounts, texts in sides)
    return encode_for_people(write_csv_text(HEADER, rows))


def list_amounts(comparison: Comparison) -> Iterator[tuple[str, ...]]:
    """The first eight columns: for each student the total, then the answers that are judged
    differently.
    """
    for each in comparison.changes:
        person = each.student, neutralise(each.name)
        yield (*person, "total", *_write_amounts(_worth(each.before), _worth(each.after)))
        for change in each.list_changes():
            yield (*person, *map(neutralise, change), "", "", "")
        for ask in each.asks:
            yield (*person, ask.column, *_write_amounts(_worth(ask.before), _worth(ask.after)))


def _list_texts(comparison: Comparison, words: Catalogue) -> Iterator[tuple[str, ...]]:
    """The other columns: verdicts, responses and reasons, before and after."""
    for each in comparison.changes:
        before = "" if each.before else _ONLY_SECOND
        after = _describe_kept(each.after) if each.after else _ONLY_FIRST
        yield ("", "", "", "", words.write(before), words.write(after))
        yield from (("",) * 6 for _ in each.list_changes())
        for ask in each.asks:
            sides = ask.before or _NOTHING, ask.after or _NOTHING
            parts = ("judged", "typed", "reason_given")
            yield tuple(getattr(side, part) for part in parts for side in sides)


def write_comparison_text(comparison: Comparison, words: Catalogue) -> str:
    """The same for a person: an aligned table, and a summary line."""
    rows: list[tuple[str, ...]] = []
    total = words.text("marks.total")
    for each in comparison.changes:
        person = show_in_one_line(each.student), cut(show_in_one_line(each.name), _WIDEST_NAME)
        points = _write_amounts(_worth(each.before), _worth(each.after))[:3]
        rows.append((*person, total, *points, words.write(_describe_presence(each))))
        for what, *sides in each.list_changes():
            named = words.text(f"marks.change-{what}")
            rows.append(("", "", named, *map(show_in_one_line, sides), "", ""))
        for ask in each.asks:
            points = _write_amounts(_worth(ask.before), _worth(ask.after))[:3]
            rows.append(("", "", ask.column, *points, show_in_one_line(words.write(ask.why))))
    header = [words.text(f"marks.heading-{name}") for name in (*HEADER[:6], "why")]
    table = align(header, rows, numbers=(3, 4, 5)) if rows else ""
    return f"{table}{words.write(_summarise(comparison))}"


def _answers(marks: MarksFolder, whole: Iterable[tuple[str, str]]) -> _Answers:
    """The answers, and the questions that either marking has as a whole by hand."""
    answers = {(answer.student, answer.column): answer for answer in marks.answers()}
    possible = {each.student: each.out_of for each in marks.sums()} if whole else {}
    totals = marks.totals.by_student
    for student, question in whole:
        total, mark = totals.get(student), marks.by_hand.get(student, {}).get(question)
        if total is not None and question in total.points:
            answers[student, question] = replace(
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


def _ask_changes(before: _Answers, after: _Answers) -> Mapping[str, list[_AskChange]]:
    found: dict[str, list[_AskChange]] = {}
    for place in {**before, **after}:
        student, column = place
        change = _AskChange(column, before.get(place), after.get(place))
        if _said(change.before) != _said(change.after):
            found.setdefault(student, []).append(change)
    return found


def _said(answer: MarkedAnswer | None) -> tuple[object, ...] | None:
    """The part of a verdict that matters; the wording of its reason does not."""
    return (answer.judged, answer.points, answer.out_of) if answer else None


def _worth(side: MarkedAnswer | StudentTotal | None) -> _Worth | None:
    return side.worth if side else None


def _describe_kept(total: StudentTotal) -> Text:
    """Why the total is an earlier one; empty where it is not."""
    return total.kept.reason if total.kept else ""


def _mean(amounts: Sequence[Fraction]) -> Fraction:
    return sum(amounts, Fraction(0)) / len(amounts) if amounts else Fraction(0)


def _write_amounts(before: _Worth | None, after: _Worth | None) -> tuple[str, ...]:
    """Points before, after and their change, then the maximum before and after; blank for a side
    that is missing.
    """
    points = [write_amount(side[0]) if side else "" for side in (before, after)]
    out_of = [write_amount(side[1]) if side else "" for side in (before, after)]
    change = write_change(after[0] - before[0]) if before and after else ""
    return (*points, change, *out_of)


def _describe_presence(change: _StudentChange) -> Text:
    if change.before is None:
        return _ONLY_SECOND
    if change.after is None:
        return _ONLY_FIRST
    if change.after.kept:
        return change.after.kept.reason
    worth = change.before.out_of, change.after.out_of
    if worth[0] == worth[1]:
        return ""
    return Message("marks.out-of", before=write_amount(worth[0]), after=write_amount(worth[1]))


def _summarise(comparison: Comparison) -> Listing:
    unchanged = comparison.students - comparison.up - comparison.down
    alone = [
        change for change in comparison.changes if change.before is None or change.after is None
    ]
    moved = Message("marks.moved", up=comparison.up, down=comparison.down, unchanged=unchanged)
    mean = Message(
        "marks.mean-change",
        points=write_change(comparison.mean_points),
        percent=write_change(comparison.mean_percent, places=2),
    )
    lone = [Message("marks.in-one-only", count=len(alone))] if alone else []
    return list_statements([moved, *lone, mean])
