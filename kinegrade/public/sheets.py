"""`kinegrade.feedback`: a sheet for every student."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from os import PathLike
from pathlib import Path
from typing import Literal, assert_never

from kinegrade.exam.exam_wording import ExamWording, read_exam_wording
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.handing_out.handout import send_list
from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.lms.feedback_zip import Participants, pack_feedback, read_participants
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.processes.executor import open_executor
from kinegrade.public.folders import expect_own_place
from kinegrade.public.opened import expect_exam_and_marks
from kinegrade.public.options import find_language, require_known
from kinegrade.public.outcome import Outcome
from kinegrade.reports.feedback.folder import (
    PACKED,
    FeedbackWishes,
    Press,
    Text,
    list_sheets,
    write_feedback,
)

FeedbackForm = Literal["pdf", "html", "md"]


@dataclass(frozen=True)
class FeedbackOptions:
    """What students get: sheets in a `form`, with the worked solutions or without, by default as
    the bank says, and not before homework is due unless that is wanted; made by up to `jobs`
    processes, or by the workers of the `cluster` whose scheduler has that address.

    `send_list` is a table for mail merges that is written, too; `moodle` the grading worksheet of a
    Moodle assignment, for which everything is packed as moodle.zip.
    """

    form: FeedbackForm = "pdf"
    solutions: bool | None = None
    before_due: bool = False
    jobs: int = 1
    cluster: str | None = None
    send_list: str | PathLike[str] | None = None
    moodle: str | PathLike[str] | None = None


_ORDINARY = FeedbackOptions()


def feedback(
    exam: ExamFolder,
    marks: MarksFolder,
    output: str | PathLike[str],
    *,
    language: str | None = None,
    force: bool = False,
    options: FeedbackOptions = _ORDINARY,
) -> Outcome:
    """Write each student a sheet: answers, right answers, what probably went wrong; as `kinegrade
    feedback` does, in the languages of the papers unless another one is wanted.

    Raises KinegradeError; then nothing is written.

    >>> exam, marks = kinegrade.open_exam("EXAM"), kinegrade.open_marks("MARKS")
    >>> feedback(exam, marks, "FEEDBACK", options=FeedbackOptions(form="md"))
    FEEDBACK: 2 sheets; FEEDBACK/feedback.csv says which is whose
    >>> feedback(exam, marks, "FEEDBACK", language="xx")
    Traceback (most recent call last):
    kinegrade.errors.OptionError: language: unknown: "xx" - known here: ...
    """
    expect_exam_and_marks(exam, marks)
    place = Path(output)
    expect_own_place(place)
    require_known(options)
    solutions = _choose_solutions(exam, options)
    chosen = exam.language if language is None else find_language(language)
    own = _read_own_wording(exam) if language is None else {}
    participants = _read_participants(exam, options)
    pack = None if participants is None else partial(pack_feedback, exam, participants.numbers)
    wishes = FeedbackWishes(_choose_form(options.form), chosen, solutions, force, own, pack)
    wording = read_exam_wording(exam, chosen)
    with (
        _list_receivers(exam, marks, place, wishes, options) as notes,
        open_executor(options.jobs, "feedback", cluster=options.cluster) as workers,
    ):
        written = write_feedback(exam, marks, place, wording, wishes, workers=workers)
    return _tell(place, written.sheets, (*notes, *written.notes), participants)


def _choose_solutions(exam: ExamFolder, options: FeedbackOptions) -> bool:
    """Whether worked solutions are handed out. Raises ExamError where they may not be."""
    wanted = exam.head.solutions if options.solutions is None else options.solutions
    if wanted:
        _require_solutions(exam, before_due=options.before_due)
    return wanted


@contextmanager
def _list_receivers(
    exam: ExamFolder,
    marks: MarksFolder,
    place: Path,
    wishes: FeedbackWishes,
    options: FeedbackOptions,
) -> Iterator[list[Message]]:
    """The table for mail merges, where one is wanted; gives what is to be said of it."""
    if options.send_list is None:
        yield []
        return
    target, sheets = Path(options.send_list), list_sheets(exam, marks, place, wishes.form)
    with send_list(exam, place, sheets, target, force=wishes.force) as reached:
        yield [Message("terminal.send-list", file=str(target), count=reached)]


def _read_participants(exam: ExamFolder, options: FeedbackOptions) -> Participants | None:
    return None if options.moodle is None else read_participants(exam, Path(options.moodle))


def _tell(
    place: Path, count: int, notes: Sequence[Message], participants: Participants | None
) -> Outcome:
    """What was written."""
    index = str(place / "feedback.csv")
    written = Message("terminal.feedback", folder=str(place), count=count, index=index)
    if participants is None:
        return Outcome(place, (written, *notes))
    packed = Message("terminal.packed", file=str(place / PACKED), count=len(participants.numbers))
    return Outcome(place, (written, *notes, packed), participants.complaints)


def _require_solutions(exam: ExamFolder, *, before_due: bool) -> None:
    """Raises ExamError where worked solutions are not to be given out yet, or contradict the
    key.
    """
    from kinegrade.exam.due import require_due_past
    from kinegrade.exam.setting.kept_exam import KeptExam

    if not before_due:
        require_due_past(exam)
    KeptExam(exam).require_no_contradiction()


def _read_own_wording(exam: ExamFolder) -> Mapping[Language, ExamWording]:
    """The words of an exam in the languages that students have of their own."""
    spoken = {Language(each.language) for each in exam.head.students if each.language}
    return {each: read_exam_wording(exam, each) for each in spoken}


def _choose_form(form: FeedbackForm) -> Text | Press:
    """What makes the sheets of a form."""
    match form:
        case "pdf":
            from kinegrade.press.typst.feedback import print_feedback

            return print_feedback
        case "html" | "md":
            return form
        case _:
            assert_never(form)
