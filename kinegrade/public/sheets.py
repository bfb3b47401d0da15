"""`kinegrade.feedback`: a sheet for every student."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Literal, assert_never

from kinegrade.exam.exam_wording import ExamWording, read_exam_wording
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.processes.executor import open_executor
from kinegrade.public.folders import expect_own_place
from kinegrade.public.opened import expect_exam_and_marks
from kinegrade.public.options import find_language, require_known
from kinegrade.public.outcome import Outcome
from kinegrade.reports.feedback.folder import FeedbackWishes, Press, Text, write_feedback

FeedbackForm = Literal["pdf", "html", "md"]


@dataclass(frozen=True)
class FeedbackOptions:
    """What students get: sheets in a `form`, with the worked solutions or without, by default as
    the bank says, and not before homework is due unless that is wanted; made by up to `jobs`
    processes.
    """

    form: FeedbackForm = "pdf"
    solutions: bool | None = None
    before_due: bool = False
    jobs: int = 1


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
    solutions = exam.head.solutions if options.solutions is None else options.solutions
    chosen = exam.language if language is None else find_language(language)
    if solutions:
        _require_solutions(exam, before_due=options.before_due)
    own = _read_own_wording(exam) if language is None else {}
    wishes = FeedbackWishes(_choose_form(options.form), chosen, solutions, force, own)
    wording = read_exam_wording(exam, chosen)
    with open_executor(options.jobs, "feedback") as workers:
        count = write_feedback(exam, marks, place, wording, wishes, workers=workers)
    index = str(place / "feedback.csv")
    return Outcome(
        place, (Message("terminal.feedback", folder=str(place), count=count, index=index),)
    )


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
