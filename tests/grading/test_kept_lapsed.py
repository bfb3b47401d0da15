"""Marking again without --never-lower says that the totals which it had kept are kept no longer."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.grading.marked_folder import RIGHT, mark_class
from tests.small_class import kinegrade

HARSH = '[questions.q1.asks.v_B]\nvoid = "drop"\n'


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """EXAM, MARKS, and KEPT by a policy that would have lowered the total of the first student."""
    mark_class(tmp_path, {"007": (RIGHT[0], "9", "9"), "S9": RIGHT})
    (tmp_path / "harsh.toml").write_text(HARSH, encoding="utf-8")
    grade(tmp_path, "KEPT", "--never-lower", tmp_path / "MARKS")
    return tmp_path


def grade(folder: Path, name: str, *options: str | Path) -> list[str]:
    """What is said of totals that were kept when the class is marked by that policy."""
    files = folder / "EXAM", folder / "answers.csv", "-o", folder / name
    done = kinegrade("grade", *files, "--policy", folder / "harsh.toml", *options)
    assert done.exit_code in (0, 1), done.stderr
    return [line for line in done.stderr.splitlines() if "kept an earlier total there" in line]


def test_totals_that_are_kept_no_longer_are_named(folder: Path) -> None:
    since = "--since", folder / "KEPT", "--reason", "why"
    said = [
        f"{folder}/KEPT/kept.csv: 1 student kept an earlier total there; without --never-lower it "
        f"no longer holds; to keep it, give --never-lower {folder}/KEPT"
    ]
    assert grade(folder, "NEW", *since) == said
    assert grade(folder, "OTHER", *since, "--never-lower", folder / "KEPT") == []
    assert grade(folder, "KEPT", "--force") == said
    assert grade(folder, "KEPT", "--force") == []
