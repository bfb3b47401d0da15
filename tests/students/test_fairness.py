"""The simulation of `python -m benchmarks.fairness` notices unfair marks; `tests/prove/fair_marks.py`
shows that marks are fair.
"""

from __future__ import annotations

import pytest

from benchmarks.fairness import Fairness, fairness, main, row, summary
from benchmarks.simulated_class import Answer, classes
from benchmarks.students import honest_students, mistaken_students
from kinegrade.problem.template.library.library import load_template


def test_the_simulation_notices_unfair_marks(monkeypatch: pytest.MonkeyPatch) -> None:
    """An honest student who types a hundredth and a half more, and a mistake that the key does not
    know.
    """
    (simulated,) = classes(load_template("slider-crank"), 2)
    way, answers = next(iter(honest_students(simulated)))
    off = [
        {ask: Answer(f"{1.015 * answer.value:.4g}", answer.value) for ask, answer in each.items()}
        for each in answers
    ]
    monkeypatch.setattr("benchmarks.fairness.honest_students", lambda simulated: [(way, off)])
    found = fairness("slider-crank", 2, measured=False)
    assert not found.full()
    assert not found.kept()
    assert found.broken[0].startswith(f"honest, {way}: slider-crank at r = ")


def test_a_mistake_is_not_named_for_another(monkeypatch: pytest.MonkeyPatch) -> None:
    (simulated,) = classes(load_template("slider-crank"), 2)
    reversed_ = [
        {ask: Answer(answer.typed, 1e6, "coriolis-dropped") for ask, answer in each.items()}
        for answers in mistaken_students(simulated, rounded=False)
        for each in answers
        if any(answer.mistake == "sense-reversed" for answer in each.values())
    ]
    monkeypatch.setattr(
        "benchmarks.fairness.mistaken_students", lambda simulated, rounded: [reversed_]
    )
    found = fairness("slider-crank", 2, measured=False)
    assert found.diagnosed() == 0
    assert sum(found.confused.values()) == found.mistakes["given"] > 0
    assert found.confused["coriolis-dropped", "sense-reversed"]


def test_the_table_and_the_totals(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.argv", ["fairness", "--draws", "2", "slider-crank"])
    assert main() == 0
    told = capsys.readouterr().out
    assert "slider-crank " in told
    assert "promised  known mistakes that got full marks: 0 of " in told
    assert told.endswith("\nkept\n")
    monkeypatch.setattr("benchmarks.fairness.Fairness.kept", lambda found: False)
    assert main() == 1
    assert row("none", Fairness("none")).startswith("none ")
    assert "100.0000%" in " ".join(summary(Fairness("none")))
