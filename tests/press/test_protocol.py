"""What every press can print is what `Press` asks of the next one."""

from __future__ import annotations

import pytest

from kinegrade.press.protocol import Press
from tests.press.unshared import find_unshared


def test_a_press_is_asked_for_all_that_every_press_prints() -> None:
    assert find_unshared() == []


def test_a_press_that_lacks_a_sheet_cannot_be_made() -> None:
    half = type("HalfPress", (Press,), {"papers": None, "key": None, "unprintable": None})
    with pytest.raises(TypeError, match="HalfPress.*solutions"):
        half()
