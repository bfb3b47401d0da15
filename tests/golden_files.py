"""A tiny exam whose files are held as goldens, how a text is held against its file, and which tests
do so.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from kinegrade.exam.bank.bank import Bank
from kinegrade.exam.folder.exam_secret import FromWords
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.students import Student
from kinegrade.exam.setting.dealing import deal_exam
from kinegrade.exam.setting.setting import SetPaper

GOLDEN = Path(__file__).parent / "golden"
BANK = """title = { en = "Golden exam", zh = "样卷" }
course = { en = "Mechanics", zh = "力学" }
date = 2026-05-01
[[questions]]
template = "crank.toml"
draw = { h = [0, 1], r = [2, 3, 4], omega = [2, 3, "sqrt(2)"] }
asks = { v_x = 1, v_y = { points = 2.5, tolerance = { absolute = 0.05 } } }
"""
Hold = Callable[[str, str], None]


def papers(bank: Bank) -> list[SetPaper]:
    students = Student("007", "王伟", "", "007"), Student("0012", "O'Neil, Zoë", "", "0012")
    return list(deal_exam(bank, Roster(students, ()), FromWords("golden")).papers())


def drop_tests_without_goldens(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave all tests that hold no text against a golden file out of a run, and say how many."""
    left = [item for item in items if not holds_a_golden(item)]
    config.hook.pytest_deselected(items=left)
    items[:] = [item for item in items if holds_a_golden(item)]


def holds_a_golden(item: pytest.Item) -> bool:
    """Whether a test uses the fixture `hold`, itself or through another."""
    return isinstance(item, pytest.Function) and "hold" in item.fixturenames
