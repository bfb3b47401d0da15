"""`make golden` runs the tests that hold golden files, and misses none."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.golden_files import Hold, holds_a_golden

TESTS = Path(__file__).parent
KNOWS_THE_FOLDER = {"conftest.py", "golden_files.py"}  # the fixture `hold`, and where files stand


@pytest.fixture
def hold_twice(hold: Hold) -> Hold:
    return hold


def test_a_test_that_holds_a_golden_is_run(hold: Hold, request: pytest.FixtureRequest) -> None:
    assert holds_a_golden(request.node)


def test_so_is_one_that_does_through_another_fixture(
    hold_twice: Hold, request: pytest.FixtureRequest
) -> None:
    assert holds_a_golden(request.node)


def test_others_are_not(request: pytest.FixtureRequest) -> None:
    assert not holds_a_golden(request.node)


def test_golden_files_are_read_by_the_fixture_alone() -> None:
    sources = {
        file.relative_to(TESTS).as_posix(): file.read_text(encoding="utf-8")
        for file in TESTS.rglob("*.py")
        if file != Path(__file__)
    }
    assert {name for name, text in sources.items() if "GOLDEN" in text} == KNOWS_THE_FOLDER
    assert not [name for name, text in sources.items() if 'getfixturevalue("hold")' in text]
