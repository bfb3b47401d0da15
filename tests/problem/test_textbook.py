"""Problems of textbooks, worked out by hand from positions and differentiated."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.problem import (
    textbook_drives,
    textbook_gears_and_ropes,
    textbook_linkages,
    textbook_machines,
)
from tests.problem.textbook import Answers, Given, hold

CASES = (
    *textbook_drives.CASES,
    *textbook_gears_and_ropes.CASES,
    *textbook_linkages.CASES,
    *textbook_machines.CASES,
)


@pytest.mark.parametrize(("name", "work_out", "given"), CASES)
def test_answers_are_those_of_positions(
    name: str, work_out: Callable[[Given], Answers], given: dict[str, int | str]
) -> None:
    hold(name, work_out, given)
