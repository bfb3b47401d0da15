"""Figures for swell paper, by a column of the roster or one by one; through the command line."""

from __future__ import annotations

from pathlib import Path
from zipfile import ZipFile

import pytest

from kinegrade.language.known import known_languages
from kinegrade.language.math.braille import label_in_braille
from tests.figures.tactile_flaws import find_tactile_flaws
from tests.small_class import generate, key_lines, kinegrade, write_class

ROSTER = """student,name,format
007,Ann Lee,
0012,Ben Ho,tactile
"""


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of the small class in which one student reads by touch."""
    folder = write_class(tmp_path_factory.mktemp("tactile"))
    (folder / "roster.csv").write_text(ROSTER, encoding="utf-8")
    result = generate(folder, "EXAM")
    assert result.exit_code == 0, result.stderr
    return folder / "EXAM"


def test_who_reads_by_touch_has_sheets_beside_the_usual_paper(exam: Path) -> None:
    files = {file.name for file in (exam / "papers").iterdir()}
    assert files == {"007.pdf", "0012.pdf", "0012.tactile.zip"}


def test_each_sheet_keeps_its_distances(exam: Path) -> None:
    with ZipFile(exam / "papers" / "0012.tactile.zip") as archive:
        sheets = [name for name in archive.namelist() if name.endswith(".svg")]
        assert sheets[:2] == ["q1-1.svg", "q1-2.svg"]
        for name in sheets:
            assert list(find_tactile_flaws(archive.read(name).decode())) == []


def test_the_key_says_what_each_label_names_and_describes_the_figure(exam: Path) -> None:
    with ZipFile(exam / "papers" / "0012.tactile.zip") as archive:
        lines = archive.read("key.txt").decode().splitlines()
    assert lines[0].startswith("How to read the sheets.")
    assert lines[2:5] == [
        "Question 1: Slider-crank mechanism",
        "q1-1.svg: the mechanism",
        "⠠⠕  O: a point",
    ]
    assert "⠗  r: the distance from O to A" in lines
    assert "OA turns about the fixed pin O." in "\n".join(lines)
    named = [line.split("  ")[0] for line in lines if line[:1] > "\u2800"]
    assert [cells for cells in named if not cells] == []


def test_sheets_are_made_later_with_the_same_numbers_and_handed_out(
    exam: Path, tmp_path: Path
) -> None:
    before = key_lines(exam)
    target = tmp_path / "sheets.zip"
    assert kinegrade("paper", exam, "0012", "--tactile", "-o", target).exit_code == 0
    assert target.read_bytes() == (exam / "papers" / "0012.tactile.zip").read_bytes()
    assert kinegrade("paper", exam, "007", "--tactile", "-o", tmp_path / "7.zip").exit_code == 0
    assert key_lines(exam) == before
    assert kinegrade("papers", exam, "-o", tmp_path / "OUT").exit_code == 0
    assert (tmp_path / "OUT" / "0012.tactile.zip").exists()


def test_sheets_are_a_file_of_their_own(exam: Path, tmp_path: Path) -> None:
    for option in ("--solution", "--large-print"):
        refused = kinegrade("paper", exam, "007", "--tactile", option, "-o", tmp_path / "a.zip")
        assert refused.exit_code == 2
        assert "leave out --tactile" in refused.stderr
    refused = kinegrade("paper", exam, "007", "--tactile", "-o", tmp_path / "a.pdf")
    assert refused.exit_code == 2
    assert ".zip" in refused.stderr


@pytest.mark.parametrize(
    ("language", "cells"),
    [
        ("en", ("⠠⠁", "⠨⠋", "⠧⠢⠠⠁", "⠠⠕⠢⠼⠁", "⠼⠁", "⠼⠃")),
        ("de", ("⠘⠁", "⠰⠋", "⠧⠡⠘⠁", "⠘⠕⠡⠼⠁", "⠼⠁", "⠼⠃")),
        ("zh", ("⠠⠁", "⠨⠋", "⠧⠢⠠⠁", "⠠⠕⠢⠼⠁", "⠼⠁", "⠼⠃")),
    ],
)
def test_letters_are_written_as_the_mathematics_of_the_language_does(
    language: str, cells: tuple[str, ...]
) -> None:
    symbols = ["A", r"\varphi", "v_A", "O_{1}", "1", r"\frac{3R}{2}"]
    assert tuple(label_in_braille(symbols, language).values()) == cells


@pytest.mark.parametrize("language", sorted(known_languages()))
def test_each_greek_letter_has_its_own_cells(language: str) -> None:
    letters = [
        rf"\{name}"
        for name in [
            "alpha",
            "beta",
            "gamma",
            "delta",
            "varepsilon",
            "eta",
            "theta",
            "lambda",
            "rho",
            "varphi",
            "psi",
            "omega",
        ]
    ]
    cells = label_in_braille(letters, language)
    assert len(set(cells.values())) == len(letters)
