"""Sign conventions in words: the usual ones by a keyword, all others as texts in both languages."""

from __future__ import annotations

from typing import Any

from kinegrade.errors import ExpressionError, did_you_mean
from kinegrade.language import LANGUAGES

CONVENTIONS = {
    "magnitude": ("magnitude, not negative", "大小，取非负值"),
    "ccw": ("counter-clockwise positive", "逆时针为正"),
    "+x": ("positive in the direction of $+x$", "沿 $x$ 轴正向为正"),
    "+y": ("positive in the direction of $+y$", "沿 $y$ 轴正向为正"),
    "unsigned": ("between 0° and 180°", "取 0° 至 180°"),
    "signed": ("with its sign", "带正负号"),
}


def read_sign(sign: Any) -> tuple[str, str]:
    """(English, Chinese) words of a sign convention.

    >>> read_sign("ccw")[0]
    'counter-clockwise positive'
    """
    if isinstance(sign, str) and sign in CONVENTIONS:
        return CONVENTIONS[sign]
    if isinstance(sign, dict) and set(sign) == set(LANGUAGES):
        return str(sign["en"]), str(sign["zh"])
    if isinstance(sign, str):
        raise ExpressionError(
            f'sign "{sign}": {did_you_mean(sign, CONVENTIONS)}, or {{ en = "...", zh = "..." }}'
        )
    raise ExpressionError('sign: expected a keyword, or texts { en = "...", zh = "..." }')
