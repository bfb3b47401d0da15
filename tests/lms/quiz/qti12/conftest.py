"""A package for Canvas."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.lms.quiz.qti12.package import write
from tests.lms.quiz import a_quiz


@pytest.fixture
def package(tmp_path: Path) -> Path:
    write(a_quiz.quiz(), tmp_path / "quiz.zip")
    return tmp_path / "quiz.zip"
