"""A practice sheet says of what students type what `kinegrade grade` says, template by template."""

from __future__ import annotations

from pathlib import Path

from tests.practice.graded import compare_verdicts
from tests.practice.test_reader import compare_made_up
from tests.prove.draws import seeded_template

DRAWS = 12
BANK = """title = "Practice"
course = "Mechanics"

[[questions]]
template = "{template}"
"""


def hold(seed: int, folder: Path) -> None:
    """Compare the verdicts on a class's answers to the template of a seed."""
    bank = folder / f"practice-{seed}.toml"
    bank.write_text(BANK.format(template=seeded_template(seed)), encoding="utf-8")
    work = folder / f"practice-{seed}"
    work.mkdir(parents=True, exist_ok=True)
    pairs = compare_verdicts(bank, work, DRAWS, seed)
    assert [pair for pair in pairs if not pair.agrees] == []
    compare_made_up(seed, 200)
