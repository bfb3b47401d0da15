"""The usual sign conventions by their keywords, in words."""

from __future__ import annotations

from kinegrade.problem.template import Translated

CONVENTIONS = {
    "magnitude": Translated("magnitude, not negative", "大小，取非负值"),
    "ccw": Translated("counter-clockwise positive", "逆时针为正"),
    "+x": Translated("positive in the direction of $+x$", "沿 $x$ 轴正向为正"),
    "+y": Translated("positive in the direction of $+y$", "沿 $y$ 轴正向为正"),
    "unsigned": Translated("between 0° and 180°", "取 0° 至 180°"),
    "signed": Translated("with its sign", "带正负号"),
}
