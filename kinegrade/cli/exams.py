"""The commands that set an exam and give out its papers: generate, papers, paper."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click
from click.core import ParameterSource

from kinegrade.cli.folders import expect_folders
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
from kinegrade.counting import count_in_words

if TYPE_CHECKING:
    from kinegrade.exam.document import PaperSize
    from kinegrade.exam.exam_secret import SecretWish
    from kinegrade.exam.generate import Generated
    from kinegrade.exam.press import Engine
    from kinegrade.language import Language
    from kinegrade.problem.template import Method

_WITH_ADD = ("bank", "roster", "output", "late", "jobs", "allow_odd_ids", "strict", "force")
_GUESSABLE = "anyone who guesses these words can print every paper and its key"
_COST = f"--reproducible: {_GUESSABLE}; for tests and demonstrations only"


@click.command()
@click.argument("bank", type=FILE)
@click.argument("roster", type=FILE)
@click.option(
    "-o", "--output", type=FILE, required=True, metavar="EXAM", help="The exam folder to write."
)
@click.option(
    "--seed",
    "label",
    callback=require_writable,
    metavar="LABEL",
    help="A label mixed into the random secret that EXAM keeps; no secret itself.",
)
@click.option(
    "--reproducible",
    "words",
    callback=require_writable,
    metavar="WORDS",
    help="Derive the whole exam from WORDS alone. Anyone who guesses them can print every paper "
    "and its key: for tests and demonstrations only.",
)
@click.option(
    "--new-numbers",
    is_flag=True,
    help="With --force: papers of EXAM that may be printed are replaced by others.",
)
@click.option(
    "--share-with-group",
    is_flag=True,
    help="Let the group of the folder read EXAM.  [default: its owner alone]",
)
@click.option(
    "--add",
    "late",
    type=FILE,
    metavar="LATE",
    help="Add the students of LATE (CSV) to EXAM, which BANK and ROSTER made; all else stays.",
)
@LANGUAGE
@click.option("--paper-size", type=click.Choice(["a4", "letter"]), default="a4", show_default=True)
@click.option(
    "--engine",
    type=click.Choice(["typst", "latex"]),
    help="What typesets the exam.  [default: what the bank says, else typst]",
)
@click.option(
    "--solutions/--no-solutions",
    default=True,
    show_default=True,
    help="Whether everybody's worked solutions are written too.",
)
@METHOD
@click.option(
    "--also",
    multiple=True,
    type=click.Choice(["docx", "html"]),
    help="Write every paper for Word or the browser too; may be given twice.",
)
@JOBS
@click.option("--allow-odd-ids", is_flag=True, help="Accept ids that begin with =, +, - or @.")
@click.option(
    "--strict", is_flag=True, help="Refuse what else would be a complaint, and write nothing."
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

    \b
    Example: kinegrade generate demo banks/demo-roster.csv -o EXAM --lang zh
    """
    from kinegrade.exam.bank import find_bank, read_blueprint
    from kinegrade.exam.generate import PRIVATE, SHARED_WITH_GROUP, Place, Printing
    from kinegrade.exam.generate import generate as write_exam
    from kinegrade.exam.printing import Extras
    from kinegrade.exam.roster import read_roster

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
        kept = f"{output}: keeps numbers that come from words: {_GUESSABLE}; --new-numbers is safe"
        click.echo(kept if words is None else _COST, err=True)
    _say(written, output)
    finish_with_complaints(written.complaints)


def _add(
    exam: Path, bank: Path, roster: Path, late: Path, *, odd_ids: bool, strict: bool, jobs: int
) -> None:
    """Add the students of LATE to an exam. Raises UsageError where something is wanted otherwise
    than the exam has it.
    """
    from kinegrade.exam.adding import add_students
    from kinegrade.exam.bank import find_bank, read_blueprint
    from kinegrade.exam.roster import read_roster

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
    click.echo(f"{exam}: {added}", err=True)
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
        raise click.UsageError(
            f"--add makes papers like those of EXAM: leave out {', '.join(given)}"
        )


def _read_wish(label: str | None, words: str | None, *, new: bool) -> SecretWish:
    """What the numbers are to be drawn from.

    Raises UsageError where two things are wanted that exclude each other.
    """
    from kinegrade.exam.exam_secret import SecretWish

    if label is not None and words is not None:
        raise click.UsageError(
            "--seed mixes a label into a random secret, --reproducible WORDS derives all from the "
            "words: give one"
        )
    return SecretWish(label, words, new)


def _say(written: Generated, output: Path) -> None:
    for question, template in written.drawn.items():
        click.echo(f"{question}: drawn from the bank: {template}", err=True)
    refusals = written.dealt.refusals()
    for question, combinations in written.dealt.combinations().items():
        refused = ", ".join(f"{reason} {count}" for reason, count in refusals[question].items())
        click.echo(
            f"{question}: {combinations} combinations, refused draws: {refused or 'none'}", err=True
        )
    if written.changes is not None:
        click.echo(f"{output}: {written.changes}", err=True)
    for remark in written.remarks:
        click.echo(f"{output}: {remark}", err=True)
    click.echo(
        f"{output}: {count_in_words(written.papers, 'paper')}; to hand them out: "
        f"kinegrade papers {output} -o DIR; nothing else in {output} is for students",
        err=True,
    )


@click.command()
@click.argument("exam", type=FILE)
@click.option(
    "-o", "--output", type=FILE, required=True, metavar="DIR", help="The folder to write."
)
@FORCE
@refusing
def papers(exam: Path, output: Path, *, force: bool) -> None:
    """Copy from EXAM what students may have: everybody's paper as PDF, and for Word and the browser
    where it exists.

    \b
    Example: kinegrade papers EXAM -o PAPERS
    """
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.exam.handout import hand_out

    expect_folders((exam, "EXAM"))
    count = hand_out(open_exam(exam), output, force=force)
    click.echo(
        f"{output}: {count_in_words(count, 'paper')}, and nothing that gives the key away", err=True
    )


@click.command()
@click.argument("exam", type=FILE)
@click.argument("student")
@click.option("--solution", is_flag=True, help="The worked solutions in place of the paper.")
@click.option(
    "-o",
    "--output",
    type=FILE,
    metavar="FILE",
    help="The PDF to write.  [default: standard output]",
)
@FORCE
@refusing
def paper(exam: Path, student: str, output: Path | None, *, solution: bool, force: bool) -> None:
    """Print the paper of one STUDENT again, by id, as EXAM keeps it: byte for byte the one that
    this version of kinegrade generated.

    \b
    Example: kinegrade paper EXAM 0012 -o 0012.pdf
    """
    from kinegrade.exam.folder.exam_folder import open_exam
    from kinegrade.exam.reprint import reprint
    from kinegrade.files import write_file

    if output is None and sys.stdout.isatty():
        raise click.UsageError("a PDF is nothing for a terminal: give a file by -o FILE")
    expect_folders((exam, "EXAM"))
    again = reprint(open_exam(exam), student)
    pages = again.solution() if solution else again.pages()
    if output is None:
        click.echo(pages, nl=False)
    else:
        write_file(output, pages, force=force)
    finish_with_complaints(again.complaints())
