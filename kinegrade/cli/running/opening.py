"""EXAM and MARKS, as commands that need both open them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import kinegrade

if TYPE_CHECKING:
    from kinegrade.exam.folder.exam_folder import ExamFolder
    from kinegrade.marks_folder.folder import MarksFolder


def open_both(exam: Path, marks: Path) -> tuple[ExamFolder, MarksFolder]:
    """The folders there; two that were swapped are one fault. Raises TableError, ExamError."""
    from kinegrade.public.folders import expect_folders

    expect_folders((exam, "EXAM"), (marks, "MARKS"))
    opened = kinegrade.open_marks(marks)
    return kinegrade.open_exam(exam), opened
