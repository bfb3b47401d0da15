"""What is no choice among templates, or might give one twice, is refused before anything is set."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.exam.test_alternatives import set_exam


@pytest.mark.parametrize(
    ("entry", "fault"),
    [
        ('any = ["slider-crank", "slidr-crank"]', 'any[2]: no template "slidr-crank"'),
        ('any = ["slider-crank"]', "any: 1 templates to choose from - expected 2 to 26 of them"),
        ("any = []", "any: 0 templates to choose from - expected 2 to 26 of them"),
        ('any = ["slider-crank", "slider-crank"]', 'any: "slider-crank" is listed twice'),
        ('any = "slider-crank"', 'any: "slider-crank" - expected a list like ["slider-crank"'),
        ('any = ["slider-crank", "crossed-belt-drive"]\ntemplate = "slider-crank"',
         "expected one of template = "),
        ('any = ["slider-crank", "crossed-belt-drive"]\nper-student = true',
         "per-student: unknown key"),
        ('any = ["slider-crank", "crossed-belt-drive"]\nasks = { v_B = 1 }', "questions[1].asks: "),
        ('any = ["slider-crank", "bar-through-swivelling-sleeve"]',
         "points: alternatives carry different points: slider-crank "),
        ('template = "slider-crank"\nper-student = true', "per-student: unknown key"),
        ('tag = "rolling"\nper-student = 3', "per-student: 3 - expected true or false"),
        ('tag = "rolling"\nper-student = true', "points: alternatives carry different points: "),
        ('tag = "velocity"\nper-student = true\npoints = 9\nnumber = 40',
         "templates to choose from for each student - expected more than the 40 that each gets"),
    ],
)  # fmt: skip
def test_what_is_no_choice_is_refused(tmp_path: Path, entry: str, fault: str) -> None:
    made = set_exam(tmp_path, f"[[questions]]\n{entry}\n")
    assert made.exit_code == 2
    assert fault in made.stderr


def test_a_template_that_might_be_given_twice_is_refused(tmp_path: Path) -> None:
    entry = '[[questions]]\ntag = "rolling"\nper-student = true\npoints = 9\n'
    made = set_exam(tmp_path, entry + entry)
    assert made.exit_code == 2
    assert "may be given to a student twice: q1 draws it, too" in made.stderr
