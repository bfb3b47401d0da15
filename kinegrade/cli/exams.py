"""The commands that set an exam and keep it: generate, archive, verify."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

import kinegrade
from kinegrade.cli.column_choice import COLUMN
from kinegrade.cli.help import command
from kinegrade.cli.options import (
    CLUSTER,
    CYCLE,
    FILE,
    FORCE,
    JOBS,
    LANGUAGE,
    METHOD,
    ODD_IDS,
    finish,
    finish_with_complaints,
    refusing,
    require_writable,
    show_progress,
)
from kinegrade.cli.terminal import refuse_usage, say
from kinegrade.language.message import Message, list_plainly

if TYPE_CHECKING:
    from kinegrade.exam.roster.columns import Wishes

_WITH_ADD = (
    "bank",
    "roster",
    "output",
    "late",
    "columns",
    "jobs",
    "cluster",
    "allow_odd_ids",
    "strict",
    "force",
)


@command()
@click.argument("bank", type=FILE)
@click.argument("roster", type=FILE)
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="EXAM",
)
@click.option(
    "--seed",
    callback=require_writable,
    metavar="LABEL",
)
@click.option(
    "--reproducible",
    callback=require_writable,
    metavar="WORDS",
)
@click.option(
    "--new-numbers",
    is_flag=True,
)
@click.option(
    "--accept-changes",
    is_flag=True,
)
@click.option(
    "--avoid",
    type=FILE,
    multiple=True,
    metavar="EXAM",
)
@click.option(
    "--share-with-group",
    is_flag=True,
)
@click.option(
    "--add",
    "late",
    type=FILE,
    metavar="LATE",
)
@LANGUAGE
@click.option("--paper-size", type=click.Choice(["a4", "letter"]), default="a4", show_default=True)
@click.option(
    "--engine",
    type=click.Choice(["typst", "latex"]),
)
@click.option(
    "--no-papers",
    is_flag=True,
)
@click.option(
    "--solutions",
    is_flag=True,
)
@METHOD
@CYCLE
@click.option(
    "--spare",
    type=click.IntRange(0, 1000),
    default=0,
    metavar="N",
)
@click.option(
    "--also",
    multiple=True,
    type=click.Choice(["docx", "html"]),
)
@JOBS
@CLUSTER
@COLUMN
@ODD_IDS
@click.option(
    "--strict",
    is_flag=True,
)
@click.option(
    "--resume",
    is_flag=True,
)
@FORCE
@refusing
def generate(
    *,
    bank: Path,
    roster: Path,
    output: Path,
    late: Path | None,
    language: str,
    columns: Wishes,
    allow_odd_ids: bool,
    force: bool,
    **options: Any,
) -> None:
    """Draw, solve and typeset an exam for every student of ROSTER (CSV or xlsx).

    BANK is the exam's blueprint: a TOML file, or the name of one that is shipped:
    acceleration-midterm, demo, final, velocity-quiz. EXAM is readable by its owner alone; kinegrade
    papers copies what students may have. With --add, late students get papers of an EXAM that
    exists: no other paper, solution or key changes, and answers typed into EXAM stay.
    """
    if late is not None:
        _expect_no_other_wishes()
    asked = kinegrade.Bank.read(bank)
    students = kinegrade.Roster.read(roster, odd_ids=allow_odd_ids, columns=columns)
    wishes = kinegrade.GenerateOptions(progress=show_progress, **options)
    if late is None:
        finish(
            kinegrade.generate(
                asked, students, output, language=language, force=force, options=wishes
            )
        )
    else:
        exam = kinegrade.open_exam(output)
        newcomers = kinegrade.Roster.read(late, odd_ids=allow_odd_ids, columns=columns)
        finish(kinegrade.add_students(exam, asked, students, newcomers, options=wishes))


def _expect_no_other_wishes() -> None:
    """Raises UsageError where an option says how papers are to be that exist."""
    context = click.get_current_context()
    given = [
        each.opts[0]
        for each in context.command.params
        if each.name not in _WITH_ADD
        and context.get_parameter_source(str(each.name)) is ParameterSource.COMMANDLINE
    ]
    if given:
        raise refuse_usage(Message("terminal.add-alone", options=list_plainly(given)))


@command()
@click.argument("exam", type=FILE)
@click.option("--marks", type=FILE, metavar="MARKS")
@click.option("-o", "--output", type=FILE, required=True, metavar="FILE")
@FORCE
@refusing
def archive(exam: Path, *, marks: Path | None, output: Path, force: bool) -> None:
    """Keep all of EXAM in one file, with a page to print."""
    from kinegrade.exam.archiving.archive import PRIVATE, write_archive
    from kinegrade.exam.archiving.page import print_archive_page
    from kinegrade.files.output import output_file
    from kinegrade.grading.same_key import require_same_key

    folder = kinegrade.open_exam(exam)
    marked = None if marks is None else kinegrade.open_marks(marks)
    if marked is not None:
        require_same_key(folder, marked)
    page = output.with_name(f"{output.stem}-page.pdf")
    with output_file(page, force=force) as partial:
        archived = write_archive(
            folder, None if marked is None else marked.path, output, force=force
        )
        partial.write_bytes(print_archive_page(folder, archived, output))
        partial.chmod(PRIVATE)
    say(Message("archive.written", file=str(output), count=archived.files, page=str(page)))


@command()
@click.argument("path", type=FILE, metavar="FILE")
@click.option("--all", "everything", is_flag=True)
@refusing
def verify(path: Path, *, everything: bool) -> None:
    """Check an archive or an exam folder: its files, and that its key still follows."""
    from kinegrade.exam.archiving.verification import verify as verify_exam

    found = verify_exam(path, everything=everything)
    if found.files:
        say(Message("archive.compared", file=str(path), count=found.files))
    say(Message("archive.solved", file=str(path), count=found.solved, papers=found.papers))
    finish_with_complaints(found.problems)
