"""One run of TeX, and PDF files from parts of its pages: in a folder of its own, without a shell or
the user's settings, for a limited time.

TeX may read and write in that folder and read its own installation, nothing else. The date is
fixed, so that the same source gives the same pages. Pages become PDF part by part, so that each
file holds what its own pages need and does not depend on the others.
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from shutil import which
from typing import Literal

import pylopdf_fonts_zh_cn

from kinegrade.errors import TypesetError
from kinegrade.language.lines import shorten
from kinegrade.language.message import Fault, Message, Text
from kinegrade.press.program_run import run_program

_Program = Literal["xelatex", "xdvipdfmx"]
STYLE = "kinegrade.sty"
CLASS = "class.tex"  # in the folder of a run, what makes the run of a class faster
FONTS = "fonts"  # in the folder of a run, the folder of the Chinese fonts
_PDF_SECONDS = 60.0  # a sheet takes a tenth of one
_FIXED_TIME = "946684800"  # 2000-01-01 00:00 UTC, in seconds

_SWITCHES = (
    "-no-pdf",
    "-no-shell-escape",
    "-interaction=nonstopmode",
    "-halt-on-error",
    "-file-line-error",
)
_SETTINGS = {
    "SOURCE_DATE_EPOCH": _FIXED_TIME,
    "FORCE_SOURCE_DATE": "1",
    "openin_any": "p",  # no file above the folder, none that begins with a dot
    "openout_any": "p",
    "max_print_line": "10000",  # whole lines in the log
    "error_line": "250",
    "half_error_line": "125",
    "LC_ALL": "C.UTF-8",
}
_JOB = "pages"
_FAULT = re.compile(r"^\./(\S+):(\d+): (.*)$", re.MULTILINE)
_BARE_FAULT = re.compile(r"^! (.*)$", re.MULTILINE)
_MISSING = re.compile(r"Missing character: There is no (.)")


@dataclass(frozen=True)
class TexFault:
    """A fault that stopped TeX; `line` counts from 1 in the source, None if TeX gives none."""

    message: Text
    line: int | None


@dataclass(frozen=True)
class Outcome:
    """The outcome of a run: where the pages of each sheet are, the fault if there is one, and the
    characters that no font printed.
    """

    ranges: tuple[tuple[int, int], ...]  # of each sheet: its first page (from 1), how many it has
    own: tuple[int, ...]  # of each sheet that was filled up: how many it has without that
    fault: TexFault | None
    missing: frozenset[str]


def run(
    source: str, folder: Path, seconds: float, pictures: Mapping[str, bytes] | None = None
) -> Outcome:
    """Typeset `source`, which may show these pictures, in `folder`, where its pages then lie for
    `make_pdf`.

    Raises TypesetError where XeTeX is not installed or does not end in that time.
    """
    _furnish(folder, source)
    for name, content in (pictures or {}).items():
        (folder / name).write_bytes(content)
    output = _execute("xelatex", (*_SWITCHES, f"{_JOB}.tex"), folder, seconds)
    log = folder / f"{_JOB}.log"
    text = log.read_text(encoding="utf-8", errors="replace") if log.exists() else output
    missing = frozenset(_MISSING.findall(text))
    fault = _find_fault(text, folder / f"{_JOB}.xdv")
    ranges = ((first, pages) for first, pages in _read_counts(folder / f"{_JOB}.pages"))
    own = (pages for (pages,) in _read_counts(folder / f"{_JOB}.own"))
    return Outcome(tuple(ranges), tuple(own), fault, missing)


def make_pdf(folder: Path, pages: tuple[int, int] | None = None) -> bytes:
    """Pages that a run has left in `folder`, as PDF: the first to the last of `pages` (from 1), or
    all.

    Raises TypesetError where they cannot be written.
    """
    chosen = () if pages is None else ("-s", f"{pages[0]}-{pages[1]}")
    output = _execute("xdvipdfmx", ("-q", "-E", *chosen, f"{_JOB}.xdv"), folder, _PDF_SECONDS)
    file = folder / f"{_JOB}.pdf"
    if not file.exists():
        raise TypesetError(
            Fault("latex", Message("typesetting.no-pdf", output=shorten(output.strip())))
        )
    pdf = file.read_bytes()
    file.unlink()
    return pdf


def write_style() -> str:
    """The style file that every source asks for."""
    return _read_layout(STYLE)


def find_font_folder() -> Path:
    """Where the Chinese fonts are installed."""
    return Path(pylopdf_fonts_zh_cn.serif_path()).parent


def _read_layout(name: str) -> str:
    return (files("kinegrade.press.latex") / "layouts" / name).read_text(encoding="utf-8")


def _furnish(folder: Path, source: str) -> None:
    for name in (STYLE, CLASS):
        (folder / name).write_text(_read_layout(name), encoding="utf-8")
    (folder / f"{_JOB}.tex").write_text(source, encoding="utf-8", newline="\n")
    (folder / FONTS).symlink_to(find_font_folder())


def _execute(program: _Program, options: Sequence[str], folder: Path, seconds: float) -> str:
    """The output of a program of TeX. Raises TypesetError where it is not installed or does not end
    in that time.
    """
    found = which(program)
    if found is None:
        raise TypesetError(Fault("latex", Message("typesetting.no-tex", program=program)))
    kept = {name: os.environ[name] for name in ("PATH", "SYSTEMROOT") if name in os.environ}
    private = {name: str(folder) for name in ("HOME", "TEXMFHOME", "TEXMFVAR", "TMPDIR")}
    try:
        done = run_program(
            [found, *options],
            seconds,
            folder=folder,
            environment=kept | private | _SETTINGS,
        )
    except TimeoutError as error:
        raise TypesetError(
            Fault(
                "latex",
                Message("typesetting.endless", program=program, seconds=round(seconds)),
            )
        ) from error
    return (done.output + done.complaint).decode("utf-8", "replace")


def _read_counts(file: Path) -> list[list[int]]:
    """The whole numbers in each line of a file that a run has written, none without one."""
    if not file.exists():
        return []
    return [list(map(int, line.split())) for line in file.read_text(encoding="utf-8").splitlines()]


def _find_fault(log: str, pages: Path) -> TexFault | None:
    """The first thing that TeX complains of; it halts there."""
    found = _FAULT.search(log)
    if found:
        return TexFault(
            _read_sentence(log, found), int(found[2]) if found[1] == f"{_JOB}.tex" else None
        )
    unplaced = _BARE_FAULT.search(log)
    if unplaced:
        return TexFault(unplaced[1].strip(), None)
    return (
        None
        if pages.exists() and pages.stat().st_size
        else TexFault(Message("typesetting.no-pages"), None)
    )


def _read_sentence(log: str, found: re.Match[str]) -> str:
    """TeX's message, with the offending command where the message does not name it."""
    sentence = found[3].strip().rstrip(".")
    if sentence != "Undefined control sequence":
        return sentence
    context = re.search(r"^l\.\d+ (.*)$", log[found.end() :], re.MULTILINE)
    commands = re.findall(r"\\[A-Za-z@]+", context[1]) if context else []
    return f"{sentence}: {commands[-1]}" if commands else sentence
