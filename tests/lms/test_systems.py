"""Every system for grades has its table, its golden file and its tests."""

from __future__ import annotations

import pytest

from kinegrade.lms.grades.dialect import Dialect
from kinegrade.lms.grades.systems import SYSTEMS
from tests.lms.proofs import TESTS, find_unproved


def test_every_system_is_proved() -> None:
    assert find_unproved(SYSTEMS, TESTS) == []


@pytest.mark.parametrize("dialect", SYSTEMS.values(), ids=SYSTEMS)
def test_every_system_takes_some_file(dialect: Dialect) -> None:
    assert dialect.downloads or dialect.new_file
