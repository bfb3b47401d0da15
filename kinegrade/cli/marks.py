"""The commands about answers and marks: grade, diff, report, feedback."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Literal, assert_never

import click

from kinegrade.cli.folders import expect_folders
from kinegrade.cli.options import FILE, FORCE, JOBS, finish_with_complaints, refusing
from kinegrade.counting import count_in_words
from kinegrade.language import LANGUAGES
from kinegrade.marks_folder.layout import COMPLAINTS, KEPT

if TYPE_CHECKING:
    from kinegrade.exam.folder.exam_folder import ExamFolder
    from kinegrade.grading.decimal_style import Mark as DecimalMark
    from kinegrade.grading.feedback_folder import Press, Text
    from kinegrade.grading.follow import Follows
    from kinegrade.grading.marks import ClassGrades
    from kinegrade.language import Language

    FeedbackForm = Literal["pdf", "html", "md"]

_EXAM_LANGUAGE = click.option(
    "--lang",
    "language",
    type=click.Choice(LANGUAGES),
    help="Language of the output.  [default: that of the papers]",
)


@click.command()
@click.argument("exam", type=FILE)
@click.argument("answers", type=FILE, nargs=-1, required=True)
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="MARKS",
    help="The folder of marks to write.",
)
@click.option(
    "--from",
    "source",
    type=click.Choice(["moodle", "canvas", "google-forms", "ms-forms", "wjx", "sheet"]),
    help="What ANSWERS was downloaded from.  [default: detected from its shape]",
)
@click.option(
    "--encoding",
    metavar="NAME",
    help="The encoding of ANSWERS, if it is not UTF-8, such as gb18030.",
)
@click.option(
    "--unfinished", is_flag=True, help="Also mark attempts that were not handed in (of a download)."
)
@click.option(
    "--decimal",
    type=click.Choice(["point", "comma"]),
    help="What 1,234 and 1.234 mean in ANSWERS.  [default: detected from its other cells]",
)
@click.option(
    "--policy",
    type=FILE,
    metavar="FILE",
    help="Mark by this policy (TOML): tolerances, credits ...",
)
@click.option(
    "--never-lower",
    type=FILE,
    metavar="MARKS",
    help="Let no student's share of the points fall below that in this earlier MARKS.",
)
@click.option(
    "--own-papers",
    is_flag=True,
    help="Mark each student by their own paper, even if the answers fit others or a pool was made.",
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

    \b
    Example: kinegrade grade EXAM answers.csv -o MARKS
    Moodle:  kinegrade grade EXAM responses.csv -o MARKS --from moodle
    Again:   kinegrade grade EXAM answers.csv -o MARKS2 --policy policy.toml --never-lower MARKS
    """
    from kinegrade.cli.shortlist import shorten_list
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.grading.grade import grade as mark_class
    from kinegrade.lms import moodle
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
    from kinegrade.grading.follow import Follows

    follow_through = FollowThrough(exam)
    return Follows(follow_through, follow_through.in_plan_order)


def _say(lines: Iterable[str]) -> None:
    for line in lines:
        click.echo(line, err=True)


def _list_written(marks: ClassGrades, output: Path, *, kept: bool) -> Iterator[str]:
    """What `grade` reports at its end, one line each."""
    students = count_in_words(len(marks.grades), "student")
    yield f"{output}: {students} marked, {count_in_words(len(marks.complaints), 'complaint')}"
    if kept:
        who = sum(each.kept is not None for each in marks.grades)
        keep = "keeps" if who == 1 else "keep"
        yield f"{output / KEPT.name}: {count_in_words(who, 'student')} {keep} an earlier total"


@click.command()
@click.argument("before", type=FILE, metavar="MARKS1")
@click.argument("after", type=FILE, metavar="MARKS2")
@click.option(
    "-o",
    "--output",
    type=FILE,
    metavar="FILE",
    help="Also write it as CSV, with the reasons of both.",
)
@FORCE
@refusing
def diff(before: Path, after: Path, output: Path | None, force: bool) -> None:
    """Show how the marks in MARKS2 differ from those in MARKS1: who changes, by how much, and why.

    \b
    Example: kinegrade diff MARKS MARKS2 -o changes.csv
    """
    from kinegrade.grading.comparison import compare, write_comparison_csv, write_comparison_text
    from kinegrade.marks_folder.folder import open_marks

    expect_folders((before, "MARKS"), (after, "MARKS"))
    comparison = compare(open_marks(before), open_marks(after))
    if output is not None:
        from kinegrade.files import write_file

        write_file(output, write_comparison_csv(comparison), force=force)
    click.echo(write_comparison_text(comparison))


@click.command("report")
@click.argument("exam", type=FILE)
@click.argument("marks", type=FILE)
@click.option(
    "-o", "--output", type=FILE, required=True, metavar="FILE", help="The HTML page to write."
)
@_EXAM_LANGUAGE
@FORCE
@refusing
def class_report(
    exam: Path, marks: Path, output: Path, language: Language | None, *, force: bool
) -> None:
    """Report on the class: distribution, how hard each ask was, where points were lost, whether
    papers were alike.

    \b
    Example: kinegrade report EXAM MARKS -o report.html
    """
    from kinegrade.exam.exam_wording import read_exam_wording
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.files import write_file
    from kinegrade.grading.class_report import class_report as report_on
    from kinegrade.marks_folder.folder import open_marks

    expect_folders((exam, "EXAM"), (marks, "MARKS"))
    marked, folder = open_marks(marks), open_exam(exam)
    chosen = language or folder.language
    page = report_on(marked, folder, read_exam_wording(folder, chosen), chosen)
    write_file(output, page.encode("utf-8", "backslashreplace"), force=force)


@click.command()
@click.argument("exam", type=FILE)
@click.argument("marks", type=FILE)
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="FEEDBACK",
    help="The folder of sheets to write.",
)
@click.option(
    "--format",
    "form",
    type=click.Choice(["pdf", "html", "md"]),
    default="pdf",
    show_default=True,
    help="What the sheets are written as.",
)
@click.option(
    "--solutions/--no-solutions",
    default=None,
    help="Also hand out the worked solutions that EXAM holds.  [default: what the bank says, else "
    "no-solutions]",
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
    """Write each student a sheet: their answers, right answers, what probably went wrong, points.

    \b
    Example: kinegrade feedback EXAM MARKS -o FEEDBACK --format html
    """
    from kinegrade.exam.exam_wording import read_exam_wording
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.grading.feedback_folder import FeedbackWishes, write_feedback
    from kinegrade.marks_folder.folder import open_marks
    from kinegrade.processes import open_executor

    expect_folders((exam, "EXAM"), (marks, "MARKS"))
    marked, folder = open_marks(marks), open_exam(exam)
    wanted = folder.head.solutions if solutions is None else solutions
    if wanted:
        from kinegrade.exam.kept_exam import KeptExam

        KeptExam(folder).require_no_contradiction()
    chosen = language or folder.language
    wishes = FeedbackWishes(_choose_form(form), chosen, wanted, force)
    wording = read_exam_wording(folder, chosen)
    with open_executor(jobs, "feedback") as workers:
        count = write_feedback(folder, marked, output, wording, wishes, workers=workers)
    click.echo(
        (
            f"{output}: {count_in_words(count, 'sheet')}; "
            f"{output / 'feedback.csv'} says which is whose"
        ),
        err=True,
    )


def _choose_form(form: FeedbackForm) -> Text | Press:
    """What makes the sheets of a form."""
    match form:
        case "pdf":
            from kinegrade.exam.feedback_pages import print_feedback

            return print_feedback
        case "html" | "md":
            return form
        case _:
            assert_never(form)
