"""A comparison of two marks folders, written: as a CSV file, and for people at a terminal."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.files.csv_writing import encode_for_people, neutralise, write_csv_text
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Listing, Message, Text, list_statements
from kinegrade.language.terminal_lines import align, cut
from kinegrade.marks_folder.rows import StudentTotal
from kinegrade.numbers.amounts import write_amount, write_change
from kinegrade.reports.comparison import Comparison, StudentChange, Worth

HEADER = (
    "student", "name", "what", "before", "after", "change", "out_of_before", "out_of_after",
    "verdict_before", "verdict_after", "response_before", "response_after",
    "reason_before", "reason_after",
)  # fmt: skip
_ONLY_FIRST = Message("marks.only-first")
_ONLY_SECOND = Message("marks.only-second")
_WIDEST_NAME = 24


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
        yield (*person, "total", *_write_amounts(*each.worth))
        for change in each.list_changes():
            yield (*person, *map(neutralise, change), "", "", "")
        for ask in each.asks:
            yield (*person, ask.column, *_write_amounts(*ask.worth))


def _list_texts(comparison: Comparison, words: Catalogue) -> Iterator[tuple[str, ...]]:
    """The other columns: verdicts, responses and reasons, before and after."""
    for each in comparison.changes:
        before = "" if each.before else _ONLY_SECOND
        after = _describe_kept(each.after) if each.after else _ONLY_FIRST
        yield ("", "", "", "", words.write(before), words.write(after))
        yield from (("",) * 6 for _ in each.list_changes())
        for ask in each.asks:
            parts = ("judged", "typed", "reason_given")
            yield tuple(getattr(side, part) for part in parts for side in ask.sides)


def write_comparison_text(comparison: Comparison, words: Catalogue) -> str:
    """The same for a person: an aligned table, and a summary line."""
    rows: list[tuple[str, ...]] = []
    total = words.text("marks.total")
    for each in comparison.changes:
        person = show_in_one_line(each.student), cut(show_in_one_line(each.name), _WIDEST_NAME)
        points = _write_amounts(*each.worth)[:3]
        above = len(rows)
        if each.is_other_total or not each.asks:
            rows.append(("", "", total, *points, words.write(_describe_presence(each))))
        for what, *sides in each.list_changes():
            named = words.text(f"marks.change-{what}")
            rows.append(("", "", named, *map(show_in_one_line, sides), "", ""))
        for ask in each.asks:
            points = _write_amounts(*ask.worth)[:3]
            rows.append(("", "", ask.column, *points, show_in_one_line(words.write(ask.why))))
        rows[above] = (*person, *rows[above][2:])
    header = [words.text(f"marks.heading-{name}") for name in (*HEADER[:6], "why")]
    table = align(header, rows, numbers=(3, 4, 5)) if rows else ""
    return f"{table}{words.write(_summarise(comparison))}"


def _describe_kept(total: StudentTotal) -> Text:
    """Why the total is an earlier one; empty where it is not."""
    return total.kept.reason if total.kept else ""


def _write_amounts(before: Worth | None, after: Worth | None) -> tuple[str, ...]:
    """Points before, after and their change, then the maximum before and after; blank for a side
    that is missing.
    """
    points = [write_amount(side[0]) if side else "" for side in (before, after)]
    out_of = [write_amount(side[1]) if side else "" for side in (before, after)]
    change = write_change(after[0] - before[0]) if before and after else ""
    return (*points, change, *out_of)


def _describe_presence(change: StudentChange) -> Text:
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
