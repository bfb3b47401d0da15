"""What is known at the instant alone has no curve: it was drawn as if it stayed as it is."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.small_class import kinegrade

ROD = """family = "rod"
source = "Elementary"
title = "Rod on floor and wall"
language = "en"
statement = '''
The rod $AB$ of length {{ l }} stands on the floor at $A$, at the distance {{ s }} from the foot $O$ of the wall, and leans against the wall at $B$. $A$ moves away from
the wall with the velocity {{ u }}; $M$ is the middle of the rod.
'''
joints = ["A of AB slides on line(O, 0)", "B of AB slides on line(O, pi/2)"]
inputs = [{ motion = "A of AB moves along +x", velocity = "u" }]
[parameters]
l = { unit = "m", draw = "2 .. 3 step 0.1", means = "length of the rod" }
s = { unit = "m", draw = "0.5 .. 1.5 step 0.1", means = "distance of $A$ from $O$" }
u = { unit = "m/s", draw = "1 .. 2 step 0.1", means = "velocity of $A$" }
[lengths]
h = "sqrt(l**2 - s**2)"
[points]
O = "(0, 0)"
A = "(s, 0)"
B = "(0, h)"
M = "midpoint(A, B)"
[bodies]
AB = "A B"
[asks]
"""
ASK = '{ quantity = "QUANTITY", unit = "UNIT", sign = "magnitude", points = 1, means = "it" }\n'
ASKS = {
    "v_B": ("magnitude(velocity(B))", "m/s"),
    "OB": ("distance(O, B)", "m"),
    "OM": ("distance(O, midpoint(A, B))", "m"),
    "v_off": ("magnitude(velocity(M, AB))", "m/s"),
    "named": ("h", "m"),
    "given": ("sqrt(l**2 - s**2)", "m"),
    "rate": ("2*u", "m/s"),
}


@pytest.fixture
def rod(tmp_path: Path) -> Path:
    asks = (
        f"{name} = " + ASK.replace("QUANTITY", quantity).replace("UNIT", unit)
        for name, (quantity, unit) in ASKS.items()
    )
    file = tmp_path / "rod.toml"
    file.write_text(ROD + "".join(asks) + "[figure]\n", encoding="utf-8")
    return file


@pytest.mark.parametrize("name", ["v_off", "named", "given"])
def test_what_is_known_at_the_instant_alone_has_no_curve(rod: Path, name: str) -> None:
    done = kinegrade("cycle", rod, "--asks", name)
    assert done.exit_code == 2
    known = "v_B, OB, OM, rate"
    assert f'"{name}" has no curve over the cycle: choose from {known}' in done.stderr


def test_what_the_position_says_has_one(rod: Path) -> None:
    done = kinegrade("cycle", rod, "--set", "l=2", "--set", "s=1", "--asks", "OB,OM,rate")
    assert done.exit_code == 0, done.stderr
    assert "OB: least 0 m" in done.stdout
    assert "OM: 1 m throughout" in done.stdout
    assert "rate: 2 m/s throughout" in done.stdout
