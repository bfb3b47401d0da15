"""The commands about answers and marks: grade, diff, report, feedback."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Literal, assert_never

import click

from kinegrade.cli.folders import expect_folders
from kinegrade.cli.help import command
from kinegrade.cli.language_choice import LanguageChoice
from kinegrade.cli.late_choice import LateChoice
from kinegrade.cli.options import FILE, FORCE, JOBS, LANGUAGE, finish_with_complaints, refusing
from kinegrade.cli.terminal import say, terminal_words
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Message, Part
from kinegrade.marks_folder.layout import COMPLAINTS, KEPT

if TYPE_CHECKING:
    from kinegrade.exam.folder.exam_folder import ExamFolder
    from kinegrade.grading.judging.follow import Follows
    from kinegrade.grading.marks import ClassGrades
    from kinegrade.grading.typed.decimal_style import Mark as DecimalMark
    from kinegrade.language import Language
    from kinegrade.reports.feedback.folder import Press, Text

    FeedbackForm = Literal["pdf", "html", "md"]


def _list_sources() -> Iterable[str]:
    from kinegrade.lms.responses.detection import DIALECTS

    return DIALECTS


_EXAM_LANGUAGE = click.option(
    "--lang",
    "language",
    type=LanguageChoice(),
)


@command()
@click.argument("exam", type=FILE)
@click.argument("answers", type=FILE, nargs=-1, required=True)
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="MARKS",
)
@click.option(
    "--from",
    "source",
    type=LateChoice(_list_sources),
)
@click.option(
    "--encoding",
    metavar="NAME",
)
@click.option(
    "--unfinished",
    is_flag=True,
)
@click.option(
    "--decimal",
    type=click.Choice(["point", "comma"]),
)
@click.option(
    "--policy",
    type=FILE,
    metavar="FILE",
)
@click.option(
    "--never-lower",
    type=FILE,
    metavar="MARKS",
)
@click.option(
    "--own-papers",
    is_flag=True,
)
@FORCE
@refusing
def grade(
    *,
    exam: Path,
    answers: tuple[Path, ...],
    output: Path,
    source: str | None,
    encoding: str | None,
    unfinished: bool,
    decimal: DecimalMark | None,
    policy: Path | None,
    never_lower: Path | None,
    own_papers: bool,
    force: bool,
) -> None:
    """Mark the class by ANSWERS: EXAM/answers.csv filled in, or a download (CSV, xlsx).

    Several ANSWERS are one class: the quizzes of versions, or parts of the exam that several people
    typed.
    """
    from kinegrade.cli.shortlist import shorten_list
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.grading.grade import grade as mark_class
    from kinegrade.lms.grades import moodle
    from kinegrade.lms.responses.class_files import ReadingWishes, read_class
    from kinegrade.marks_folder.folder import open_marks

    expect_folders((exam, "EXAM"), (never_lower, "MARKS"))
    earlier = None if never_lower is None else open_marks(never_lower)
    folder = open_exam(exam)
    how = ReadingWishes(source, "all" if unfinished else "finished", encoding, own_papers)
    read = read_class(answers, folder, how)
    _say(read.assumed)
    marks = mark_class(
        folder,
        read.files,
        output,
        force=force,
        exports={"moodle.csv": moodle.export},
        decimal=decimal,
        policy=policy,
        never_lower=earlier,
        follows=_choose_following(folder),
        own_papers=own_papers,
    )
    _say(_list_written(marks, output, kept=never_lower is not None))
    finish_with_complaints(shorten_list(marks.complaints, output / COMPLAINTS.name))


def _choose_following(exam: ExamFolder) -> Follows:
    from kinegrade.exam.follow_through import FollowThrough
    from kinegrade.grading.judging.follow import Follows

    follow_through = FollowThrough(exam)
    return Follows(follow_through, follow_through.in_plan_order)


def _say(lines: Iterable[Part]) -> None:
    for line in lines:
        say(line)


def _list_written(marks: ClassGrades, output: Path, *, kept: bool) -> Iterator[Message]:
    """What `grade` reports at its end, one line each."""
    complaints = Message("terminal.complaints", count=len(marks.complaints))
    yield Message(
        "terminal.marked", folder=str(output), count=len(marks.grades), complaints=complaints
    )
    if kept:
        who = sum(each.kept is not None for each in marks.grades)
        yield Message("terminal.kept-totals", file=str(output / KEPT.name), count=who)


@command()
@click.argument("before", type=FILE, metavar="MARKS1")
@click.argument("after", type=FILE, metavar="MARKS2")
@click.option(
    "-o",
    "--output",
    type=FILE,
    metavar="FILE",
)
@LANGUAGE
@FORCE
@refusing
def diff(
    before: Path, after: Path, output: Path | None, language: Language, *, force: bool
) -> None:
    """Show how the marks in MARKS2 differ from those in MARKS1."""
    from kinegrade.marks_folder.folder import open_marks
    from kinegrade.reports.comparison import compare, write_comparison_csv, write_comparison_text

    expect_folders((before, "MARKS"), (after, "MARKS"))
    comparison = compare(open_marks(before), open_marks(after))
    if output is not None:
        from kinegrade.files.output import write_file

        content = write_comparison_csv(comparison, open_catalogue(language))
        write_file(output, content, force=force)
    click.echo(write_comparison_text(comparison, terminal_words()))


@command("report")
@click.argument("exam", type=FILE)
@click.argument("marks", type=FILE)
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="FILE",
)
@_EXAM_LANGUAGE
@FORCE
@refusing
def class_report(
    exam: Path, marks: Path, output: Path, language: Language | None, *, force: bool
) -> None:
    """Report on the class: distribution, how hard each ask was, where points were lost, whether
    papers were alike.
    """
    from kinegrade.exam.exam_wording import read_exam_wording
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.files.output import write_file
    from kinegrade.marks_folder.folder import open_marks
    from kinegrade.reports.classes.page import class_report as report_on

    expect_folders((exam, "EXAM"), (marks, "MARKS"))
    marked, folder = open_marks(marks), open_exam(exam)
    chosen = language or folder.language
    page = report_on(marked, folder, read_exam_wording(folder, chosen), chosen)
    write_file(output, page.encode("utf-8", "backslashreplace"), force=force)


@command()
@click.argument("exam", type=FILE)
@click.argument("marks", type=FILE)
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="FEEDBACK",
)
@click.option(
    "--format",
    "form",
    type=click.Choice(["pdf", "html", "md"]),
    default="pdf",
    show_default=True,
)
@click.option(
    "--solutions/--no-solutions",
    default=None,
)
@_EXAM_LANGUAGE
@JOBS
@FORCE
@refusing
def feedback(
    *,
    exam: Path,
    marks: Path,
    output: Path,
    form: FeedbackForm,
    solutions: bool | None,
    language: Language | None,
    jobs: int,
    force: bool,
) -> None:
    """Write each student a sheet: answers, right answers, what probably went wrong."""
    from kinegrade.exam.exam_wording import read_exam_wording
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.marks_folder.folder import open_marks
    from kinegrade.processes.executor import open_executor
    from kinegrade.reports.feedback.folder import FeedbackWishes, write_feedback

    expect_folders((exam, "EXAM"), (marks, "MARKS"))
    marked, folder = open_marks(marks), open_exam(exam)
    wanted = folder.head.solutions if solutions is None else solutions
    if wanted:
        from kinegrade.exam.setting.kept_exam import KeptExam

        KeptExam(folder).require_no_contradiction()
    chosen = language or folder.language
    wishes = FeedbackWishes(_choose_form(form), chosen, wanted, force)
    wording = read_exam_wording(folder, chosen)
    with open_executor(jobs, "feedback") as workers:
        count = write_feedback(folder, marked, output, wording, wishes, workers=workers)
    index = str(output / "feedback.csv")
    say(Message("terminal.feedback", folder=str(output), count=count, index=index))


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
