"""The modules of the package with their syntax trees, read once for all laws of code."""

from __future__ import annotations

from functools import cache

import pytest

from benchmarks.measures import PACKAGE
from benchmarks.modules import File, read_package

GROUP = pytest.mark.xdist_group("code of the package")  # one worker reads it


@cache
def package_files() -> tuple[File, ...]:
    """Every module of the package."""
    return tuple(read_package(PACKAGE))


def locate(file: File) -> str:
    """Where a module is, as seen from the folder of its package."""
    return file.path.relative_to(file.path.parts[0]).as_posix()
