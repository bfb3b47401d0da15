"""`make measure`: how large and how dense the house is, beside what its rebuilding aims at."""

from __future__ import annotations

import ast
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median

from benchmarks.duplicates import duplicates
from benchmarks.modules import File, Function, read_package
from benchmarks.unused import unused_names

PACKAGE = Path(__file__).parent.parent / "kinegrade"
WIDEST = 100  # columns
MOST_PARAMETERS = 6
MOST_FILES = 20


@dataclass(frozen=True)
class Measure:
    """One figure of the house and what it should be, both as they are printed."""

    name: str
    value: str
    aim: str

    def line(self) -> str:
        """The measure as a line of the report."""
        return f"{self.name:<44} {self.value:>10}   {self.aim}"


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


def folder_sizes(files: Sequence[File]) -> Iterator[Measure]:
    """The files and lines of code of every folder, without the folders in it."""
    by_folder: dict[Path, list[File]] = {}
    for file in files:
        by_folder.setdefault(file.path.parent, []).append(file)
    for folder, held in sorted(by_folder.items()):
        lines = sum(file.code_lines() for file in held)
        yield Measure(f"{folder.as_posix()}/", f"{len(held)} files", f"{lines:,} lines of code")


def main() -> int:
    """Print every measure, the size of every folder, then what stands twice or is used nowhere."""
    files = read_package(PACKAGE)
    copies, unused = duplicates(files), unused_names(PACKAGE)
    counts = (
        Measure("functions that stand twice", f"{len(copies)}", "none"),
        Measure("names that nothing uses", f"{len(unused)}", "none"),
    )
    for measure in (*measures(files), *counts, *folder_sizes(files)):
        print(measure.line())
    for line in (*copies, *unused):
        print(line)
    return 0


if __name__ == "__main__":
    sys.exit(main())
