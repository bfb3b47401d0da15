"""`make measure`: how large and how dense the house is, beside what its rebuilding aims at."""

from __future__ import annotations

import ast
import io
import sys
import tokenize
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median

PACKAGE = Path(__file__).parent.parent / "kinegrade"
WIDEST = 100  # columns
MOST_PARAMETERS = 6
MOST_FILES = 20
NO_CODE = frozenset(
    {
        tokenize.COMMENT,
        tokenize.NL,
        tokenize.NEWLINE,
        tokenize.INDENT,
        tokenize.DEDENT,
        tokenize.ENDMARKER,
    }
)
Documented = ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef
Function = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True)
class File:
    """A module of the package: where it is, its text and its syntax tree."""

    path: Path
    text: str
    tree: ast.Module

    def nodes(self) -> Iterator[ast.AST]:
        """All nodes of the syntax tree."""
        return ast.walk(self.tree)

    def functions(self) -> Iterator[Function]:
        """All functions and methods."""
        return (node for node in self.nodes() if isinstance(node, Function))

    def code_lines(self) -> int:
        """How many lines hold code: no blank lines, comments or docstrings."""
        lines: set[int] = set()
        for token in tokenize.generate_tokens(io.StringIO(self.text).readline):
            if token.type not in NO_CODE:
                lines.update(range(token.start[0], token.end[0] + 1))
        return len(lines - self.docstring_lines())

    def docstring_lines(self) -> set[int]:
        """The lines on which docstrings stand."""
        lines: set[int] = set()
        for node in self.nodes():
            if isinstance(node, Documented) and ast.get_docstring(node) is not None:
                docstring = node.body[0]
                lines.update(range(docstring.lineno, (docstring.end_lineno or 0) + 1))
        return lines


@dataclass(frozen=True)
class Measure:
    """One figure of the house and what it should be, both as they are printed."""

    name: str
    value: str
    aim: str

    def line(self) -> str:
        """The measure as a line of the report."""
        return f"{self.name:<44} {self.value:>10}   {self.aim}"


def read_package(package: Path) -> list[File]:
    """Every module below a folder."""
    paths = sorted(package.rglob("*.py"))
    texts = [path.read_text(encoding="utf-8") for path in paths]
    return [
        File(path.relative_to(package.parent), text, ast.parse(text))
        for path, text in zip(paths, texts, strict=True)
    ]


def measures(files: Sequence[File]) -> list[Measure]:
    """The measures of the whole package."""
    nodes = sum(1 for file in files for _ in file.nodes())
    lines = sum(file.code_lines() for file in files)
    wide = sum(len(line) > WIDEST for file in files for line in file.text.splitlines())
    lengths = [length(function) for file in files for function in file.functions()]
    folders = Counter(file.path.parent for file in files)
    crowded = sum(count > MOST_FILES for count in folders.values())
    loaded = sum(is_loaded(function) for file in files for function in file.functions())
    return [
        Measure("modules", f"{len(files)}", ""),
        Measure("syntax nodes", f"{nodes:,}", "at most 230,000"),
        Measure("lines of code", f"{lines:,}", "at most 25,500"),
        Measure("syntax nodes a line", f"{nodes / lines:.2f}", "at most 9"),
        Measure(f"lines of more than {WIDEST} columns", f"{wide}", "none"),
        Measure("functions: median lines", f"{median(lengths):g}", "at most 6"),
        Measure("functions: most lines", f"{max(lengths)}", "at most 40"),
        Measure(f"functions of more than {MOST_PARAMETERS} parameters", f"{loaded}", "commands"),
        Measure(f"folders of more than {MOST_FILES} files", f"{crowded}", "none"),
        Measure("uses of Any", f"{uses_of_any(files)}", "as few as types allow"),
    ]


def length(function: Function) -> int:
    """The lines of a function, from its `def` to its end."""
    return (function.end_lineno or 0) - function.lineno + 1


def is_loaded(function: Function) -> bool:
    """Whether a function takes too many parameters, `self` not counted."""
    named = [*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs]
    own = [parameter for parameter in named if parameter.arg not in ("self", "cls")]
    return len(own) > MOST_PARAMETERS


def uses_of_any(files: Sequence[File]) -> int:
    """How often the type Any is written."""
    names = (node for file in files for node in file.nodes() if isinstance(node, ast.Name))
    return sum(name.id == "Any" for name in names)


def main() -> int:
    """Print every measure."""
    for measure in measures(read_package(PACKAGE)):
        print(measure.line())
    return 0


if __name__ == "__main__":
    sys.exit(main())
