"""Banks as a test writes them, and what is wrong with one."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import BankError
from kinegrade.exam.bank.bank import read_bank
from kinegrade.exam.bank.blueprint import Bank

HEAD = 'title = "Midterm"\ncourse = { en = "Mechanics", zh = "力学" }\n'


SHARE = 'expected a share from 0 to 1, like 0.5, "50 %" or "1/2"'


QUESTION = '[[questions]]\ntemplate = "slider-crank"\n'


def bank(folder: Path, text: str) -> Bank:
    file = folder / "bank.toml"
    file.write_text(text, encoding="utf-8")
    return read_bank(file)


def faults(folder: Path, text: str) -> list[str]:
    """The problems, without the folder that stands before each."""
    with pytest.raises(BankError) as caught:
        bank(folder, text)
    where = f"{folder}/"
    assert [
        problem
        for problem in caught.value.problems
        if not (problem.startswith(where) and "\n" not in problem)
    ] == []
    return [problem.removeprefix(where) for problem in caught.value.problems]
