"""How hypothesis runs (the same examples every time where CI is set, new ones elsewhere), and a small exam for all."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

from tests.small_class import generate, write_class

COMMON = {"deadline": None, "suppress_health_check": [HealthCheck.too_slow, HealthCheck.filter_too_much]}
settings.register_profile("ci", max_examples=50, derandomize=True, **COMMON)
settings.register_profile("new", max_examples=50, **COMMON)
settings.load_profile("ci" if os.environ.get("CI") else "new")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--regenerate-golden", action="store_true", help="Write the files of tests/golden/ anew.")


@pytest.fixture(scope="session")
def small_class(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with bank.toml, roster.csv and the EXAM generated from them; to be read, not to be changed."""
    folder = write_class(tmp_path_factory.mktemp("class"))
    result = generate(folder)
    if result.exit_code != 0:
        raise RuntimeError(result.stderr)
    return folder
