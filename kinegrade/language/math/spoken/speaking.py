"""Formulas in words, for those who hear a page or feel it as Braille: the text that stands in for a
formula in a PDF.

Numbers stay digits and letters stay letters, which every voice reads in its own language. Where a
fraction, a root or an index is more than one symbol, its end is said, so that no two formulas
sound alike.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache
from unicodedata import east_asian_width

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.spoken.nodes import say
from kinegrade.language.math.tree import Row
from kinegrade.language.message import Location

_BEFORE_PAUSE = re.compile(r"\s+(?=[,;，；])")
_PAUSES = re.compile(r"([,;，；])(?:\s*[,;，；])+")
_WIDE_PAUSES = "，；"
_ENDS = f" ,;{_WIDE_PAUSES}"


def speak_math(latex: str, where: Location, language: Language) -> str:
    r"""A formula in words.

    Raises TypesetError with every fault of the formula, each naming `where`.

    >>> speak_math(r"v_B = \frac{\sqrt{3}}{2}\,\unit{m/s}", "q1", Language("en"))
    'v B equals root 3 over 2 metres per second'
    """
    read_math(latex, where)
    return _speak_once(latex, language)


@lru_cache(maxsize=8192)
def _speak_once(latex: str, language: Language) -> str:
    """The same wherever it is used, so that the papers of a class share it."""
    return speak_row(read_math(latex, ""), language)


def speak_row(row: Row, language: Language) -> str:
    r"""A tree in words.

    >>> speak_row(read_math(r"\sqrt{3}", ""), Language("zh"))
    '根号 3'
    """
    return _tidy(say(open_catalogue(language), row))


def _tidy(words: str) -> str:
    """One line, with blanks where the script has them and one pause where several meet."""
    joined = " ".join(words.split()) if words.isascii() else _join_scripts(words.split())
    paused = _PAUSES.sub(r"\1", _BEFORE_PAUSE.sub("", joined))
    return paused.strip(_ENDS)


def _join_scripts(pieces: Iterable[str]) -> str:
    joined = ""
    for piece in pieces:
        joined += piece if _meet_closely(joined[-1:], piece[:1]) else f" {piece}"
    return joined


def _meet_closely(before: str, after: str) -> bool:
    """Whether no blank stands between: two Chinese characters, or Chinese punctuation."""
    wide = [each for each in (before, after) if each and east_asian_width(each) in "WF"]
    return len(wide) == 2 or any(each in _WIDE_PAUSES for each in wide)
