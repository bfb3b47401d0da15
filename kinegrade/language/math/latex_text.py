r"""Plain text into LaTeX: whatever a name or a course's title holds is printed and never executed.

Control words, ligatures and active characters lose their effect here.
"""

from __future__ import annotations

import re
from functools import lru_cache
from unicodedata import category, normalize

from kinegrade.language.math import units
from kinegrade.language.math.units import raise_exponents

_WRITTEN = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "#": r"\#",
    "%": r"\%",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    '"': r"\textquotedbl{}",
    "'": r"\textquotesingle{}",
    "`": r"\textasciigrave{}",
    "[": "{[}",  # not the beginning of an option
    "]": "{]}",
    "\u00a0": "~",
    "\u2009": r"\,",
    "\u202f": r"\,",
    "\u2212": "$-$",
}
# Two hyphens would print a dash, two commas a quotation mark
_LIGATURE = re.compile("([-,])(?=[-,])")
# xeCJK, which sets these with the Chinese fonts, drops a plain space between two of them
_GREEK_OR_CYRILLIC = "[\u0370-\u052f]"
_LOST_SPACE = re.compile(f"(?<={_GREEK_OR_CYRILLIC}) (?={_GREEK_OR_CYRILLIC})")
_CONTROLS = frozenset({"Cc", "Cs", "Zl", "Zp"})
_INVISIBLE = "Cf"  # joiners, marks of direction: no font of these has them
_LATIN = re.compile("[ -~\n¡-§©-¬®-·»-ĥĨ-ķĹ-ľŁ-ňŊ-ťŨ-žȘșȚț–—‘’‚“”„…‰‹›€™•]*")

_BEYOND_LATIN = re.compile("[ẠạẢảẤ-ỹƠơƯưΑ-ΡΣ-Ωα-ωА-яЁё\u3000-\u3002\u4e00-\u9fa5]")


def write_plain(text: str) -> str:
    r"""`text` as LaTeX that prints it; control characters become spaces, invisible ones vanish.

    >>> print(write_plain(r"\input{x} & 100 %"))
    \textbackslash{}input\{x\} \& 100 \%
    """
    composed = _LIGATURE.sub("\\1\u200b", normalize("NFC", text))
    return r"\ ".join(
        "".join(_write_written(character) for character in words)
        for words in _LOST_SPACE.split(composed)
    )


def write_raised(text: str) -> str:
    r"""`text` with its exponents raised, as units have them.

    >>> print(write_raised("rad/s^2"))
    rad/s\textsuperscript{2}
    """
    return raise_exponents(
        text, write_plain, lambda power: rf"\textsuperscript{{{_write_negative(power)}}}"
    )


def write_unit(unit: str) -> str:
    r"""A unit as it is printed: exponents raised, a degree sign, a thin dash for a pure number.

    >>> print(write_unit("rad/s^2"), write_unit("deg"), write_unit("1"))
    rad/s\textsuperscript{2} ° –
    """
    return units.write_unit(unit, write_symbols=write_raised)


def write_signed(number: str) -> str:
    r"""A number as it is printed, with a minus sign instead of a hyphen.

    >>> print(write_signed("[-0.9, 1]"))
    {[}$-$0.9, 1{]}
    """
    return write_plain(number.replace("-", "\u2212"))


def is_surely_printed(character: str) -> bool:
    """Whether a font is known to have it: most Latin, plain Greek and Cyrillic,
    common Chinese.

    >>> is_surely_printed("é"), is_surely_printed("堃"), is_surely_printed("한")
    (True, True, False)
    """
    unseen = category(character) in (*_CONTROLS, _INVISIBLE)
    known = _LATIN.fullmatch(character) or _BEYOND_LATIN.fullmatch(character)
    return unseen or known is not None


def write_comment(text: str) -> str:
    """`text` as one comment line of LaTeX.

    >>> write_comment("paper A-1, q1")
    '%% paper A-1, q1'
    """
    return "%% " + "".join(letter if letter.isprintable() else "·" for letter in text)


@lru_cache(maxsize=4096)
def _write_written(character: str) -> str:
    kind = category(character)
    if kind == _INVISIBLE:
        return "{}" if character == "\u200b" else ""
    return _WRITTEN.get(character, " " if kind in _CONTROLS else character)


def _write_negative(exponent: str) -> str:
    return exponent.replace("-", "$-$").replace("\u2212", "$-$")
