"""pandoc, an optional extra: it gets a document of values with no text to parse, in its sandbox."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from importlib import import_module
from shutil import which
from typing import Literal

from kinegrade.errors import TypesetError
from kinegrade.language.math.reading import write_formula_place
from kinegrade.language.message import Fault, Message
from kinegrade.press.program_run import run_program

Kind = Literal["docx", "html"]
_MISSING = Message("typesetting.no-pandoc")
_SECONDS = 60  # a paper takes a fraction of one
_UNREAD = re.compile(r"Could not convert TeX math (.*?), rendering as TeX")


def require_pandoc(kinds: Iterable[str]) -> None:
    """Raises TypesetError where there is no pandoc to write these kinds of files."""
    wanted = ", ".join(kinds)
    if which(_find_pandoc(wanted)) is None:
        raise TypesetError(Fault(wanted, _MISSING))


def run_pandoc(kind: Kind, options: Sequence[str], tree: bytes) -> bytes:
    """What pandoc makes of a document."""
    form = ["--from", "json", "--to", kind, "--wrap", "none", "--fail-if-warnings", "--output", "-"]
    return run_bare_pandoc(kind, [*form, *options], tree)


def run_bare_pandoc(kind: Kind, options: Sequence[str], given: bytes) -> bytes:
    """The output of pandoc. Raises TypesetError if there is no pandoc, and with its message if it
    fails or warns.
    """
    command = [_find_pandoc(kind), "--sandbox", *options]
    try:
        result = run_program(command, _SECONDS, given=given)
    except TimeoutError as error:
        raise TypesetError(
            Fault(kind, Message("typesetting.pandoc-endless", seconds=_SECONDS))
        ) from error
    except OSError as error:
        raise TypesetError(Fault(kind, _MISSING)) from error
    if result.status:
        raise TypesetError(*_explain(result.complaint.decode(errors="replace"), kind))
    return result.output


def _explain(complaint: str, kind: Kind) -> tuple[Fault, ...]:
    """What pandoc complains about, usually formulas."""
    said = " ".join(complaint.split())
    formulas = tuple(dict.fromkeys(_UNREAD.findall(said)))
    if not formulas:
        return (Fault(kind, Message("typesetting.pandoc", complaint=said)),)
    return tuple(
        Fault(write_formula_place(latex, kind), Message("typesetting.not-whole"))
        for latex in formulas
    )


def _find_pandoc(kind: str) -> str:
    """The path of pandoc: that of the optional extra, or the one installed on the system."""
    try:
        return str(import_module("pypandoc").get_pandoc_path())
    except (ImportError, OSError) as error:
        raise TypesetError(Fault(kind, _MISSING)) from error
