"""The command that writes a sheet to practise on: practice."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

import kinegrade
from kinegrade.cli.help import command
from kinegrade.cli.options import FILE, FORCE, LANGUAGE, OUTPUT, finish, refusing, require_writable

if TYPE_CHECKING:
    from kinegrade.language import Language

_MOST_DRAWS = 500


@command()
@click.argument("bank", type=FILE)
@OUTPUT
@click.option(
    "--draws", type=click.IntRange(1, _MOST_DRAWS), default=20, show_default=True, metavar="K"
)
@click.option("--seed", callback=require_writable, default="practice", show_default=True)
@click.option("--scorm", is_flag=True)
@LANGUAGE
@FORCE
@refusing
def practice(
    bank: Path,
    *,
    output: Path,
    draws: int,
    seed: str,
    scorm: bool,
    language: Language,
    force: bool,
) -> None:
    """Write a page on which students practise the questions of BANK."""
    from kinegrade.public.practice import PracticeOptions, write_practice

    blueprint = kinegrade.Bank.read(bank).blueprint
    options = PracticeOptions(draws, seed, scorm)
    finish(write_practice(blueprint, output, language, options, force=force))
