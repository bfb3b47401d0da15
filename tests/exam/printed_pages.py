"""What is wrong with the pages of an exam as they are printed, seen from the PDF files alone."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

from pypdf import PdfReader

from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam

_DPI = 36
_PAPER_WHITE = 250  # of 255: anything darker is printed
_HEAD, _FOOT = 27.0, 20.0  # millimetres: what runs on every page stands there
_GAP = 12.0  # millimetres: more than what stands between texts
MOST_WHITE = 0.25  # of the room between head and foot
_QUESTION = re.compile(r"(?<![A-Za-z0-9])q[0-9]+(?![A-Za-z0-9])")


def list_faults(folder: Path) -> list[str]:
    """Papers of different lengths, pages that are too white, and names that only files know."""
    exam = open_exam(folder)
    files = sorted((folder / "papers").glob("*.pdf"))
    assert len(files) == len(exam.students)
    return [*_list_lengths(exam, files), *(fault for file in files for fault in _look(exam, file))]


def measure_white(file: Path) -> list[float]:
    """Of each page, the share of its height that lies in gaps without any print."""
    command = ["pdftoppm", "-r", str(_DPI), "-gray", str(file)]
    return list(
        map(_measure, split_images(subprocess.run(command, capture_output=True, check=True).stdout))
    )


def _list_lengths(exam: ExamFolder, files: list[Path]) -> Iterator[str]:
    for file in files:
        pages = len(PdfReader(file).pages)
        if pages != exam.head.pages:
            yield f"{file.name}: {pages} pages, the exam has {exam.head.pages}"


def _look(exam: ExamFolder, file: Path) -> Iterator[str]:
    for number, white in enumerate(measure_white(file), start=1):
        if white > MOST_WHITE:
            yield f"{file.name}, page {number}: {white:.0%} white"
    text = " ".join(page.extract_text() for page in PdfReader(file).pages)
    names = [name for name in _list_names(exam) if name in text]
    yield from (f"{file.name}: {name}" for name in (*names, *_QUESTION.findall(text)))


def _list_names(exam: ExamFolder) -> Iterator[str]:
    """Names of templates and asks that are no words or symbols."""
    for question in exam.head.questions:
        yield from (name for name in (question.template,) if name.count("-") > 1)
        yield from (ask.ask for ask in question.asks if "_" in ask.ask)


def split_images(images: bytes) -> Iterator[list[bytes]]:
    """The rows of pixels of each page, from images one after another."""
    while images:
        head = re.match(rb"P5\s(\d+) (\d+)\s255\s", images)
        assert head is not None
        width, height = int(head[1]), int(head[2])
        start, end = head.end(), head.end() + width * height
        yield [images[row : row + width] for row in range(start, end, width)]
        images = images[end:]


def _measure(rows: list[bytes]) -> float:
    dots = _DPI / 25.4
    body = rows[round(_HEAD * dots) : len(rows) - round(_FOOT * dots)]
    printed = "".join("x" if min(row) < _PAPER_WHITE else " " for row in body)
    white = sum(len(gap) for gap in re.findall(" +", printed) if len(gap) > _GAP * dots)
    return white / len(body)
