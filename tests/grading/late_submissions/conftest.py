"""An exam with a due date."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.grading.late_submissions.late_exam import DUE
from tests.grading.marked_folder import RIGHT, mark_class


@pytest.fixture
def exam(tmp_path: Path) -> Path:
    """An exam of 9.5 points, due on the first of December at six."""
    folder, _ = mark_class(tmp_path / "class", {"7": RIGHT, "8": RIGHT, "9": RIGHT, "10": ()})
    head = json.loads((folder / "exam.json").read_text(encoding="utf-8"))
    (folder / "exam.json").write_text(json.dumps({**head, "due": DUE}), encoding="utf-8")
    return folder
