"""The Typst back end's own ways; what it shares with the other stands in test_back_ends."""

from __future__ import annotations

import json
from struct import unpack
from zlib import decompress

import numpy as np
import pytest
import typst
from numpy.typing import NDArray

from kinegrade.errors import TypesetError
from kinegrade.figure.back_ends.typst import translate_symbol, write_typst, write_typst_picture
from kinegrade.figure.marks.names import write_point_symbol
from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.scene import (
    BOLD,
    FIRM,
    PITCH,
    THIN,
    Bow,
    Disc,
    Label,
    Outline,
    Scene,
    Strokes,
)
from kinegrade.mechanics.vector import Vector

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
    source = write_typst(Scene(30.0, 20.0, 1.0, ()))
    assert source.startswith("#box(width: 30mm, height: 20mm, {")


def test_the_estimated_room_holds_every_symbol_typst_sets() -> None:
    measured = ",".join(f"measure({translate_symbol(symbol)})" for symbol in SYMBOLS)
    sizes = f"({measured}).map(s => (s.width.mm(), s.height.mm()))"
    page = f"#set text(size: 9pt)\n#context [#metadata({sizes})<size>]"
    found = json.loads(typst.query(page.encode(), "<size>", field="value", one=True))
    for symbol, (width, height) in zip(SYMBOLS, found, strict=True):
        room = measure_symbol(symbol)
        assert width <= room[0] + 0.05, symbol
        assert height <= room[1] + 0.05, symbol
        assert room[0] < 1.7 * width + 1.0, symbol


@pytest.mark.parametrize(
    ("name", "symbol"), [("O", "O"), ("O1", "O_{1}"), ("Op", "O'"), ("hub", r"\mathrm{hub}")]
)
def test_point_names_become_symbols(name: str, symbol: str) -> None:
    assert write_point_symbol(name) == symbol


def test_primes_are_raised() -> None:
    assert translate_symbol("O'") == "$O'$"


def test_the_box_round_a_picture_prints_what_typst_draws_itself() -> None:
    corners = (Vector(4.0, 4.0), Vector(14.0, 4.0), Vector(14.0, 9.0))
    scene = Scene(
        30.0,
        20.0,
        1.0,
        (
            Disc(Vector(20.0, 10.0), 6.0, FIRM, "grey"),
            Outline(corners, THIN, "black"),
            Strokes(((Vector(2.0, 18.0), Vector(20.0, 10.0)),), BOLD),
            Bow(Vector(6.0, 12.0), 4.0, 0.3, 2.0, FIRM),
            Disc(Vector(20.0, 10.0), 0.9, FIRM, "white"),
            Label("O", Vector(23.0, 11.0), 3.0, 3.0),
        ),
    )
    drawn, pictured = (image_of(back_end(scene)) for back_end in (write_typst, write_typst_picture))
    assert drawn.min() == 0
    assert np.abs(blurred(drawn) - blurred(pictured)).max() < 64


def test_a_picture_refuses_a_label_that_is_no_symbol() -> None:
    scene = Scene(10.0, 10.0, 1.0, (Label(r"\input{x}", Vector(5.0, 5.0), 3.0, 3.0),))
    with pytest.raises(TypesetError, match="figure.labels: "):
        write_typst_picture(scene)


def test_dashes_are_the_same_in_a_picture_and_in_typst() -> None:
    wheel = Scene(30.0, 30.0, 1.0, (Disc(Vector(15.0, 15.0), 14.0, PITCH),))
    drawn, pictured = (image_of(back_end(wheel)) for back_end in (write_typst, write_typst_picture))
    assert abs((drawn < 128).mean() / (pictured < 128).mean() - 1) < 0.1


def image_of(box: str) -> NDArray[np.uint8]:
    """The box as it is printed, 8 pixels to the millimetre: how red each pixel is."""
    page = f"#set page(width: auto, height: auto, margin: 0mm)\n{box}\n"
    image = typst.compile(page.encode(), format="png", ppi=203.2)
    width, height = unpack(">II", image[16:24])
    chunks, at = [], 8
    while at < len(image):
        size, kind = unpack(">I4s", image[at : at + 8])
        chunks += [image[at + 8 : at + 8 + size]] if kind == b"IDAT" else []
        at += size + 12
    raw, lines = decompress(b"".join(chunks)), [bytearray(4 * width)]
    for start in range(0, height * (4 * width + 1), 4 * width + 1):
        lines.append(unfiltered(raw[start], raw[start + 1 : start + 1 + 4 * width], lines[-1]))
    return np.array(lines[1:], dtype=np.uint8)[:, ::4]


def unfiltered(kind: int, line: bytes, above: bytearray) -> bytearray:
    """A line of a PNG from its differences to its left and upper neighbours."""
    found = bytearray(line)
    for index in range(len(line)) if kind else ():
        left, corner = (found[index - 4], above[index - 4]) if index >= 4 else (0, 0)
        up = above[index]
        nearest = min((left, up, corner), key=lambda value: abs(left + up - corner - value))
        found[index] = (line[index] + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
    return found


def blurred(image: NDArray[np.uint8]) -> NDArray[np.float64]:
    """The means of squares of four pixels a side, which say nothing of the last pixel of an
    edge.
    """
    return image.reshape(image.shape[0] // 4, 4, -1, 4).mean(axis=(1, 3))
