"""A class is printed and marked with few garbage collections; afterwards there are as many as
before.
"""

from __future__ import annotations

import gc
import subprocess
import sys
from collections.abc import Iterator

import pytest

from kinegrade.processes import garbage_collection
from kinegrade.processes.garbage_collection import NEW_OBJECTS, bulk_work, is_frozen


@pytest.fixture(autouse=True)
def _counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is frozen is counted, which the suite does not."""
    monkeypatch.setattr(garbage_collection, "is_frozen", is_frozen)


@pytest.fixture
def _nothing_frozen() -> Iterator[None]:
    """As in a program that froze nothing; the suite itself did."""
    gc.unfreeze()
    yield
    gc.freeze()


@pytest.mark.usefixtures("_nothing_frozen")
def test_garbage_is_collected_rarely_and_afterwards_as_often_as_before() -> None:
    usual = gc.get_threshold()
    with bulk_work():
        assert gc.get_threshold()[0] == NEW_OBJECTS
        assert gc.get_freeze_count() > 0
    assert (gc.get_threshold(), gc.get_freeze_count()) == (usual, 0)


def test_what_was_frozen_before_stays_frozen() -> None:
    gc.freeze()
    assert is_frozen()
    with bulk_work():
        pass
    assert is_frozen()


def test_a_failure_leaves_it_as_it_was_too() -> None:
    usual = gc.get_threshold()
    with pytest.raises(KeyError), bulk_work():
        raise KeyError
    assert gc.get_threshold() == usual


def test_a_command_that_ends_looks_for_no_cycles_in_what_it_loaded() -> None:
    code = """
import atexit, gc, sys
from kinegrade.__main__ import start
atexit.register(lambda: print("left to search:", len(gc.get_objects())))
sys.argv = ["kinegrade", "--version"]
start()
"""
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True)
    assert int(ran.stdout.split()[-1]) < 1_000
