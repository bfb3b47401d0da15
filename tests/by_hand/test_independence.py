"""Students written by hand know nothing of the program: what they prove is no echo of it."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

FOLDER = Path(__file__).parent
ALLOWED = {
    "__future__",
    "cmath",
    "collections",
    "math",
    "typing",
    "tests.by_hand.components",
    "tests.by_hand.pad",
    "tests.by_hand.slips",
    "tests.by_hand.writing",
}


def imported(file: Path) -> Iterator[str]:
    """The modules that a file imports, wherever in it."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield node.module or ""


def named(module: str) -> str:
    return module if module.startswith("tests.") else module.partition(".")[0]


HOLDING = "test_equality"  # holds what the program predicts against what the students lose


@pytest.mark.parametrize(
    "file",
    [file for file in sorted(FOLDER.rglob("*.py")) if file.stem != HOLDING],
    ids=lambda file: file.stem,
)
def test_no_module_imports_the_program(file: Path) -> None:
    assert "kinegrade" not in {module.partition(".")[0] for module in imported(file)}


@pytest.mark.parametrize("file", sorted(FOLDER.glob("students/*.py")), ids=lambda file: file.stem)
def test_a_student_has_python_and_a_pad(file: Path) -> None:
    assert {named(module) for module in imported(file)} <= ALLOWED
