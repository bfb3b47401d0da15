"""The banks of the term."""

from __future__ import annotations

from pathlib import Path

from tests.problem.crank import crank_text

TYPO = ("The crank {{ r }} turns", "The crnak {{ r }} turns")
MIDTERM = """title = { en = "Midterm", zh = "期中考试" }
course = { en = "Mechanics", zh = "力学" }
date = 2027-05-04

[[questions]]
template = "slider-crank"
asks = { v_B = 4 }

[[questions]]
template = "crank.toml"
draw = { h = ["1/2"], r = [1, 2, 3], omega = "1 .. 200 step 1" }
asks = { v_y = 3 }

[[questions]]
title = { en = "Theory", zh = "理论题" }
text = { en = "When is a velocity zero?", zh = "速度何时为零？" }
points = 5
space = "2 cm"
"""
QUESTION = """
[[questions]]
template = "slider-crank"
"""


def write_bank(folder: Path, text: str = MIDTERM) -> Path:
    """A bank, and beside it a template with a typo in its statement."""
    (folder / "crank.toml").write_text(crank_text(TYPO), encoding="utf-8")
    path = folder / "bank.toml"
    path.write_text(text, encoding="utf-8")
    return path
