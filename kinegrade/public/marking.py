"""`kinegrade.grade`: a marks folder, written."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import date
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import Literal

from kinegrade.errors import OptionError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.follow_through import FollowThrough
from kinegrade.files.placing.standing import Standing, find_standing
from kinegrade.grading.grade import Export, MarkingWishes
from kinegrade.grading.grade import grade as mark_class
from kinegrade.grading.judging.follow import Follows
from kinegrade.grading.marks import ClassGrades
from kinegrade.grading.policy.lapsed import describe_lapsed
from kinegrade.grading.typed.decimal_style import Mark as DecimalMark
from kinegrade.language.message import Fault, Message, Part
from kinegrade.lms.grades import moodle
from kinegrade.lms.responses.answer_table import ReadingWishes
from kinegrade.lms.responses.class_files import read_class
from kinegrade.marks_folder.cells import Record
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.layout import CHANGES, KEPT, MARKER
from kinegrade.marks_folder.rows import StudentTotal
from kinegrade.public.folders import expect_own_place
from kinegrade.public.marking_notes import (
    describe_grades,
    describe_key,
    describe_points,
    list_written,
)
from kinegrade.public.opened import expect_opened
from kinegrade.public.opening import open_marks
from kinegrade.public.options import require_known
from kinegrade.public.outcome import Outcome
from kinegrade.reports.change_log import LoggedChange, write_log
from kinegrade.reports.comparison import describe_moved


def _in_silence(assumption: Part) -> None:
    pass


@dataclass(frozen=True)
class GradeOptions:
    """How answers are read and marked.

    They come from `source`, which is detected where it is None; `encoding` is that of a CSV file
    that is not UTF-8, `decimal` the decimal mark where cells leave it open. With `unfinished`,
    attempts that were not handed in count too; with `own_papers`, students answered their own
    papers although most answers fit others. `policy` is a file of other rules; `manual` are files
    of marks by hand; `never_lower` an earlier marking whose totals stand where they are higher.
    What differs from the earlier marking `since` is added to its log of changes, with the `reason`;
    the two go together. A `pseudonymous` marking leaves names out of the folder.
    `assuming` is given each assumption as soon as it is made, before anything is marked.
    """

    source: str | None = None
    encoding: str | None = None
    unfinished: bool = False
    decimal: DecimalMark | None = None
    policy: str | PathLike[str] | None = None
    manual: str | PathLike[str] | Sequence[str | PathLike[str]] = ()
    never_lower: MarksFolder | None = None
    since: MarksFolder | None = None
    reason: str = ""
    own_papers: bool = False
    pseudonymous: bool = False
    assuming: Callable[[Part], None] = _in_silence

    @property
    def reading(self) -> ReadingWishes:
        """How files are read."""
        attempts: Literal["all", "finished"] = "all" if self.unfinished else "finished"
        return ReadingWishes(self.source, attempts, self.encoding, self.own_papers)

    @property
    def earlier(self) -> MarksFolder | None:
        """The marking whose log goes on, and whose marks by hand are carried over."""
        return self.never_lower if self.since is None else self.since

    def log(self, exam: ExamFolder) -> Mapping[str, Export]:
        """What writes the log of changes, where there is one."""
        if self.since is not None:
            day, now = date.today().isoformat(), exam.former_ids
            return {CHANGES.name: LoggedChange(self.since, self.reason.strip(), day, now).write}
        rows = () if self.earlier is None else self.earlier.log
        return {CHANGES.name: lambda _: write_log(rows)} if rows else {}

    def marking(self, exam: ExamFolder, stood: Standing) -> MarkingWishes:
        """How answers are marked, and written in place of what `stood` there."""
        return MarkingWishes(
            {moodle.FILE: moodle.export, **self.log(exam)},
            self.decimal,
            None if self.policy is None else Path(self.policy),
            self.never_lower,
            _choose_following(exam),
            self.own_papers,
            tuple(map(Path, _list_files(self.manual))),
            self.pseudonymous,
            self.earlier,
            stood,
        )


_ORDINARY = GradeOptions()


@dataclass(frozen=True, repr=False)
class Graded(Outcome):
    """A marks folder was written; `grades` are its totals and complaints in full, `assumed` what
    was taken for granted in reading the answers.
    """

    grades: ClassGrades = field(kw_only=True)
    assumed: tuple[Part, ...] = ()

    @cached_property
    def marks(self) -> MarksFolder:
        """The folder, opened."""
        return open_marks(self.path)

    def said(self) -> Iterator[Part]:
        """The assumptions, the notes, the complaints."""
        yield from self.assumed
        yield from super().said()


def grade(
    exam: ExamFolder,
    answers: str | PathLike[str] | Sequence[str | PathLike[str]],
    output: str | PathLike[str],
    *,
    force: bool = False,
    options: GradeOptions = _ORDINARY,
) -> Graded:
    """Mark a class by answer sheets or downloads, one or several, as `kinegrade grade` does.

    `output` is the marks folder, whole or not at all; `force` replaces one. Raises KinegradeError.

    >>> exam = kinegrade.open_exam("EXAM")
    >>> [grade.total for grade in grade(exam, "answers.csv", "AGAIN").grades.grades]
    [Fraction(2, 1), Fraction(0, 1)]
    >>> grade(exam, "absent.csv", "OTHER")
    Traceback (most recent call last):
    kinegrade.errors.TableError: absent.csv: cannot be read ...
    """
    expect_opened(exam=exam)
    place = Path(output)
    expect_own_place(place)
    require_known(options)
    stood = _find_replaced(place, options)
    read = read_class([Path(file) for file in _list_files(answers)], exam, options.reading)
    for assumption in read.assumed:
        options.assuming(assumption)
    lapsed, totals = _read_earlier(place, options)  # before they are replaced
    grades = mark_class(exam, read.files, place, options.marking(exam, stood), force=force)
    marks = MarksFolder(place)  # was checked before it was put there
    written = [
        *list_written(grades, place, kept=options.never_lower is not None),
        *describe_key(exam),
        *lapsed,
        *describe_moved(totals, marks, exam.former_ids),
        *describe_points(grades, marks),
        *describe_grades(marks, exam, options.policy),
    ]
    faults = (complaint.fault for complaint in grades.complaints)
    return Graded(place, tuple(written), tuple(faults), grades=grades, assumed=read.assumed)


def _find_replaced(place: Path, options: GradeOptions) -> Standing:
    """What stands there, before anything is read of it. Raises OptionError where a reason or an
    earlier marking is missing, or where a log would be lost by which changes of marks are accounted
    for.
    """
    stood = find_standing(place, MARKER)
    if (options.since is None) != (not options.reason.strip()):
        raise OptionError(Message("terminal.since-and-reason"))
    replaced = _read_log(place)
    kept = () if options.earlier is None else options.earlier.log
    if replaced and not {*replaced} <= {*kept}:
        what, do = Message("terminal.log-lost"), Message("terminal.keep-log")
        raise OptionError(Fault(str(place / CHANGES.name), what, do=do))
    return stood


def _read_earlier(
    place: Path, options: GradeOptions
) -> tuple[Sequence[Message], Sequence[StudentTotal]]:
    """Which rules of the markings before, that are replaced or followed, hold no longer, and the
    totals of the one since which changes are logged.
    """
    earlier = (each.path for each in (options.since, options.never_lower) if each is not None)
    totals = () if options.since is None else options.since.totals.students
    lapsed = describe_lapsed((place, *earlier), options.policy)
    return (*lapsed, *_describe_no_longer_kept(place, options)), totals


def _describe_no_longer_kept(place: Path, options: GradeOptions) -> Iterator[Message]:
    """That totals which the marking before kept, as it was to lower none, are not kept."""
    if options.never_lower is not None:
        return
    earlier = (MarksFolder(place), *([] if options.since is None else [options.since]))
    for folder in {marks.path.resolve(): marks for marks in earlier}.values():
        if folder.kept:
            yield Message(
                "terminal.kept-lapsed",
                file=str(folder.path / KEPT.name),
                count=len(folder.kept),
                folder=str(folder.path),
            )


def _list_files(
    given: str | PathLike[str] | Sequence[str | PathLike[str]],
) -> Sequence[str | PathLike[str]]:
    """One file or several, as several."""
    return [given] if isinstance(given, str | PathLike) else given


def _read_log(place: Path) -> tuple[Record, ...]:
    try:
        return MarksFolder(place).log
    except OSError:  # a name that is too long, which writing refuses
        return ()


def _choose_following(exam: ExamFolder) -> Follows:
    follow_through = FollowThrough(exam)
    return Follows(follow_through, follow_through.stages, follow_through.is_possible)
