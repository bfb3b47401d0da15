"""The modules of the package as they are measured: text and syntax tree."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

Documented = ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef
Function = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True)
class File:
    """A module of the package: where it is, its text and its syntax tree."""

    path: Path
    text: str
    tree: ast.Module

    @cached_property
    def nodes(self) -> tuple[ast.AST, ...]:
        """All nodes of the syntax tree."""
        return tuple(ast.walk(self.tree))

    def functions(self) -> Iterator[Function]:
        """All functions and methods."""
        return (node for node in self.nodes if isinstance(node, Function))

    def code_lines(self) -> int:
        """How many lines hold code: no blank lines, comments or docstrings."""
        return len(self.lines_of_code)

    def function_lengths(self) -> Iterator[int]:
        """The lines of code of every function, from its `def` to its end."""
        code = self.lines_of_code
        for function in self.functions():
            last = function.end_lineno or 0
            yield len(code.intersection(range(function.lineno, last + 1)))

    @cached_property
    def lines_of_code(self) -> set[int]:
        """The lines that hold code."""
        texts = enumerate(map(str.strip, self.text.split("\n")), 1)
        lines = {number for number, text in texts if text and not text.startswith("#")}
        for node in self.nodes:
            if isinstance(node, ast.Constant | ast.JoinedStr):  # a string may hold such lines
                lines.update(range(node.lineno, (node.end_lineno or 0) + 1))
        return lines - self.docstring_lines()

    def docstring_lines(self) -> set[int]:
        """The lines on which docstrings stand."""
        lines: set[int] = set()
        for node in self.nodes:
            if isinstance(node, Documented) and ast.get_docstring(node) is not None:
                docstring = node.body[0]
                lines.update(range(docstring.lineno, (docstring.end_lineno or 0) + 1))
        return lines


def read_package(package: Path) -> list[File]:
    """Every module below a folder."""
    paths = sorted(package.rglob("*.py"))
    texts = [path.read_text(encoding="utf-8") for path in paths]
    return [
        File(path.relative_to(package.parent), text, ast.parse(text))
        for path, text in zip(paths, texts, strict=True)
    ]
