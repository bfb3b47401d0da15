"""The commands about templates: check, gallery."""

from __future__ import annotations

import sys
from pathlib import Path

import click

from kinegrade.cli.help import command
from kinegrade.cli.options import (
    CLUSTER,
    COMPLAINTS,
    FORCE,
    JOBS,
    LANGUAGE,
    OPTIONAL_OUTPUT,
    OUTPUT,
    finish_with_complaints,
    refusing,
)
from kinegrade.cli.problems.choosing import READER_LANGUAGE, choose_common_language
from kinegrade.cli.terminal import speak, terminal_words
from kinegrade.language import Language


@command()
@click.argument("template_names", metavar="[TEMPLATE]...", nargs=-1)
@click.option(
    "--sample",
    type=click.IntRange(1, 1_000_000),
    default=200,
    show_default=True,
)
@JOBS
@CLUSTER
@OPTIONAL_OUTPUT
@READER_LANGUAGE
@FORCE
@refusing
def check(
    *,
    template_names: tuple[str, ...],
    sample: int,
    jobs: int,
    cluster: str | None,
    output: Path | None,
    language: Language | None,
    force: bool,
) -> None:
    """Prove templates: published results exactly, drawn instances solvable and sensible (default:
    all shipped).
    """
    from kinegrade.exam.printing.gallery import make_assembly_sheet
    from kinegrade.exam.printing.template_proof import prove_templates
    from kinegrade.files.output import write_file
    from kinegrade.problem.template.library.library import find_template_names as shipped_names
    from kinegrade.processes.executor import open_executor

    speak(language)
    sound, words = True, terminal_words()
    names = template_names or shipped_names()
    with open_executor(jobs, "check", cluster=cluster) as workers:
        for proof in prove_templates(names, sample, workers):
            click.echo(words.write(proof.verdict))
            for finding in proof.findings:
                click.echo(f"  {words.write(finding)}")
            sound &= proof.sound
    if output is not None:
        sheet = make_assembly_sheet(names, language or choose_common_language(names))
        write_file(output, sheet.pdf, "pdf", force=force)
    if not sound:
        sys.exit(COMPLAINTS)


@command()
@click.argument("template_names", metavar="[TEMPLATE]...", nargs=-1)
@OUTPUT
@LANGUAGE
@click.option(
    "--draws",
    type=click.IntRange(1, 12),
    default=3,
    show_default=True,
)
@FORCE
@refusing
def gallery(
    *, template_names: tuple[str, ...], output: Path, language: Language, draws: int, force: bool
) -> None:
    """Typeset a contact sheet to choose templates from: what each asks, and its figure (default:
    all shipped).
    """
    from kinegrade.exam.printing.gallery import make_contact_sheet
    from kinegrade.files.output import write_file
    from kinegrade.problem.template.library.library import find_template_names as shipped_names

    sheet = make_contact_sheet(template_names or shipped_names(), language, draws)
    write_file(output, sheet.pdf, "pdf", force=force)
    finish_with_complaints(sheet.complaints)
