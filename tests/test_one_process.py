"""Commands in the process of the tests leave the other cores to other tests."""

from __future__ import annotations

import pytest

from kinegrade.cli import main
from tests.one_process import list_options


def test_a_command_that_is_told_no_number_works_in_one_process(
    request: pytest.FixtureRequest,
) -> None:
    numbers = {option.name: option.default for option in list_options(main, "jobs")}
    proves = request.config.getoption("--hypothesis-profile") == "prove"
    assert proves or numbers == {"jobs": 1}
