"""Every row of the table of a term is asserted by a test of its number, or named as still to come."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from tests.term.rows import ROWS, TO_COME

_NUMBERED = re.compile(r"test_row_([0-9]+)_")


def list_asserted(folder: Path) -> Iterator[int]:
    """The numbers of the rows for which there is a test that asserts something."""
    for file in sorted(folder.glob("test_*.py")):
        for node in ast.parse(file.read_text(encoding="utf-8")).body:
            named = _NUMBERED.match(node.name) if isinstance(node, ast.FunctionDef) else None
            if named and any(isinstance(inside, ast.Assert) for inside in ast.walk(node)):
                yield int(named[1])


def test_each_row_is_asserted_or_to_come() -> None:
    asserted = set(list_asserted(Path(__file__).parent))
    assert asserted | TO_COME.keys() == ROWS.keys()
    assert asserted & TO_COME.keys() == set()


def test_a_row_without_an_assertion_is_noticed(tmp_path: Path) -> None:
    text = "def test_row_3_x():\n    assert True\n\n\ndef test_row_4_y():\n    pass\n"
    (tmp_path / "test_term.py").write_text(text, encoding="utf-8")
    assert list(list_asserted(tmp_path)) == [3]
