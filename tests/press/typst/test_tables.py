"""Every table that the embedded typesetter prints has header cells, and every cell names its own."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from importlib.resources import files
from pathlib import Path

import pytest

from kinegrade.press.join import join_pages
from kinegrade.press.sheet import Paper
from kinegrade.press.typst.feedback import FeedbackPress
from tests.press.papers import CHINESE, ENGLISH, key_book
from tests.press.solutions import CHINESE_SOLUTION, ENGLISH_SOLUTION
from tests.press.tables import find_table_faults, read_pdf_tables
from tests.press.typst.test_feedback import sheet_of

PRESS = FeedbackPress()
TABLES = re.compile(r"(?<![\w-])table\(")
HEADERS = re.compile(r"table\.header\(")
Printed = Callable[[Path], bytes]


def with_questions(paper: Paper, count: int) -> Paper:
    """The paper with that many questions, for as many columns of marks."""
    first = paper.questions[0]
    numbers = range(1, count + 1)
    return replace(
        paper,
        questions=tuple(replace(first, number=each, identifier=f"q{each}") for each in numbers),
    )


# Each with the number of its tables
SHEETS: dict[str, tuple[int, Printed]] = {
    "paper": (2, lambda folder: PRESS.paper(ENGLISH)),
    "Chinese paper": (2, lambda folder: PRESS.paper(CHINESE)),
    "paper with two tables of marks": (
        16,
        lambda folder: PRESS.paper(with_questions(ENGLISH, 14)),
    ),
    "large paper": (1, lambda folder: PRESS.paper(replace(ENGLISH, large=True))),
    "large paper with marks downwards": (
        1,
        lambda folder: PRESS.paper(replace(with_questions(ENGLISH, 9), large=True)),
    ),
    "solution": (2, lambda folder: PRESS.solution(ENGLISH_SOLUTION)),
    "Chinese solution": (2, lambda folder: PRESS.solution(CHINESE_SOLUTION)),
    "large solution": (2, lambda folder: PRESS.solution(replace(ENGLISH_SOLUTION, large=True))),
    "feedback": (2, lambda folder: PRESS.feedback(sheet_of(folder / "M", ("1", "x", "0")))),
    "large feedback": (
        0,
        lambda folder: PRESS.feedback(replace(sheet_of(folder / "M", ("1", "x", "0")), large=True)),
    ),
    "key": (2, lambda folder: PRESS.key(key_book(2)).pdf),
    "volume": (4, lambda folder: join_pages([PRESS.paper(ENGLISH), PRESS.paper(CHINESE)])),
}


@pytest.mark.parametrize("name", SHEETS)
def test_every_cell_has_a_header(name: str, tmp_path: Path) -> None:
    count, printed = SHEETS[name]
    tables = read_pdf_tables(printed(tmp_path))
    assert len(tables) == count
    assert list(find_table_faults(tables)) == []
    assert [
        cell
        for table in tables
        for row in table
        for cell in row
        if not (cell.named or cell.is_header)
    ] == []


def test_no_layout_has_a_table_without_headers() -> None:
    folder = files("kinegrade.press.typst") / "layouts"
    layouts = {each.name: each.read_text(encoding="utf-8") for each in folder.iterdir()}
    tables = {name: len(TABLES.findall(text)) for name, text in layouts.items()}
    assert sum(tables.values()) >= 6
    assert {name: len(HEADERS.findall(text)) for name, text in layouts.items()} == tables


def test_the_signs_of_a_vector_equation_are_said_in_its_language() -> None:
    for sheet, equals in ((ENGLISH_SOLUTION, "equals"), (CHINESE_SOLUTION, "等于")):
        for large in (False, True):
            tables = read_pdf_tables(PRESS.solution(replace(sheet, large=large)))
            said = [cell.text for row in tables[0] for cell in row]
            assert any(each.startswith(equals) for each in said), said
