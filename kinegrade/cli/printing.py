"""The commands that print papers: sample, papers, paper, reprint, solutions."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

import kinegrade
from kinegrade.cli.help import command
from kinegrade.cli.option_types import LanguageChoice
from kinegrade.cli.options import (
    CLUSTER,
    CYCLE,
    FILE,
    FORCE,
    JOBS,
    LANGUAGE,
    LARGE_PRINT,
    METHOD,
    OPTIONAL_OUTPUT,
    finish_with_complaints,
    refusing,
    require_writable,
    show_progress,
)
from kinegrade.cli.terminal import refuse_usage, say
from kinegrade.language.message import Message, list_first

if TYPE_CHECKING:
    from kinegrade.exam.handing_out.group_bundles import Bundle
    from kinegrade.language import Language
    from kinegrade.problem.template.template import Method


@command()
@click.argument("bank", type=FILE)
@click.option("-o", "--output", type=FILE, required=True, metavar="FILE")
@click.option("--seed", callback=require_writable, default="sample", show_default=True)
@LANGUAGE
@FORCE
@refusing
def sample(bank: Path, *, output: Path, seed: str, language: Language, force: bool) -> None:
    """Print one paper of BANK to read through before an exam is generated."""
    from kinegrade.exam.printing.sample import print_first_proof
    from kinegrade.files.output import write_file

    blueprint = kinegrade.Bank.read(bank).blueprint
    proof = print_first_proof(blueprint, seed, language)
    write_file(output, proof.pdf, "pdf", force=force)
    finish_with_complaints(proof.complaints)


@command()
@click.argument("exam", type=FILE)
@click.option(
    "-o",
    "--output",
    type=FILE,
    required=True,
    metavar="DIR",
)
@click.option("--send-list", "listed", type=FILE, metavar="FILE")
@click.option("--by-group", "bundle", type=click.Choice(["pdf", "zip"]))
@FORCE
@refusing
def papers(
    exam: Path, output: Path, *, listed: Path | None, bundle: Bundle | None, force: bool
) -> None:
    """Copy from EXAM what students may have: everybody's paper as PDF, and for Word and the browser
    where it exists.
    """
    from kinegrade.exam.handing_out.group_bundles import hand_out_groups
    from kinegrade.exam.handing_out.handout import hand_out, list_papers, send_list

    if listed and bundle:
        raise refuse_usage(Message("terminal.list-or-groups"))
    folder = kinegrade.open_exam(exam)
    if bundle is not None:
        done = hand_out_groups(folder, output, bundle, force=force)
    elif listed is None:
        done = hand_out(folder, output, force=force)
    else:
        files = list_papers(folder, output)
        with send_list(folder, output, files, listed, force=force) as reached:
            done = hand_out(folder, output, force=force)
        say(Message("terminal.send-list", file=str(listed), count=reached))
    papers_said = Message("terminal.handed-out", folder=str(output), count=done.papers)
    said = Message("terminal.spare-among-them", papers=papers_said, files=list_first(done.spare, 5))
    say(said if done.spare else papers_said)


@command()
@click.argument("exam", type=FILE)
@click.argument("student")
@click.option(
    "--solution",
    is_flag=True,
)
@LARGE_PRINT
@click.option("--tactile", is_flag=True)
@OPTIONAL_OUTPUT
@FORCE
@refusing
def paper(
    exam: Path,
    student: str,
    output: Path | None,
    *,
    solution: bool,
    large_print: bool,
    tactile: bool,
    force: bool,
) -> None:
    """Print the paper of one STUDENT again, by id, as EXAM keeps it: byte for byte the one that
    this version of kinegrade generated.
    """
    from kinegrade.exam.printing.reprint import reprint

    if output is None and sys.stdout.isatty():
        raise refuse_usage(Message("terminal.pdf"))
    if tactile and (solution or large_print):
        raise refuse_usage(Message("terminal.tactile-alone"))
    again = reprint(kinegrade.open_exam(exam), student)
    if tactile:
        pages = again.tactile()
    else:
        print_pages = again.solution if solution else again.pages
        pages = print_pages(large=large_print)
    if output is None:
        click.echo(pages, nl=False)
    else:
        from kinegrade.files.output import write_file

        write_file(output, pages, "zip" if tactile else "pdf", force=force)
    finish_with_complaints(again.complaints())


@command("reprint")
@click.argument("exam", type=FILE)
@click.option("--template", type=FILE, required=True, metavar="FILE")
@click.option("--accept-changes", is_flag=True)
@JOBS
@refusing
def reprint_exam(exam: Path, *, template: Path, accept_changes: bool, jobs: int) -> None:
    """Print the papers of EXAM again with a corrected template, and keep all numbers."""
    from kinegrade.exam.generating.corrected_template import CorrectionWishes, correct_template

    folder = kinegrade.open_exam(exam)
    wishes = CorrectionWishes(accept_changes, jobs, show_progress)
    corrected = correct_template(folder, template, wishes)
    if folder.head.unprinted:
        say(Message("terminal.corrected-unprinted", exam=str(exam)))
    else:
        say(Message("terminal.reprinted", exam=str(exam), count=corrected.papers))
    finish_with_complaints(corrected.changes)


@command()
@click.argument("exam", type=FILE)
@click.argument("students", nargs=-1, metavar="[STUDENT]...")
@METHOD
@CYCLE
@click.option(
    "--lang",
    "language",
    type=LanguageChoice(),
)
@click.option(
    "--before-due",
    is_flag=True,
)
@JOBS
@CLUSTER
@FORCE
@refusing
def solutions(
    exam: Path,
    students: tuple[str, ...],
    *,
    method: Method | None,
    cycle: bool,
    language: Language | None,
    before_due: bool,
    jobs: int,
    cluster: str | None,
    force: bool,
) -> None:
    """Write the worked solutions of an EXAM that has none, or those of each STUDENT named, by id:
    byte for byte those of generate --solutions.
    """
    from kinegrade.exam.due import require_due_past
    from kinegrade.exam.generating.later_solutions import SolutionWishes, add_solutions

    folder = kinegrade.open_exam(exam)
    if not before_due:
        require_due_past(folder)
    wishes = SolutionWishes(students, method, cycle, language, jobs, force, show_progress, cluster)
    count = add_solutions(folder, wishes)
    say(Message("terminal.solutions-written", exam=str(exam), count=count))
