"""Honest work gets full marks, known mistakes get none and are named: a class of one template."""

from __future__ import annotations

from pathlib import Path

from benchmarks.fairness import count_class
from benchmarks.simulated_class import simulated_class
from tests.prove.draws import seeded_template

STUDENTS = 20


def hold(seed: int, _: Path) -> None:
    """Simulate and mark the class of a seed."""
    found = count_class(simulated_class(seeded_template(seed), seed, STUDENTS), measured=False)
    assert found.instances == STUDENTS
    assert found.honest
    assert [name for name, count in found.honest.items() if not count["given"]] == []
    assert found.mistakes["given"]
    assert found.kept(), f"{found.template}: {found.diagnosed():.2%} named; {found.broken}"
