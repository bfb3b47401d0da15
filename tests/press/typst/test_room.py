"""A symbol is measured by Typst only where it may be too wide for its column."""

from __future__ import annotations

import pytest

from kinegrade.language.message import Message
from kinegrade.press.typst.room import is_wide_symbol

WHERE = Message("typesetting.place-worked-solution")


@pytest.mark.parametrize("symbol", ["v_B", r"a_{A_c,\mathrm{r},x}", r"\omega_{BC}/\omega_{AB}"])
def test_small_scripts_make_no_symbol_wide(symbol: str) -> None:
    assert not is_wide_symbol(symbol, WHERE)


@pytest.mark.parametrize("symbol", ["v_{C,y}/v_{C,x}", r"\angle(v_{A}, v_{B})", "ABCDEFGH"])
def test_a_long_row_of_letters_is_wide(symbol: str) -> None:
    assert is_wide_symbol(symbol, WHERE)
