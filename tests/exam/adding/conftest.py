"""Classes whose exams grow or may grow."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from tests.exam.adding.growing_class import WORDS, added, generated, write


@pytest.fixture(scope="module")
def grown(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class whose exam has grown; EXAM-BEFORE is what it was."""
    folder = generated(write(tmp_path_factory.mktemp("grown")), *WORDS, "--solutions")
    shutil.copytree(folder / "EXAM", folder / "EXAM-BEFORE")
    result = added(folder)
    assert result.stderr == f"{folder / 'EXAM'}: 2 papers added, 3 stay as they are\n"
    return folder


@pytest.fixture
def folder(tmp_path: Path, unchanged: Path) -> Path:
    """A class whose exam may grow."""
    return Path(shutil.copytree(unchanged, tmp_path / "class"))


@pytest.fixture(scope="session")
def unchanged(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A class whose exam no test changes."""
    return generated(write(tmp_path_factory.mktemp("unchanged")), *WORDS)
