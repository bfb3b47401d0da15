"""The page says of an answer what `kinegrade grade` says."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from tests.practice.graded import compare_verdicts

BANKS = Path(__file__).parent.parent.parent / "banks"


def test_verdicts_are_those_of_the_marks(tmp_path: Path) -> None:
    pairs = compare_verdicts(BANKS / "demo.toml", tmp_path, draws=16, seed=1)
    assert [pair for pair in pairs if not pair.agrees] == []
    kinds = Counter(pair.marked.split(" ")[0] for pair in pairs)
    assert {"right", "mistake", "follow-through", "wrong", "unreadable"} <= kinds.keys()
