"""An exam with a question that only hands mark, and the marks of the machine."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.exam.test_by_hand import CRANK, SLEEVE, THEORY, mark_right, set_exam


@pytest.fixture(scope="session")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of two machine-marked questions, of 3 and 4 points, and between them one of 2.5 for
    hands, and MARKS in which both students have everything right; not to be changed.
    """
    folder = tmp_path_factory.mktemp("by-hand")
    assert set_exam(folder, CRANK + THEORY + SLEEVE).exit_code == 0
    mark_right(folder)
    return folder


@pytest.fixture
def folder(made: Path, tmp_path: Path) -> Path:
    """The same, to be changed."""
    shutil.copytree(made, tmp_path, dirs_exist_ok=True)
    return tmp_path
