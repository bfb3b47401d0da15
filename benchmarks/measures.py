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
LONGEST_MODULE = 250  # lines, with docstrings and comments
MOST_PARAMETERS = 6
MOST_FILES = 20
COMMANDS = PACKAGE.name + "/cli/"  # a command's parameters are its options


@dataclass(frozen=True)
class Measure:
    """One figure of the house, and the most that it should be; None where there is no such aim."""

    name: str
    value: float
    most: float | None = None

    @property
    def is_kept(self) -> bool:
        """Whether the figure is what it should be."""
        return self.most is None or self.value <= self.most

    def line(self) -> str:
        """The measure as a line of the report."""
        aim = "" if self.most is None else f"at most {_write(self.most)}"
        return f"{self.name:<44} {_write(self.value):>10}   {aim}".rstrip()


def _write(value: float) -> str:
    return f"{value:,}" if isinstance(value, int) else f"{value:.2f}"


def measures(files: Sequence[File]) -> list[Measure]:
    """The measures of the whole package."""
    nodes = sum(len(file.nodes) for file in files)
    lines = sum(file.code_lines() for file in files)
    return [
        Measure("modules", len(files)),
        Measure("syntax nodes", nodes, 230_000),
        Measure("lines of code", lines, 25_500),
        Measure("syntax nodes a line", nodes / lines, 9),
        Measure("uses of Any", uses_of_any(files)),
        *_measure_modules(files),
        *_measure_functions(files),
    ]


def _measure_modules(files: Sequence[File]) -> Iterator[Measure]:
    """The measures of modules and of the folders that hold them."""
    wide = sum(len(line) > WIDEST for file in files for line in file.text.splitlines())
    long = sum(file.text.count("\n") > LONGEST_MODULE for file in files)
    folders = Counter(file.path.parent for file in files)
    crowded = sum(count > MOST_FILES for count in folders.values())
    yield Measure(f"lines of more than {WIDEST} columns", wide, 0)
    yield Measure(f"modules of more than {LONGEST_MODULE} lines", long, 0)
    yield Measure(f"folders of more than {MOST_FILES} files", crowded, 0)


def _measure_functions(files: Sequence[File]) -> Iterator[Measure]:
    """The measures of functions, whose lines are counted as those of code are."""
    lengths = [length for file in files for length in file.function_lengths()]
    loaded = sum(
        is_loaded(function)
        for file in files
        if not file.path.as_posix().startswith(COMMANDS)
        for function in file.functions()
    )
    yield Measure("functions: median lines", median(lengths), 6)
    yield Measure("functions: most lines", max(lengths), 40)
    yield Measure(f"functions of more than {MOST_PARAMETERS} parameters", loaded, 0)


def is_loaded(function: Function) -> bool:
    """Whether a function takes too many parameters, `self` not counted."""
    named = [*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs]
    own = [parameter for parameter in named if parameter.arg not in ("self", "cls")]
    return len(own) > MOST_PARAMETERS


def uses_of_any(files: Sequence[File]) -> int:
    """How often the type Any is written."""
    names = (node for file in files for node in file.nodes if isinstance(node, ast.Name))
    return sum(name.id == "Any" for name in names)


def measure_all(files: Sequence[File]) -> list[Measure]:
    """Every measure, with what stands twice and what nothing uses."""
    return [
        *measures(files),
        Measure("functions that stand twice", len(duplicates(files)), 0),
        Measure("names that nothing uses", len(unused_names(PACKAGE)), 0),
    ]


def folder_lines(files: Sequence[File]) -> Iterator[str]:
    """A line for every folder: its files and lines of code, without the folders in it."""
    by_folder: dict[Path, list[File]] = {}
    for file in files:
        by_folder.setdefault(file.path.parent, []).append(file)
    for folder, held in sorted(by_folder.items()):
        lines = sum(file.code_lines() for file in held)
        yield f"{folder.as_posix() + '/':<44} {len(held):>4} files {lines:>7,} lines of code"


def main() -> int:
    """Print every measure, the size of every folder, then what stands twice or is used nowhere."""
    files = read_package(PACKAGE)
    for measure in measure_all(files):
        print(measure.line())
    for line in (*folder_lines(files), *duplicates(files), *unused_names(PACKAGE)):
        print(line)
    return 0


if __name__ == "__main__":
    sys.exit(main())
