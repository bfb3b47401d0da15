"""The commands that set an exam and give out its papers: generate, papers, paper."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click
from click.core import ParameterSource

from kinegrade.cli.folders import expect_folders
from kinegrade.cli.help import command
from kinegrade.cli.options import (
    FILE,
    FORCE,
    JOBS,
    LANGUAGE,
    METHOD,
    finish_with_complaints,
    refusing,
    require_writable,
    show_progress,
)
from kinegrade.cli.terminal import refuse_usage, say, say_of
from kinegrade.language.message import Message, list_plainly

if TYPE_CHECKING:
    from kinegrade.exam.folder.exam_secret import SecretWish
    from kinegrade.exam.generating.generate import Generated
    from kinegrade.language import Language
    from kinegrade.press.protocol import Engine
    from kinegrade.press.sheet import PaperSize
    from kinegrade.problem.template.template import Method

_WITH_ADD = ("bank", "roster", "output", "late", "jobs", "allow_odd_ids", "strict", "force")


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
    "label",
    callback=require_writable,
    metavar="LABEL",
)
@click.option(
    "--reproducible",
    "words",
    callback=require_writable,
    metavar="WORDS",
)
@click.option(
    "--new-numbers",
    is_flag=True,
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
    "--solutions/--no-solutions",
    default=True,
    show_default=True,
)
@METHOD
@click.option(
    "--also",
    multiple=True,
    type=click.Choice(["docx", "html"]),
)
@JOBS
@click.option(
    "--allow-odd-ids",
    is_flag=True,
)
@click.option(
    "--strict",
    is_flag=True,
)
@FORCE
@refusing
def generate(
    *,
    bank: Path,
    roster: Path,
    output: Path,
    label: str | None,
    words: str | None,
    new_numbers: bool,
    share_with_group: bool,
    late: Path | None,
    language: Language,
    paper_size: PaperSize,
    engine: Engine | None,
    solutions: bool,
    method: Method | None,
    also: tuple[str, ...],
    jobs: int,
    allow_odd_ids: bool,
    strict: bool,
    force: bool,
) -> None:
    """Draw, solve and typeset an exam for every student of ROSTER (CSV: student, name).

    BANK is the exam's blueprint: a TOML file, or the name of one that is shipped:
    acceleration-midterm, demo, final, velocity-quiz. EXAM is readable by its owner alone; kinegrade
    papers copies what students may have. With --add, late students get papers of an EXAM that
    exists: no other paper, solution or key changes, and answers typed into EXAM stay.
    """
    from kinegrade.exam.bank.bank import find_bank, read_blueprint
    from kinegrade.exam.generating.generate import PRIVATE, SHARED_WITH_GROUP, Place, Printing
    from kinegrade.exam.generating.generate import generate as write_exam
    from kinegrade.exam.printing.printing import Extras
    from kinegrade.exam.roster.roster import read_roster

    if late is not None:
        _add(output, bank, roster, late, odd_ids=allow_odd_ids, strict=strict, jobs=jobs)
        return
    written = write_exam(
        read_blueprint(find_bank(bank)),
        read_roster(roster, odd_ids=allow_odd_ids),
        Place(output, force, SHARED_WITH_GROUP if share_with_group else PRIVATE),
        _read_wish(label, words, new=new_numbers),
        language,
        strict=strict,
        printing=Printing(paper_size, engine, jobs),
        extras=Extras(solutions, method, tuple(dict.fromkeys(also))),
        progress=show_progress,
    )
    if written.dealt.secret.guessable:
        kept = Message("terminal.keeps-words", exam=str(output))
        say(kept if words is None else Message("terminal.words-cost"))
    _say(written, output)
    finish_with_complaints(written.complaints)


def _add(
    exam: Path, bank: Path, roster: Path, late: Path, *, odd_ids: bool, strict: bool, jobs: int
) -> None:
    """Add the students of LATE to an exam. Raises UsageError where something is wanted otherwise
    than the exam has it.
    """
    from kinegrade.exam.bank.bank import find_bank, read_blueprint
    from kinegrade.exam.generating.adding import add_students
    from kinegrade.exam.roster.roster import read_roster

    _expect_no_other_wishes()
    expect_folders((exam, "EXAM"))
    added = add_students(
        exam,
        read_blueprint(find_bank(bank)),
        read_roster(roster, odd_ids=odd_ids),
        read_roster(late, odd_ids=odd_ids),
        strict=strict,
        jobs=jobs,
        progress=show_progress,
    )
    say_of(exam, added.summary)
    finish_with_complaints(added.complaints)


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


def _read_wish(label: str | None, words: str | None, *, new: bool) -> SecretWish:
    """What the numbers are to be drawn from.

    Raises UsageError where two things are wanted that exclude each other.
    """
    from kinegrade.exam.folder.exam_secret import SecretWish

    if label is not None and words is not None:
        raise refuse_usage(Message("terminal.seed-or-words"))
    return SecretWish(label, words, new)


def _say(written: Generated, output: Path) -> None:
    from kinegrade.draws.deal import count_reasons

    for question, template in written.drawn.items():
        say(Message("terminal.drawn", question=question, template=template))
    refusals = written.dealt.refusals()
    for question, combinations in written.dealt.combinations().items():
        say(
            Message(
                "terminal.combinations",
                question=question,
                count=combinations,
                refused=count_reasons(refusals[question]),
            )
        )
    if written.changes is not None:
        say_of(output, written.changes.summary)
    for remark in written.remarks:
        say_of(output, remark)
    say(Message("terminal.generated", exam=str(output), count=written.papers))


@command()
@click.argument("exam", type=FILE)
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="DIR",
)
@FORCE
@refusing
def papers(exam: Path, output: Path, *, force: bool) -> None:
    """Copy from EXAM what students may have: everybody's paper as PDF, and for Word and the browser
    where it exists.
    """
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.exam.printing.handout import hand_out

    expect_folders((exam, "EXAM"))
    count = hand_out(open_exam(exam), output, force=force)
    say(Message("terminal.handed-out", folder=str(output), count=count))


@command()
@click.argument("exam", type=FILE)
@click.argument("student")
@click.option(
    "--solution",
    is_flag=True,
)
@click.option(
    "-o",
    "--output",
    type=FILE,
    metavar="FILE",
)
@FORCE
@refusing
def paper(exam: Path, student: str, output: Path | None, *, solution: bool, force: bool) -> None:
    """Print the paper of one STUDENT again, by id, as EXAM keeps it: byte for byte the one that
    this version of kinegrade generated.
    """
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.exam.printing.reprint import reprint
    from kinegrade.files.output import write_file

    if output is None and sys.stdout.isatty():
        raise refuse_usage(Message("terminal.pdf"))
    expect_folders((exam, "EXAM"))
    again = reprint(open_exam(exam), student)
    pages = again.solution() if solution else again.pages()
    if output is None:
        click.echo(pages, nl=False)
    else:
        write_file(output, pages, force=force)
    finish_with_complaints(again.complaints())
