"""The command that writes starters: new."""

from __future__ import annotations

from pathlib import Path

import click

from kinegrade.cli.help import command
from kinegrade.cli.options import FORCE, OPTIONAL_OUTPUT, refusing
from kinegrade.cli.terminal import refuse_usage, say
from kinegrade.language.known import choose_terminal_language
from kinegrade.language.message import Message, list_plainly


@command()
@click.argument("name")
@click.option(
    "--bank",
    is_flag=True,
)
@click.option(
    "--policy",
    is_flag=True,
)
@click.option("--like", metavar="TEMPLATE", default="")
@click.option("--from", "words", metavar="WORDS", default="")
@OPTIONAL_OUTPUT
@FORCE
@refusing
def new(
    *,
    name: str,
    bank: bool,
    policy: bool,
    like: str,
    words: str,
    output: Path | None,
    force: bool,
) -> None:
    """Write a starter, complete and sound, to be written over: a template, a bank or a policy."""
    if bank and policy:
        raise refuse_usage(Message("terminal.one-starter"))
    if (like or words) and (bank or policy or (like and words)):
        raise refuse_usage(Message("terminal.one-model"))
    if bank:
        _write_plainly("bank", "kinegrade.exam.bank", name, output, force)
    elif policy:
        _write_plainly("policy", "kinegrade.grading.policy", name, output, force)
    else:
        _write_template(name, like, words, output, force)


def _write_plainly(kind: str, package: str, name: str, output: Path | None, force: bool) -> None:
    from kinegrade.files.starter import write_starter_file

    path = write_starter_file(name, package, output, force=force)
    say(Message(f"terminal.starter-{kind}", path=str(path)))


def _write_template(name: str, like: str, words: str, output: Path | None, force: bool) -> None:
    from kinegrade.problem.template.library.alike import find_alike, find_unmatched
    from kinegrade.problem.template.library.starter import write_starter

    model = find_alike(words) if words else like
    language = choose_terminal_language()
    path = write_starter(name, output, like=model, language=language, force=force)
    unmatched = find_unmatched(words, model) if words else []
    if unmatched:
        say(Message("terminal.not-alike", name=model, words=list_plainly(unmatched)))
    if model:
        say(Message("terminal.written-like", path=str(path), name=model))
    else:
        say(Message("terminal.starter", path=str(path)))
