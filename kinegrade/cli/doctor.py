"""The command that says what is installed: doctor."""

from __future__ import annotations

import sys

import click

from kinegrade.cli.help import command
from kinegrade.cli.options import COMPLAINTS, refusing
from kinegrade.cli.terminal import write_line
from kinegrade.language.message import Message


@command()
@refusing
def doctor() -> None:
    """Say what is installed of what kinegrade uses, and how to get what is not."""
    from kinegrade.press.installation import examine_installation

    sound = True
    for each in examine_installation():
        if each.state is not None:
            message = Message("doctor.there", name=each.name, state=each.state, use=each.purpose)
        else:
            parts = {"name": each.name, "use": each.purpose, "do": each.remedy}
            needed, optional = (
                Message("doctor.needed", **parts),
                Message("doctor.optional", **parts),
            )
            message = needed if each.needed else optional
            sound &= not each.needed
        click.echo(write_line(message))
    if not sound:
        sys.exit(COMPLAINTS)
