"""Start-up: `kinegrade --help` against a bare `import click`, each as a process of its own."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from benchmarks.figure_of_merit import Figure, seconds

PROMISE = 0.5  # less than twice the time


def figures() -> Iterator[Figure]:
    """The time until the help is on the screen."""
    command = Path(sys.executable).with_name("kinegrade")
    helping = seconds(
        lambda: subprocess.run([command, "--help"], check=True, capture_output=True), 25
    )
    importing = seconds(
        lambda: subprocess.run([sys.executable, "-c", "import click"], check=True), 25
    )
    yield Figure(
        "kinegrade --help against import click (ratio above 0.5)", helping, importing, PROMISE
    )
