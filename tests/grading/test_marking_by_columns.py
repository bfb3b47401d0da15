"""A class is marked by the arrays beside its key as it is by the key itself, byte for byte."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks.large_class import write_class
from kinegrade.exam.folder.contents import KEY_COLUMNS
from kinegrade.exam.folder.exam_folder import open_exam
from kinegrade.grading.grade import MarkingWishes, grade

POLICIES = {
    "as printed": "",
    "another rule": 'attempts = "first"\ntolerance = { relative = "2 %" }\n',
    "shares for mistakes": 'credit = { mistakes = { sense-reversed = "1/4" }, wrong-unit = "1/2" }\n',
    "figures": "tolerance = { figures = 3 }\n",
}


def contents(folder: Path) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in sorted(folder.iterdir())}


@pytest.mark.parametrize("policy", POLICIES.values(), ids=POLICIES)
def test_marks_by_columns_are_marks_by_the_key(tmp_path: Path, policy: str) -> None:
    write_class(tmp_path, 300, 0.1)
    (tmp_path / "policy.toml").write_text(policy, encoding="utf-8")
    exam = tmp_path / "EXAM"
    wishes = MarkingWishes(policy=tmp_path / "policy.toml" if policy else None)

    def mark(name: str) -> dict[str, bytes]:
        grade(open_exam(exam), tmp_path / "answers.csv", tmp_path / name, wishes)
        return contents(tmp_path / name)

    assert (exam / KEY_COLUMNS).exists()
    by_columns = mark("BY_COLUMNS")
    (exam / KEY_COLUMNS).unlink()
    by_key = mark("BY_KEY")
    assert by_columns == by_key
    assert by_key["marks.csv"].count(b"\n") == 3001
