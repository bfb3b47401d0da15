"""The measures of the house count what they say, on a package small enough to be counted by
hand.
"""

from __future__ import annotations

from pathlib import Path

from benchmarks.measures import measures, read_package

TEXT = '''"""A module
of two lines of docstring."""

from typing import Any


def first(a: Any, b: int, c: int, d: int, e: int, f: int, g: int) -> int:
    """Seven parameters."""
    # a comment
    return a


class Second:
    """A class."""

    def method(self) -> int:
        return (
            1
        )  # code with a comment
'''


def test_lines_of_code_are_lines_without_docstrings_comments_and_blanks(tmp_path: Path) -> None:
    package = tmp_path / "package"
    package.mkdir()
    (package / "one.py").write_text(TEXT, encoding="utf-8")
    (package / "two.py").write_text(f'LONG = "{"x" * 100}"\n', encoding="utf-8")
    found = {each.name: each.value for each in measures(read_package(package))}
    assert found["modules"] == "2"
    assert found["lines of code"] == "9"  # the import, 2, the class, 4, and the constant
    assert found["lines of more than 100 columns"] == "1"
    assert found["functions: most lines"] == "4"
    assert found["functions of more than 6 parameters"] == "1"
    assert found["folders of more than 20 files"] == "0"
    assert found["uses of Any"] == "1"
