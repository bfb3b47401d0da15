"""Papers of an exam are alike long, filled, and name nothing as files do: the shipped banks, in both
languages, by both typesetters, on both sizes of paper.
"""

from __future__ import annotations

import shutil
from itertools import product
from pathlib import Path

from kinegrade.press.protocol import ENGINES
from kinegrade.problem.template.library.library import find_shipped, list_names
from tests.exam.printed_pages import list_faults
from tests.small_class import kinegrade

STUDENTS = 30
CHOICES = tuple(product(ENGINES, list_names(find_shipped("banks")), ("en", "zh"), ("a4", "letter")))


def hold(seed: int, folder: Path) -> None:
    """Set and print the exam of a seed."""
    place = folder / "printed pages"
    place.mkdir()
    try:
        faults = _print(seed, place)
    finally:
        shutil.rmtree(place)
    assert not faults, "; ".join(faults)


def _print(seed: int, place: Path) -> list[str]:
    engine, bank, language, size = CHOICES[seed % len(CHOICES)]
    rows = "".join(f"{number:04},张喆 Zoë\n" for number in range(STUDENTS))
    (place / "roster.csv").write_text(f"student,name\n{rows}", encoding="utf-8")
    words = ("--reproducible", f"prove {seed}", "--lang", language)
    result = kinegrade(
        *("generate", bank, place / "roster.csv", "-o", place / "EXAM", *words),
        *("--engine", engine, "--paper-size", size),
    )
    assert result.exit_code == 0, result.stderr
    return list_faults(place / "EXAM")
