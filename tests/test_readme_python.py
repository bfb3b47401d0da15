"""The lines of Python in the README do what they say, one after another."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import sympy

ROOT = Path(__file__).parent.parent
ROSTER = "student,name\n007,Ann\n0012,Ben\n"


def test_the_python_of_the_readme_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (block,) = re.findall(
        r"```python\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL
    )
    (tmp_path / "roster.csv").write_text(ROSTER, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    exec(block, names)
    assert names["answers"]["v_B"].sympy() == 2 * sympy.sqrt(3) / 15  # type: ignore[index]
    made = {path.name for path in tmp_path.iterdir()}
    assert made == {
        "roster.csv",
        "EXAM",
        "MARKS",
        "moodle.csv",
        "FEEDBACK",
        "report.html",
        "quiz.xml",
    }
