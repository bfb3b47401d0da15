"""All marks by hand of a class: those of the files that are given, and those of the marks folder
that is replaced, which are never lost in silence.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain
from pathlib import Path

from kinegrade.errors import Problem, TableError
from kinegrade.exam.roster.student_ids import StudentIds
from kinegrade.files.tables import read_table
from kinegrade.grading.by_hand.contradictions import find_contradictions
from kinegrade.grading.by_hand.hand_file import HandFile, HandRow, Newer
from kinegrade.grading.by_hand.markable import Markable
from kinegrade.grading.by_hand.reading import read_hand_file
from kinegrade.grading.by_hand.sorted_points import describe_sorted
from kinegrade.grading.by_hand.staying import StayingMarks
from kinegrade.language.message import Fault, Message, Quoted, list_first
from kinegrade.marks_folder.hand_marks import EXTRA, ByHand, group_by_student
from kinegrade.marks_folder.layout import FILLED_IN, LEFT_OUT, MANUAL, MARKER, OPEN
from kinegrade.numbers.amounts import PLACES, add_amounts, write_amount

_NAMED = 5  # marks that a message names


@dataclass(frozen=True, slots=True)
class HandSources:
    """The files that are `given`, the marks folder that is replaced, and an earlier one that this
    marking follows.
    """

    given: tuple[Path, ...]
    replaced: Path
    earlier: Path | None = None

    @property
    def carried(self) -> tuple[Path, ...]:
        """The files whose marks are carried over: those of the folder which is replaced, or else
        those of the earlier one, without any that is given.
        """
        folders = (self.replaced, *([self.earlier] if self.earlier else []))
        kept = (_list_kept(folder) for folder in folders)
        found = next((files for files in kept if files), ())
        return tuple(file for file in found if not _is_among(file, self.given))

    @property
    def own_lists(self) -> tuple[Path, ...]:
        """The files given that stand as we wrote them, or filled in, in a folder of marks."""
        return tuple(
            path
            for path in self.given
            if path.name in FILLED_IN and (path.parent / MARKER).exists()
        )

    @property
    def filled(self) -> tuple[Path, ...]:
        """The list of open questions in the folder that is replaced, unless it is given."""
        file = self.replaced / OPEN.name
        if not file.exists() or _is_among(file, self.given):
            return ()
        # Earlier versions listed questions alone, and nobody typed there
        return (file,) if "student" in read_table(file).header else ()


@dataclass(frozen=True, slots=True)
class Gathered:
    """The marks, those `left_out` as the policy drops what they are for, the `comments` on what has
    no points yet, by student and question, the `codes` of papers by which answers were typed, by
    student, and what is to be said of all marks.
    """

    by_hand: ByHand
    left_out: ByHand
    comments: Mapping[tuple[str, str], str]
    codes: Mapping[str, str]
    notes: tuple[Problem, ...]

    @property
    def students(self) -> Set[str]:
        """Those who have a mark by hand, whether it counts or not, and so handed in."""
        return {*self.by_hand, *self.left_out}


def gather_hand_marks(sources: HandSources, markable: Markable, staying: StayingMarks) -> Gathered:
    """The marks of all sources. Raises TableError with all that is wrong in any of them, and for
    points typed into a list that would be lost.
    """
    given = [read_hand_file(path, markable) for path in sources.given]
    filled = [read_hand_file(path, markable) for path in sources.filled]
    rows = _Rows.join(given)
    newer = Newer(rows.points)
    carried = [read_hand_file(path, markable, newer) for path in sources.carried]
    kept = _Rows.join(carried)
    faults = [
        *chain.from_iterable(file.faults for file in (*given, *carried)),
        *find_contradictions([*kept.all, *rows.all]),
        *_find_beside(sources.given, given, {*kept.points, *rows.points}),
        *_find_lost(sources.filled, filled, [*kept.all, *rows.all]),
    ]
    if faults:
        raise TableError(*faults)
    notes = (
        *_say(sources.given, given, markable),
        *_say_carried(sources.carried, carried, markable),
        *staying.describe((*sources.given, *sources.carried), (*given, *carried)),
    )
    return Gathered(
        group_by_student(row.mark for row in (*kept.counted, *rows.counted)),
        group_by_student(row.mark for row in (*kept.left_out, *rows.left_out)),
        dict(chain.from_iterable(file.comments.items() for file in (*filled, *given))),
        staying.codes,
        notes,
    )


@dataclass(frozen=True, slots=True)
class _Rows:
    """The rows of several files: those that are `counted`, and those `left_out`."""

    counted: tuple[HandRow, ...]
    left_out: tuple[HandRow, ...]

    @classmethod
    def join(cls, files: Sequence[HandFile]) -> _Rows:
        """The rows of all these files."""
        counted = chain.from_iterable(file.rows for file in files)
        return cls(tuple(counted), tuple(chain.from_iterable(file.left_out for file in files)))

    @property
    def all(self) -> tuple[HandRow, ...]:
        """Both."""
        return (*self.counted, *self.left_out)

    @property
    def points(self) -> Mapping[tuple[str, str], Fraction]:
        """What each row gives, by whom and what it marks."""
        return {row.mark.place: row.mark.points for row in self.all}


def _list_kept(folder: Path) -> tuple[Path, ...]:
    """The files of marks by hand in a marks folder."""
    files = (folder / MANUAL.name, folder / LEFT_OUT.name)
    return tuple(file for file in files if file.exists())


def _say(paths: Sequence[Path], files: Sequence[HandFile], markable: Markable) -> Iterator[Problem]:
    """Of the files that are given, which rows have no points yet, and which points were perhaps
    sorted alone.
    """
    for path, file in zip(paths, files, strict=True):
        for each in describe_sorted(file.rows, markable.students):
            yield Fault(str(path), each, do=Message("marking.points-count-as-they-stand"))
        yield from _find_high_bonuses(file, markable)
        if file.unmarked:
            yield Message("marking.unmarked-rows", file=str(path), count=file.unmarked)
        yield from _say_kept(path, file, markable.ids)


def _find_high_bonuses(file: HandFile, markable: Markable) -> Iterator[Fault]:
    """Each bonus of more points than the whole exam has: it may be a slip of the hand."""
    whole = add_amounts(markable.maxima[question] for question in markable.questions)
    for row in file.rows:
        if row.mark.question == EXTRA and row.mark.points > whole:
            points, maximum = write_amount(row.mark.points), write_amount(whole)
            what = Message("marking.high-bonus", points=points, maximum=maximum)
            yield Fault(row.where, what, do=Message("marking.check-bonus"))


def _say_carried(
    paths: Sequence[Path], files: Sequence[HandFile], markable: Markable
) -> Iterator[Problem]:
    """What was carried over and replaced, and what does not count."""
    for path, file in zip(paths, files, strict=True):
        if file.rows:
            yield Message("marking.carried-over", file=str(path), count=len(file.rows))
        if file.replaced:
            yield Message("marking.replaced-by-hand", file=str(path), count=file.replaced)
        yield from _say_kept(path, file, markable.ids)


def _say_kept(path: Path, file: HandFile, ids: StudentIds) -> Iterator[Problem]:
    """Which ids were repaired, which marks went with a paper, and which are kept and do not
    count.
    """
    for what, done in ids.describe_restored(file.restored):
        yield Fault(str(path), what, do=done)
    if file.followed:
        yield Message("marking.followed-paper", file=str(path), count=file.followed)
    kept = LEFT_OUT.name
    if file.dropped:
        count = len(file.dropped)
        yield Message("marking.dropped-by-hand", file=str(path), count=count, kept=kept)
    if file.not_held:
        count, named = len(file.not_held), [" ".join(row.mark.place) for row in file.not_held]
        names = list_first(named, _NAMED)
        said = "marking.not-held-by-hand"
        yield Message(said, file=str(path), count=count, kept=kept, names=names)


def _find_beside(
    paths: Sequence[Path], files: Sequence[HandFile], marked: Set[tuple[str, str]]
) -> Iterator[Fault]:
    """That a comment without points is on what has some: it would be lost."""
    for path, file in zip(paths, files, strict=True):
        for student, question in sorted(file.comments.keys() & marked):
            what = Message("marking.points-are", cell=Quoted(""))
            expected = Message("marking.hand-points", places=PLACES)
            yield Fault(f"{path}: {student}: {question}", what, expected)


def _find_lost(
    paths: Sequence[Path], files: Sequence[HandFile], rows: Sequence[HandRow]
) -> Iterator[Fault]:
    """That points typed into the list of open questions would be lost with the folder."""
    counted = {(row.mark.place, row.mark.points) for row in rows}
    for path, typed in zip(paths, files, strict=True):
        marks = [row.mark for row in (*typed.rows, *typed.left_out)]
        lost = [mark for mark in marks if (mark.place, mark.points) not in counted]
        if lost or typed.faults:
            what = Message("marking.typed-would-be-lost", count=len(lost) + len(typed.faults))
            yield Fault(str(path), what, do=Message("marking.give-manual", file=str(path)))


def _is_among(file: Path, given: Sequence[Path]) -> bool:
    return file.resolve() in [path.resolve() for path in given]
