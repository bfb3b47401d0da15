"""The small exam as a folder on disk."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.grading.small_exam import STUDENTS, exam, paper, write_exam


@pytest.fixture
def exam_folder(tmp_path: Path) -> Path:
    return write_exam(tmp_path / "EXAM", exam(), [paper(student) for student in STUDENTS])
