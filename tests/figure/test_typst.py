"""The Typst back end's own ways; what it shares with the other stands in test_back_ends."""

from __future__ import annotations

import json

import pytest
import typst

from kinegrade.figure.extent import symbol_size
from kinegrade.figure.names import point_symbol
from kinegrade.figure.scene import Scene
from kinegrade.figure.typst import math_to_typst, to_typst

SYMBOLS = [
    "O",
    "O_1",
    "O'",
    "r",
    "k r",
    "l_{AB}",
    r"\omega",
    r"\omega_0",
    r"\varphi",
    r"\theta_1",
    "v_B",
    r"\rho",
]
SYMBOLS += [
    r"\mathrm{II}",
    r"\mathrm{III}",
    "R",
    "M",
    "W",
    r"\varepsilon",
    r"\Omega_{AB}",
    r"\sqrt{3} r",
    "2 r",
    "w",
]


def test_the_box_has_the_size_of_the_scene() -> None:
    source = to_typst(Scene(30.0, 20.0, 1.0, ()))
    assert source.startswith("#box(width: 30mm, height: 20mm, {")


def test_the_estimated_room_holds_every_symbol_typst_sets() -> None:
    measured = ",".join(f"measure({math_to_typst(symbol)})" for symbol in SYMBOLS)
    sizes = f"({measured}).map(s => (s.width.mm(), s.height.mm()))"
    page = f"#set text(size: 9pt)\n#context [#metadata({sizes})<size>]"
    found = json.loads(typst.query(page.encode(), "<size>", field="value", one=True))
    for symbol, (width, height) in zip(SYMBOLS, found, strict=True):
        room = symbol_size(symbol)
        assert width <= room[0] + 0.05, symbol
        assert height <= room[1] + 0.05, symbol
        assert room[0] < 1.7 * width + 1.0, symbol


@pytest.mark.parametrize(
    ("name", "symbol"), [("O", "O"), ("O1", "O_{1}"), ("Op", "O'"), ("hub", r"\mathrm{hub}")]
)
def test_point_names_become_symbols(name: str, symbol: str) -> None:
    assert point_symbol(name) == symbol


def test_primes_are_raised() -> None:
    assert math_to_typst("O'") == "$O^(prime)$"
