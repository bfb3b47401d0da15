"""A class is printed and marked with few looks for rubbish, and leaves the looking as it found it."""

from __future__ import annotations

import gc

import pytest

from kinegrade.collection import NEW_OBJECTS, seldom_collected


def test_rubbish_is_seldom_looked_for_and_afterwards_as_often_as_before() -> None:
    usual = gc.get_threshold()
    with seldom_collected():
        assert gc.get_threshold()[0] == NEW_OBJECTS
        assert gc.get_freeze_count() > 0
    assert (gc.get_threshold(), gc.get_freeze_count()) == (usual, 0)


def test_a_failure_leaves_it_as_it_was_too() -> None:
    usual = gc.get_threshold()
    with pytest.raises(KeyError), seldom_collected():
        raise KeyError
    assert gc.get_threshold() == usual
