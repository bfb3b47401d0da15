"""The widths by which equations are arranged, held against what Typst prints."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import pytest
import typst

from kinegrade.language import Language
from kinegrade.language.math.printed_size import measure_printed
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import Mark, Row
from kinegrade.language.math.typst.formula import write_typst_row
from kinegrade.press.typst.compiler import find_fonts
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.document import Display
from kinegrade.worked.solution import write_worked_solution

NAMES = ("slider-crank", "rod-ground-incline-fixed-centrode", "bar-pushing-rolling-disc")
LAYOUT = """
#show math.equation: set text(font: ("New Computer Modern Math", "Noto Serif SC"))
#set text(size: 10pt)
#let widths(..formulas) = context [#metadata(formulas.pos().map(formula =>
  measure(math.equation(block: true, formula.body)).width / 10pt)) <widths>]
"""


def list_rows(name: str, language: Language) -> list[Row]:
    """The lines of all displays of a template's solution."""
    solution = solve_template(load_template(name), {})
    blocks = write_worked_solution(solution, tuple(solution.template.asks), language).blocks
    lines = [line for block in blocks if isinstance(block, Display) for line in block.lines]
    return list(dict.fromkeys(tuple(n for n in line if n != Mark()) for line in lines))


def measure(rows: Sequence[Row], folder: Path) -> list[float]:
    """The widths that Typst prints, in em."""
    source = folder / "widths.typ"
    formulas = ", ".join(f"${write_typst_row(row)}$" for row in rows)
    source.write_text(f"{LAYOUT}#widths({formulas})\n", encoding="utf-8")
    answer = typst.query(
        str(source),
        "<widths>",
        field="value",
        one=True,
        font_paths=find_fonts(),
        ignore_system_fonts=True,
    )
    widths: list[float] = json.loads(answer)
    return widths


def test_no_direction_in_a_table_is_wider_than_it_is_taken_for(tmp_path: Path) -> None:
    directions = (r"\perp OA,\curvearrowleft", r"\perp AB,\curvearrowright")
    rows = [read_math(direction, "") for direction in directions]
    taken = [measure_printed(row).width for row in rows]
    printed = measure(rows, tmp_path)
    assert [
        (guess, real)
        for guess, real in zip(taken, printed, strict=True)
        if not (real < guess + 0.05)
    ] == []


@pytest.mark.parametrize("language", ["en", "zh"])
@pytest.mark.parametrize("name", NAMES)
def test_no_formula_is_wider_than_it_is_taken_for(
    name: str, language: Language, tmp_path: Path
) -> None:
    rows = list_rows(name, language)
    taken = [measure_printed(row).width for row in rows]
    printed = measure(rows, tmp_path)
    assert max(real - guess for guess, real in zip(taken, printed, strict=True)) < 0.05
    assert sum(taken) < 1.12 * sum(printed)
