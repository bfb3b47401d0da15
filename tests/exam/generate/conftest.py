"""The files of a class, and its exam."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.small_class import (
    write_class,
)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return write_class(tmp_path)


@pytest.fixture
def exam(small_class: Path) -> Path:
    return small_class / "EXAM"
