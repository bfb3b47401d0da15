"""The pages that people read, as a test reads them: files to write, commands to run, what they show.

    ```{code-block} csv            a file, of the name that its caption gives
    :caption: roster.csv
    ```diff                        a change of the file last written: "-" lines become the "+" lines
    ```sh                          commands that end with status 0
    ```python                      a part of the page's program
    ```console                     commands after "$ ", and below each the whole of what it shows;
                                   a line "..." stands for any lines

A comment `<!-- continues PAGE -->` says whose files a page goes on with. Commands that install
kinegrade are run by `tests/test_installing.py`; those that stay until they are stopped are read, and
begun by `tests/preview/test_serving.py`.
"""

from __future__ import annotations

import re
import shlex
import subprocess
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import click

from kinegrade.cli import main
from tests.small_class import kinegrade

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
INSTALLING = ("pip install ", "make ")
STAYING = ("kinegrade preview ",)
_BLOCK = re.compile(r"^(?P<fence>```+) *(?P<kind>\S*).*?\n(?P<text>.*?)^(?P=fence) *$", re.M | re.S)
_CAPTION = re.compile(r":caption: (?P<name>\S+)\n\n?")
_CONTINUES = re.compile(r"<!-- continues (?P<page>\S+) -->")
_SPARED = "..."


@dataclass(frozen=True)
class File:
    """A file that the reader writes."""

    name: str
    text: str


@dataclass(frozen=True)
class Change:
    """Lines that the reader replaces in a file."""

    name: str
    old: str
    new: str


@dataclass(frozen=True)
class Command:
    """A command that the reader runs, and the lines that it is said to show; None where the page
    does not say.
    """

    line: str
    shown: tuple[str, ...] | None = None


@dataclass(frozen=True)
class Program:
    """Lines of Python; those of a page are one program."""

    text: str


Step = File | Change | Command | Program
Runner = Callable[[str, Path], tuple[int, list[str]]]


def list_pages() -> list[Path]:
    """README, CONTRIBUTING and the pages of the site that are written by hand."""
    written = (page for page in DOCS.rglob("*.md") if page.parent != DOCS / "reference")
    return [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(written)]


def read_steps(page: Path) -> list[Step]:
    """What the reader of a page does, in order."""
    return list(parse_steps(page.read_text(encoding="utf-8")))


def parse_steps(text: str) -> Iterator[Step]:
    """What the reader of a text does, in order."""
    name = ""
    for block in _BLOCK.finditer(text):
        match block["kind"]:
            case "{code-block}":
                caption = _CAPTION.match(block["text"])
                if caption:
                    name = caption["name"]
                    yield File(name, block["text"][caption.end() :])
            case "diff":
                yield _parse_change(name, block["text"])
            case "sh":
                for line in block["text"].replace("\\\n", " ").splitlines():
                    if line.strip() and not line.startswith("#"):
                        yield Command(line)
            case "python":
                yield Program(block["text"])
            case "console":
                yield from _parse_session(block["text"])


def _parse_change(name: str, text: str) -> Change:
    """The lines of a file before a change and after it, each with the mark of one side, or a
    blank.
    """
    lines = text.splitlines(keepends=True)
    old, new = ("".join(line[1:] for line in lines if line[0] in side) for side in (" -", " +"))
    return Change(name, old, new)


def _parse_session(text: str) -> Iterator[Command]:
    _, *parts = re.split(r"^\$ ", text, flags=re.MULTILINE)
    for part in parts:
        line, *shown = part.splitlines()
        yield Command(line, tuple(shown))


def find_earlier(page: Path) -> Path | None:
    """The page whose files a page goes on with."""
    found = _CONTINUES.search(page.read_text(encoding="utf-8"))
    return page.parent / found["page"] if found else None


def run_here(line: str, folder: Path) -> tuple[int, list[str]]:
    """The status of a command, and the lines that it shows; kinegrade runs in this process."""
    name, *arguments = shlex.split(line, comments=True)
    if name != "kinegrade":
        return run(line, folder)
    result = kinegrade(*arguments)
    return result.exit_code, result.output.splitlines()


def run(line: str, folder: Path) -> tuple[int, list[str]]:
    """The status of a command, and the lines that it shows."""
    ran = subprocess.run(
        line,
        shell=True,
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        check=False,
    )
    return ran.returncode, ran.stdout.splitlines()


def take(step: File | Change | Command, folder: Path, runner: Runner = run_here) -> str:
    """Do what a step says in a folder; what is wrong, or nothing. For `run_here` it has to be the
    current one.
    """
    match step:
        case File(name, text):
            (folder / name).write_text(text, encoding="utf-8")
            return ""
        case Change():
            return _change(step, folder / step.name)
        case Command(line) if line.startswith(INSTALLING):
            return ""
        case Command(line) if line.startswith(STAYING):
            return _find_misuse(line)
        case Command(line, shown):
            status, output = runner(line, folder)
            return _find_fault(line, shown, status, output)


def _change(change: Change, file: Path) -> str:
    """Change a file; what is wrong, or nothing."""
    text = file.read_text(encoding="utf-8")
    if text.count(change.old) != 1:
        return f"{change.name}: not there, or more than once: {change.old}"
    file.write_text(text.replace(change.old, change.new), encoding="utf-8")
    return ""


def _find_misuse(line: str) -> str:
    """What is wrong with the arguments of a command that is not run."""
    _, name, *arguments = shlex.split(line, comments=True)
    try:
        main.commands[name].make_context(name, arguments)
    except click.ClickException as error:
        return f"{line}: {error.format_message()}"
    return ""


def _find_fault(line: str, shown: tuple[str, ...] | None, status: int, output: list[str]) -> str:
    """What differs from what the page says. A command may end otherwise than well if the page shows
    it.
    """
    if status != _find_status("\n".join(shown or ())):
        return f"{line}: status {status}: {output}"
    if shown is not None and not fits(list(shown), output):
        return "\n".join((f"{line}: shows", *output))
    return ""


def _find_status(shown: str) -> int:
    """The status with which a command ends that shows this."""
    if shown.startswith("error: "):
        return 2
    return int("complaint: " in shown or ": FAULTY" in shown)


def fits(shown: list[str], output: list[str]) -> bool:
    """Whether lines are those shown; "..." stands for any."""
    if _SPARED not in shown:
        return shown == output
    place = shown.index(_SPARED)
    if shown[:place] != output[:place]:
        return False
    rest = shown[place + 1 :]
    return any(fits(rest, output[start:]) for start in range(place, len(output) + 1))
