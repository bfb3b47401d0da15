"""The smallest template there is, whose answers are seen at a glance: v_x = -omega h, v_y = omega
sqrt(r^2 - h^2).
"""

from __future__ import annotations

from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.template import Template

TEXT = r"""
family = "crank"
title = { en = "A crank", zh = "曲柄" }
source = "by hand"
joints = ["pin O: ground OA"]
inputs = [{ motion = "OA turns", velocity = "omega" }]
conditions = ["omega < 10000000"]

[statement]
en = '''The crank {{ r }} turns with {{ omega }}; $A$ is {{ h.value }} above $O$.'''
zh = '''曲柄 {{ r }} 以 {{ omega }} 转动，$A$ 高于 $O$ {{ h.value }}。'''

[parameters]
r     = { unit = "m", draw = [1, 2], means = { en = "length of the crank", zh = "曲柄的长度" } }
h     = { unit = "m", draw = [0, "1/2", 3], means = { en = "height of A", zh = "A 的高度" } }
omega = { unit = "rad/s", draw = [2, 1000000, 20000000], means = { en = "angular velocity", zh = "角速度" } }

[points]
O = "(0, 0)"
P = "(0, h)"
A = "meet(circle(O, r), line(P, 0), right)"

[bodies]
OA = "O A"

[asks]
v_x = { quantity = "x(velocity(A))", unit = "m/s", sign = "+x", points = 2, means = { en = "along x", zh = "沿 x 轴" } }
v_y = { quantity = "y(velocity(A))", unit = "m/s", sign = "+y", means = { en = "along y", zh = "沿 y 轴" } }

[[published]]
source = "by hand"
gives = { v_x = "-omega*h" }
"""


def crank_text(*changes: tuple[str, str]) -> str:
    """The template's text with some passages replaced; each must occur."""
    text = TEXT
    for old, new in changes:
        if old not in text:
            raise ValueError(f"{old!r} does not occur")
        text = text.replace(old, new)
    return text


def crank(*changes: tuple[str, str], kept: bool = False) -> Template:
    """The template with some passages replaced; `kept` as an exam keeps it, without a look at
    dimensions.
    """
    return read_template("crank", crank_text(*changes), kept=kept)
