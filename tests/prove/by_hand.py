"""Students written from the textbook are marked as they deserve: a class of one template."""

from __future__ import annotations

import shutil
from pathlib import Path

from tests.by_hand.claims import following, honest, mistaken
from tests.by_hand.class_list import TAUGHT
from tests.by_hand.exceptions import NEEDS_FOUR_FIGURES, ROUNDED_AWAY, unnamed
from tests.by_hand.pad import EXACT
from tests.by_hand.school import FOUR_FIGURES, THREE_FIGURES, Exam, make_exam

STUDENTS = 300
TURNS = 2


def hold(seed: int, folder: Path) -> None:
    """Set the exam of a seed, and try honest and mistaken students and those who go on from a wrong
    value.
    """
    place = folder / "by hand"
    template = list(TAUGHT)[seed % len(TAUGHT)]
    place.mkdir()
    try:
        _try(make_exam(place / "four", (template,), STUDENTS, FOUR_FIGURES, f"prove {seed}"))
        if template not in NEEDS_FOUR_FIGURES:
            three = make_exam(
                place / "three", (template,), STUDENTS, THREE_FIGURES, f"prove {seed}"
            )
            _carry(three)
    finally:
        shutil.rmtree(place)


def _carry(exam: Exam) -> None:
    found = honest(exam, 3)
    assert found.share <= ROUNDED_AWAY, f"three figures: {found}"


def _try(exam: Exam) -> None:
    for figures in (EXACT, 4):
        found = honest(exam, figures)
        assert not found.failed, f"{figures} figures: {found}"
    found = mistaken(exam, TURNS)
    assert unnamed(found) == set(), str(found)
    found = following(exam, TURNS)
    assert found.beyond(0) == set(), str(found)
