"""Answers of a template held against positions: those at the time t from the loop of its mechanism,
differentiated, without anything of the program.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TypeAlias

import pytest
from mpmath import mp, mpf

import kinegrade

Given: TypeAlias = Mapping[str, mpf]
Answers: TypeAlias = dict[str, mpf]
Case: TypeAlias = tuple[str, Callable[[Given], Answers], dict[str, int | str]]
MINUTE = mpf(60)  # in seconds
HOUR = 60 * MINUTE
METRE = mpf(1000)  # in millimetres; a kilometre in metres


def hold(name: str, work_out: Callable[[Given], Answers], given: dict[str, int | str]) -> None:
    """Every ask of the template has the value that its positions give, in the ask's unit."""
    answers = kinegrade.template(name).solve(**given)
    with mp.workdps(40):
        expected = work_out({letter: mpf(value) for letter, value in given.items()})
        assert set(expected) == set(answers)
        for ask, value in expected.items():
            assert answers[ask].value == pytest.approx(float(value), rel=1e-12, abs=1e-12), ask
