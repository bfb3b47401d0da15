"""Damaged files through every door: no traceback, no hang, everybody accounted for."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.fuzz.case import run_case
from tests.fuzz.doors import DOORS, write_material
from tests.fuzz.failed_seeds import FAILED

pytestmark = pytest.mark.skipif(os.name != "posix", reason="the limit of time is a signal of POSIX")
ROUNDS = 8  # of all doors
FIRST = 1_000 * len(DOORS)


@pytest.fixture(scope="module")
def material(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Valid files for all doors."""
    folder = tmp_path_factory.mktemp("material")
    write_material(folder)
    return folder


@pytest.mark.parametrize("place", range(len(DOORS)))
def test_a_damaged_file_is_refused_or_read_with_everybody_in_it(
    material: Path, tmp_path: Path, place: int
) -> None:
    seeds = range(FIRST + place, FIRST + ROUNDS * len(DOORS), len(DOORS))
    outcomes = [run_case(seed, material, tmp_path / "case") for seed in seeds]
    assert [outcome for outcome in outcomes if outcome.fault] == []


@pytest.mark.parametrize("seed", FAILED)
def test_what_was_once_found_stays_mended(material: Path, tmp_path: Path, seed: int) -> None:
    assert run_case(seed, material, tmp_path / "case").fault == ""
