"""The marks of two exams."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.grading.marked_folder import RIGHT, mark_class
from tests.grading.term.marked_exams import WRONG


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """HW1, HW2 and FINAL, each with MARKS; 7 sat all, 8 missed HW2, =9 is in the FINAL alone, 10
    was nowhere.
    """
    folder = tmp_path_factory.mktemp("term")
    mark_class(folder / "HW1", {"7": RIGHT, "8": RIGHT, "10": ()})
    mark_class(folder / "HW2", {"7": WRONG, "8": (), "10": ()})
    mark_class(folder / "FINAL", {"7": RIGHT, "8": WRONG, "10": (), "=9": RIGHT})
    return folder
