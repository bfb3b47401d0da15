"""The sign convention of an ask: a usual one, by its keyword, or the author's own in words."""

from __future__ import annotations

from collections.abc import Mapping

from kinegrade.language import ENGLISH, Language
from kinegrade.problem.translated import Translated
from kinegrade.sign_conventions import Convention

Sign = Convention | Translated

_CHINESE = Language("zh")


def _words(english: str, chinese: str) -> Translated:
    return Translated(((ENGLISH, english), (_CHINESE, chinese)))


_WORDS: Mapping[Convention, Translated] = {
    "magnitude": _words("magnitude, not negative", "大小，取非负值"),
    "ccw": _words("counter-clockwise positive", "逆时针为正"),
    "cw": _words("clockwise positive", "顺时针为正"),
    "+x": _words("positive in the direction of $+x$", "沿 $x$ 轴正向为正"),
    "-x": _words("positive in the direction of $-x$", "沿 $x$ 轴负向为正"),
    "+y": _words("positive in the direction of $+y$", "沿 $y$ 轴正向为正"),
    "-y": _words("positive in the direction of $-y$", "沿 $y$ 轴负向为正"),
    "unsigned": _words("between 0° and 180°", "取 0° 至 180°"),
    "signed": _words("with its sign", "带正负号"),
}


def write_sign(sign: Sign, language: Language) -> str:
    """A sign convention in words.

    >>> write_sign("ccw", "en")
    'counter-clockwise positive'
    """
    words = sign if isinstance(sign, Translated) else _WORDS[sign]
    return words.in_language(language)
