"""What the examples in docstrings find: a bank, a roster, an exam and its marks, in a folder of
their own; modules that have none are not read for them.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import kinegrade

_AT_WORK = ("kinegrade.public.", "kinegrade.exam.roster.roster")  # modules whose examples need them
_PROMPT = b">>> "
_BANK = """title = "Quiz"
course = "Mechanics"

[[questions]]
template = "slider-crank"
asks = { v_B = 2 }
"""


def pytest_ignore_collect(collection_path: Path) -> bool | None:
    """Pass over a module that has neither tests nor examples."""
    if collection_path.suffix != ".py" or collection_path.name.startswith("test_"):
        return None
    return None if _PROMPT in collection_path.read_bytes() else True


@pytest.fixture(scope="session")
def _class_at_work(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with bank.toml, roster.csv, late.csv, answers.csv, EXAM and MARKS."""
    folder = tmp_path_factory.mktemp("examples")
    (folder / "bank.toml").write_text(_BANK, encoding="utf-8")
    (folder / "roster.csv").write_text("student,name\n007,Ann\n0012,Ben\n", encoding="utf-8")
    (folder / "late.csv").write_text("student,name\n0013,Cleo\n", encoding="utf-8")
    bank = kinegrade.Bank.read(folder / "bank.toml")
    roster = kinegrade.Roster.read(folder / "roster.csv")
    exam = kinegrade.generate(bank, roster, folder / "EXAM").exam
    right = exam.keys.line_of("007").questions[0].asks["v_B"].decimal
    (folder / "answers.csv").write_text(f"student,q1.v_B\n007,{right}\n", encoding="utf-8")
    kinegrade.grade(exam, folder / "answers.csv", folder / "MARKS")
    return folder


@pytest.fixture(autouse=True)
def _examples_at_work(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run the examples of the public names in a copy of that folder."""
    if not isinstance(request.node, pytest.DoctestItem):
        return
    if not request.node.name.startswith(_AT_WORK):
        return
    folder = request.getfixturevalue("tmp_path") / "work"
    shutil.copytree(request.getfixturevalue("_class_at_work"), folder)
    monkeypatch.chdir(folder)
    request.getfixturevalue("doctest_namespace")["kinegrade"] = kinegrade
