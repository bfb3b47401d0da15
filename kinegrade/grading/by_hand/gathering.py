"""All marks by hand of a class: those of the files that are given, and those of the marks folder
that is replaced, which are never lost in silence.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from pathlib import Path

from kinegrade.errors import Problem, TableError
from kinegrade.exam.roster.student_ids import describe_restoration
from kinegrade.files.tables import read_table
from kinegrade.grading.by_hand.contradictions import find_contradictions
from kinegrade.grading.by_hand.markable import Markable
from kinegrade.grading.by_hand.reading import (
    HandFile,
    HandRow,
    read_hand_file,
)
from kinegrade.language.message import Fault, Message
from kinegrade.marks_folder.hand_marks import ByHand, group_by_student
from kinegrade.marks_folder.layout import FILLED_IN, MANUAL, MARKER, OPEN


@dataclass(frozen=True, slots=True)
class HandSources:
    """The files that are `given`, the marks folder that is replaced, and an earlier one that this
    marking follows.
    """

    given: tuple[Path, ...]
    replaced: Path
    earlier: Path | None = None

    @property
    def carried(self) -> Path | None:
        """The file whose marks are carried over: that of the folder which is replaced, or else that
        of the earlier one; None where there is none, or it is given.
        """
        folders = (self.replaced, *([self.earlier] if self.earlier else []))
        files = (folder / MANUAL.name for folder in folders)
        found = next((file for file in files if file.exists()), None)
        return None if found is None or _is_among(found, self.given) else found

    @property
    def own_lists(self) -> tuple[Path, ...]:
        """The files given that stand as we wrote them, or filled in, in a folder of marks."""
        return tuple(
            path
            for path in self.given
            if path.name in FILLED_IN and (path.parent / MARKER).exists()
        )

    @property
    def filled(self) -> Path | None:
        """The list of open questions in the folder that is replaced, unless it is given."""
        file = self.replaced / OPEN.name
        if not file.exists() or _is_among(file, self.given):
            return None
        # Earlier versions listed questions alone, and nobody typed there
        return file if "student" in read_table(file).header else None


@dataclass(frozen=True, slots=True)
class Gathered:
    """The marks, and what is to be said of them."""

    by_hand: ByHand
    notes: tuple[Problem, ...]


def gather_hand_marks(sources: HandSources, markable: Markable) -> Gathered:
    """The marks of all sources. Raises TableError with all that is wrong in any of them, and for
    points typed into a list that would be lost.
    """
    given = [read_hand_file(path, markable) for path in sources.given]
    carried = HandFile() if sources.carried is None else read_hand_file(sources.carried, markable)
    rows = list(chain.from_iterable(file.rows for file in given))
    replacing = {(row.mark.student, row.mark.column): row for row in rows}
    kept = [row for row in carried.rows if (row.mark.student, row.mark.column) not in replacing]
    faults = [
        *chain.from_iterable(file.faults for file in (*given, carried)),
        *find_contradictions([*kept, *rows]),
        *_find_lost(sources, markable, [*kept, *rows]),
    ]
    if faults:
        raise TableError(*faults)
    by_hand = group_by_student(row.mark for row in (*kept, *rows))
    files = list(zip(sources.given, given, strict=True))
    notes = *_say(files), *_say_carried(sources, carried, kept, replacing)
    return Gathered(by_hand, notes)


def _say(files: Sequence[tuple[Path, HandFile]]) -> Iterator[Problem]:
    """Of the files that are given, which rows have no points yet or do not count, and which ids
    were repaired.
    """
    for path, file in files:
        if file.restored:
            what, done = describe_restoration(file.restored)
            yield Fault(str(path), what, do=done)
        if file.unmarked:
            yield Message("marking.unmarked-rows", file=str(path), count=file.unmarked)
        yield from _say_dropped(path, file)


def _say_carried(
    sources: HandSources,
    carried: HandFile,
    kept: Sequence[HandRow],
    replacing: Mapping[tuple[str, str], HandRow],
) -> Iterator[Problem]:
    """What was carried over and replaced, and what was not as it does not count."""
    changed = sum(
        replacing[each.mark.student, each.mark.column].mark.points != each.mark.points
        for each in carried.rows
        if (each.mark.student, each.mark.column) in replacing
    )
    if kept:
        yield Message("marking.carried-over", file=str(sources.carried), count=len(kept))
    if changed:
        yield Message("marking.replaced-by-hand", file=str(sources.carried), count=changed)
    if sources.carried is not None:
        yield from _say_dropped(sources.carried, carried)


def _say_dropped(path: Path, file: HandFile) -> Iterator[Message]:
    """That points are for what the policy dropped."""
    if file.dropped:
        yield Message("marking.dropped-by-hand", file=str(path), count=file.dropped)


def _find_lost(
    sources: HandSources, markable: Markable, rows: Sequence[HandRow]
) -> Iterator[Fault]:
    """That points typed into the list of open questions would be lost with the folder."""
    if sources.filled is None:
        return
    counted = {(row.mark.student, row.mark.column, row.mark.points) for row in rows}
    typed = read_hand_file(sources.filled, markable)
    marks = [row.mark for row in typed.rows]
    lost = [mark for mark in marks if (mark.student, mark.column, mark.points) not in counted]
    if lost or typed.faults:
        what = Message("marking.typed-would-be-lost", count=len(lost) + len(typed.faults))
        do = Message("marking.give-manual", file=str(sources.filled))
        yield Fault(str(sources.filled), what, do=do)


def _is_among(file: Path, given: Sequence[Path]) -> bool:
    return file.resolve() in [path.resolve() for path in given]
