"""`kinegrade papers`: what students may have of an exam folder, copied to a place where others may
read it.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from kinegrade.errors import ExamError, OutputError
from kinegrade.exam.exam_secret import MARKER
from kinegrade.files import output_folder

KINDS = (".pdf", ".docx", ".html")  # the first one everybody has
FOLDER = "papers"


def hand_out(exam: Path, output: Path, *, force: bool = False) -> int:
    """Copy everybody's paper, in each kind of file that there is, and nothing else; give the number
    of papers.

    What the folder `output` holds is replaced with `force` where that is papers of this exam and
    nothing else. Raises ExamError, OutputError; then nothing is written.
    """
    require_outside(exam, output)
    stems = paper_stems(exam)
    files = list(paper_files(exam, stems))
    names = [f"{stem}{kind}" for stem in stems for kind in KINDS]
    with output_folder(output, marker=None, contents=names, force=force) as folder:
        for file in files:
            (folder / file.name).write_bytes(content(file))
    return len(stems)


def require_outside(exam: Path, output: Path) -> None:
    """Raises OutputError where `output` is the exam folder, or lies in it or around it."""
    inner, outer = output.resolve(), exam.resolve()
    if outer == inner or outer in inner.parents or inner in outer.parents:
        raise OutputError(
            f"{output}: is, holds or lies in the exam folder {exam}, which gives the key away - "
            "expected another place - choose a folder beside it"
        )


def paper_stems(exam: Path) -> list[str]:
    """How everybody's paper is named, without the kind of file. Raises ExamError."""
    path = exam / MARKER
    try:
        students = json.loads(path.read_text(encoding="utf-8"))["students"]
        return [paper_stem(student) for student in students]
    except OSError as fault:
        reason = str(fault.strerror)
    except (ValueError, KeyError, TypeError, RecursionError) as fault:
        reason = type(fault).__name__
    raise ExamError(
        f"{path}: cannot be read ({reason}) - expected an exam folder made by kinegrade generate - "
        "check the name"
    )


def paper_stem(student: Any) -> str:
    """The name of a student's paper without its kind.

    Raises ValueError where it lies elsewhere than all papers.
    """
    file = Path(student["file"])
    if file.parent != Path(FOLDER) or file.suffix != KINDS[0]:
        raise ValueError(str(file))
    return file.stem


def paper_files(exam: Path, stems: list[str]) -> Iterator[Path]:
    """The files of these papers, of every kind that there is.

    A PDF that is missing is noticed when it is read.
    """
    for stem in stems:
        for kind in KINDS:
            file = exam / FOLDER / f"{stem}{kind}"
            if kind == KINDS[0] or file.is_file():
                yield file


def content(file: Path) -> bytes:
    """The bytes of a paper. Raises ExamError."""
    if file.is_symlink():
        raise ExamError(
            f"{file}: is a link - expected the paper of a student, as a link may lead to what is "
            "not for students - restore the exam folder"
        )
    try:
        return file.read_bytes()
    except OSError as fault:
        raise ExamError(
            f"{file}: cannot be read ({fault.strerror}) - expected the paper of a student - "
            "restore the exam folder"
        ) from fault
