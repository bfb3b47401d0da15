"""Papers of many questions: sheets that nobody worked for earn next to nothing."""

from __future__ import annotations

import shutil
from pathlib import Path

from tests.by_hand.adversaries import earn, too_much
from tests.by_hand.class_list import TAUGHT
from tests.by_hand.school import FOUR_FIGURES, make_exam

STUDENTS = 30


def hold(seed: int, folder: Path) -> None:
    """Set the exam of a seed, and fill its papers without work."""
    place = folder / "whole papers"
    place.mkdir()
    try:
        exam = make_exam(place / "four", tuple(TAUGHT), STUDENTS, FOUR_FIGURES, f"prove {seed}")
        paid = too_much(earn(exam, STUDENTS))
    finally:
        shutil.rmtree(place)
    assert not paid, str(paid)
