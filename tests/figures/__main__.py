"""Figures for a grader, and taking the grades over into the table that the tests hold.

    python -m tests.figures grade-sheet OUT --seed 7 [--seed 8] [TEMPLATE ...]
    python -m tests.figures take OUT/grades.csv
    python -m tests.figures forget

The first writes a page of figures for each template and a table whose grades (A, B or C) and
reasons the grader fills in; the second puts the rows that are filled in into `grades.csv`; the
third takes out the rows of figures that have changed since.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from kinegrade.problem.template.library.library import find_template_names
from tests.figures.sheet import GRADES, forget_changed, take_grades, write_sheet


def main(arguments: Sequence[str] | None = None, grades: Path = GRADES) -> None:
    """Write a sheet, or take its grades."""
    parser = argparse.ArgumentParser(prog="python -m tests.figures")
    commands = parser.add_subparsers(dest="command", required=True)
    sheet = commands.add_parser("grade-sheet")
    sheet.add_argument("folder", type=Path)
    sheet.add_argument("templates", nargs="*", metavar="TEMPLATE")
    sheet.add_argument("--seed", action="append", required=True)
    commands.add_parser("take").add_argument("filled", type=Path)
    commands.add_parser("forget")
    asked = parser.parse_args(arguments)
    if asked.command == "take":
        take_grades(asked.filled, grades)
    elif asked.command == "forget":
        forget_changed(grades)
    else:
        write_sheet(asked.folder, asked.templates or find_template_names(), asked.seed)


if __name__ == "__main__":
    main()
