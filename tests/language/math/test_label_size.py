"""A label takes at least the room of its letters, as an independent measure has them."""

from __future__ import annotations

import pytest

from kinegrade.language.math.label_size import measure_label
from kinegrade.language.math.reading import read_math
from tests.figures.letters import measure_letters


@pytest.mark.parametrize(
    ("symbol", "text"), [("O", "O"), (r"\psi", "ψ"), ("O(O')", "O(O′)"), ("Q", "Q")]
)
def test_a_label_takes_the_room_of_its_letters(symbol: str, text: str) -> None:
    width, rise, fall = measure_letters(text)
    wide, high = measure_label(read_math(symbol, "figure"))
    assert wide > width
    assert high >= rise + fall
