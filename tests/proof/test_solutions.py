"""`check` writes the worked solution of every ask by every method, before an exam needs it."""

from __future__ import annotations

from collections.abc import Iterable

import pytest

from kinegrade.errors import MechanismError
from kinegrade.language import Language
from kinegrade.language.message import Message
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import METHODS, Method
from kinegrade.proof import solutions
from kinegrade.proof.checking import check
from kinegrade.proof.report import Report
from kinegrade.worked.document import WorkedSolution
from tests.said import all_said


def check_slider(monkeypatch: pytest.MonkeyPatch, failing: Iterable[Method]) -> Report:
    """The slider-crank checked where worked solutions fail by some methods."""
    written: list[tuple[tuple[str, ...], Method]] = []

    def write(
        solution: Solution, asks: Iterable[str], language: Language, method: Method
    ) -> WorkedSolution:
        written.append((tuple(asks), method))
        if method in failing:
            raise MechanismError(Message("template.number-of-a-vector"))
        return WorkedSolution(())

    monkeypatch.setattr(solutions, "write_worked_solution", write)
    template = load_template("slider-crank")
    report = check(template, sample=4)
    assert written == [(tuple(template.asks), method) for method in METHODS]
    return report


def test_every_ask_is_worked_out_by_every_method(monkeypatch: pytest.MonkeyPatch) -> None:
    assert all_said(check_slider(monkeypatch, ()).faults) == []


def test_a_method_without_a_worked_solution_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    (fault,) = all_said(check_slider(monkeypatch, ("pole",)).faults)
    assert fault.startswith("pole: no worked solution at ")
