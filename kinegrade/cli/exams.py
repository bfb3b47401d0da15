"""The command that sets an exam: generate."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from kinegrade.cli.options import (
    FILE,
    FORCE,
    LANGUAGE,
    METHOD,
    finish,
    progress,
    refusing,
    writable,
)

if TYPE_CHECKING:
    from kinegrade.exam.document import PaperSize
    from kinegrade.exam.generate import Generated
    from kinegrade.exam.press import Engine
    from kinegrade.problem.template import Language, Method


@click.command()
@click.argument("bank", type=FILE)
@click.argument("roster", type=FILE)
@click.option(
    "-o", "--output", type=FILE, required=True, metavar="EXAM", help="The exam folder to write."
)
@click.option(
    "--seed", callback=writable, help="The exam's secret; drawn and printed if not given."
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
@click.option(
    "--jobs",
    type=click.IntRange(1),
    metavar="N",
    help="How many processes print a large class.  [default: one for each core]",
)
@FORCE
@refusing
def generate(
    *,
    bank: Path,
    roster: Path,
    output: Path,
    seed: str | None,
    language: Language,
    paper_size: PaperSize,
    engine: Engine | None,
    solutions: bool,
    method: Method | None,
    also: tuple[str, ...],
    jobs: int | None,
    force: bool,
) -> None:
    """Draw, solve and typeset an exam for every student of ROSTER (CSV: student, name).

    BANK is the exam's blueprint: a TOML file, or the name of one that is shipped: acceleration-midterm, demo, final,
    velocity-quiz.

    \b
    Example: kinegrade generate demo banks/demo-roster.csv -o EXAM --seed spring --lang zh
    """
    from os import cpu_count
    from secrets import token_hex

    from kinegrade.exam.bank import bank_path, read_blueprint
    from kinegrade.exam.generate import generate as write_exam
    from kinegrade.exam.printing import Extras
    from kinegrade.exam.roster import read_roster

    secret = seed if seed is not None else token_hex(8)
    click.echo(f"seed: {secret}", err=True)
    written = write_exam(
        read_blueprint(bank_path(bank)),
        read_roster(roster),
        output,
        secret,
        language,
        force=force,
        paper_size=paper_size,
        engine=engine,
        jobs=jobs or cpu_count() or 1,
        extras=Extras(solutions, method, tuple(dict.fromkeys(also))),
        progress=progress,
    )
    _say(written, output)
    finish(written.complaints)


def _say(written: Generated, output: Path) -> None:
    for question, template in written.drawn.items():
        click.echo(f"{question}: drawn from the bank: {template}", err=True)
    for question, combinations in written.combinations.items():
        refused = ", ".join(
            f"{reason} {count}" for reason, count in written.refusals[question].items()
        )
        click.echo(
            f"{question}: {combinations} combinations, refused draws: {refused or 'none'}", err=True
        )
    click.echo(
        f"{output}: {written.papers} papers; give students what is under {output / 'papers'}, nothing else",
        err=True,
    )
