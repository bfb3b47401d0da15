"""The command that shows a template or a bank in the browser while it is written: preview."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from kinegrade.cli.help import command
from kinegrade.cli.options import FILE, LANGUAGE, refusing
from kinegrade.cli.terminal import say
from kinegrade.errors import InstallationError
from kinegrade.language.message import Fault, Message

if TYPE_CHECKING:
    from kinegrade.language import Language


@command()
@click.argument("file", type=FILE)
@LANGUAGE
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=8321,
    show_default=True,
)
@click.option(
    "--open",
    "opened",
    is_flag=True,
)
@refusing
def preview(*, file: Path, language: Language, port: int, opened: bool) -> None:
    """Show a template or a bank in the browser, anew whenever it is saved."""
    try:
        from kinegrade.preview.serving import serve
    except ModuleNotFoundError as error:
        missing, do = Message("preview.not-installed"), Message("preview.install")
        raise InstallationError(Fault("preview", missing, do=do)) from error
    serve(file, language, port, partial(_tell, file, opened=opened))


def _tell(file: Path, address: str, *, opened: bool) -> None:
    """Say where the page is, and open it where that is wished."""
    say(Message("preview.address", file=file.name, address=address))
    if opened:
        click.launch(address)
