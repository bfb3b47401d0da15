"""One run of TeX: in a folder of its own, without a shell or the user's settings, for a limited
time.

TeX may read and write in that folder and read its own installation, nothing else. The date is
fixed, so that the same source gives the same pages.
"""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from shutil import which
from typing import Literal

import pylopdf_fonts_zh_cn

from kinegrade.errors import TypesetError
from kinegrade.exam.program_run import run_program

Program = Literal["pdflatex", "xelatex"]
STYLE = "kinegrade.sty"
FONTS = "fonts"  # in the folder of a run, the folder of the Chinese fonts
FIXED_TIME = "946684800"  # 2000-01-01 00:00 UTC, in seconds

_SWITCHES = ("-no-shell-escape", "-interaction=nonstopmode", "-halt-on-error", "-file-line-error")
_SETTINGS = {
    "SOURCE_DATE_EPOCH": FIXED_TIME,
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
class Fault:
    """What TeX stumbled over; `line` counts from 1 in the source, None where TeX does not tell."""

    message: str
    line: int | None


@dataclass(frozen=True)
class Outcome:
    """What came of a run: the pages, none where there is a fault, and the characters that no font
    printed.
    """

    pdf: bytes
    ranges: tuple[tuple[str, int, int], ...]  # sheet, its first page (from 0), number of its pages
    fault: Fault | None
    missing: frozenset[str]


def run(program: Program, source: str, folder: Path, seconds: float) -> Outcome:
    """Typeset `source` in `folder`.

    Raises TypesetError where the program is not installed or does not end in that time.
    """
    _furnish(folder, source)
    output = _executed(program, folder, seconds)
    log = folder / f"{_JOB}.log"
    text = log.read_text(encoding="utf-8", errors="replace") if log.exists() else output
    file = folder / f"{_JOB}.pdf"
    pdf = file.read_bytes() if file.exists() else b""
    missing = frozenset(_MISSING.findall(text))
    return Outcome(pdf, _ranges(folder / f"{_JOB}.pages"), _fault(text, pdf), missing)


def style() -> str:
    """The style file that every source asks for."""
    return (files("kinegrade.exam") / "layouts" / STYLE).read_text(encoding="utf-8")


def font_folder() -> Path:
    """Where the Chinese fonts are installed."""
    return Path(pylopdf_fonts_zh_cn.serif_path()).parent


def _furnish(folder: Path, source: str) -> None:
    (folder / STYLE).write_text(style(), encoding="utf-8")
    (folder / f"{_JOB}.tex").write_text(source, encoding="utf-8", newline="\n")
    (folder / FONTS).symlink_to(font_folder())


def _executed(program: Program, folder: Path, seconds: float) -> str:
    found = which(program)
    if found is None:
        raise TypesetError(
            f"latex: {program} not found; expected a TeX installation; run make tools, or install "
            "TeX Live with LaTeX, TikZ, XeTeX and xeCJK, or use --engine typst"
        )
    kept = {name: os.environ[name] for name in ("PATH", "SYSTEMROOT") if name in os.environ}
    own = {name: str(folder) for name in ("HOME", "TEXMFHOME", "TEXMFVAR", "TMPDIR")}
    try:
        done = run_program(
            [found, *_SWITCHES, f"{_JOB}.tex"],
            seconds,
            folder=folder,
            environment=kept | own | _SETTINGS,
        )
    except TimeoutError as error:
        raise TypesetError(
            f"latex: {program} did not end within {seconds:.0f} s; expected a few pages a second; "
            "typeset fewer papers at once, or look for a formula that has no end"
        ) from error
    return (done.output + done.complaint).decode("utf-8", "replace")


def _ranges(file: Path) -> tuple[tuple[str, int, int], ...]:
    if not file.exists():
        return ()
    rows = (line.split() for line in file.read_text(encoding="utf-8").splitlines())
    return tuple((sheet, int(first) - 1, int(pages)) for sheet, first, pages in rows)


def _fault(log: str, pdf: bytes) -> Fault | None:
    """The first thing that TeX complains of; it halts there."""
    found = _FAULT.search(log)
    if found:
        return Fault(_sentence(log, found), int(found[2]) if found[1] == f"{_JOB}.tex" else None)
    bare = _BARE_FAULT.search(log)
    if bare:
        return Fault(bare[1].strip(), None)
    return None if pdf else Fault("TeX wrote no pages", None)


def _sentence(log: str, found: re.Match[str]) -> str:
    """TeX's message, with the offending command where the message does not name it."""
    message = found[3].strip().rstrip(".")
    if message != "Undefined control sequence":
        return message
    context = re.search(r"^l\.\d+ (.*)$", log[found.end() :], re.MULTILINE)
    commands = re.findall(r"\\[A-Za-z@]+", context[1]) if context else []
    return f"{message}: {commands[-1]}" if commands else message
