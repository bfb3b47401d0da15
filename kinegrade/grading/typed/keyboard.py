"""What English and Chinese keyboards produce, in one alphabet: digits, signs, brackets, blanks."""

from __future__ import annotations

import re

from kinegrade.files.cell_text import INVISIBLE

BLANKS = "".join(chr(code) for code in range(0x3001) if chr(code).isspace()) + INVISIBLE
RAISED_NUMBERS = "⁰¹²³⁴⁵⁶⁷⁸⁹"
RAISED_DOTS = "·⋅•∙・"
_RAISED = re.compile(rf"[⁺⁻]?[{RAISED_NUMBERS}]+(?=([0-9])?)")
_PLAIN = str.maketrans(f"{RAISED_NUMBERS}⁺⁻", "0123456789+-")
_SIGNS = {
    # Full-width letters, digits and signs
    **{code: chr(code - 0xFEE0) for code in range(0xFF01, 0xFF5F)},
    **{ord(sign): "." for sign in "。｡．"},  # what a Chinese keyboard gives for a full stop
    **{
        ord(sign): "-"
        for sign in "\u2212\u2010\u2011\u2012\u2013\u2014\u2015\u2043\u02d7\ufe58\ufe63"
    },
    # A tab or the end of a line stays what it is, as in ASCII: it groups no digits
    **{ord(sign): " " for sign in BLANKS if not sign.isascii()},
    **{ord(sign): None for sign in INVISIBLE},
    **{ord(sign): "*" for sign in f"×{RAISED_DOTS}✕✖"},
    **{ord(sign): "/" for sign in "÷\u2044\u2215"},
    **{ord(sign): "'" for sign in "\u2019\u2018\u02bc"},
    **{ord(sign): bracket for sign, bracket in zip("【】〔〕", "[]()", strict=True)},
}
# Separators made for grouping
_SINGLE_GROUP_BLANKS = str.maketrans(dict.fromkeys("\u00a0\u2007\u2009\u202f", "\u2009"))


def fold(text: str) -> str:
    """The text in one alphabet: ASCII digits, signs and brackets; a superscript becomes ^2, a blank
    " ".

    Narrow and no-break blanks, which people type only to group digits, become U+2009.

    >>> fold("−８．６６×１０⁻¹")
    '-8.66*10^-1'
    """
    if text.isascii():
        return text
    marked = text.translate(_SINGLE_GROUP_BLANKS)
    kept = "\u2009".join(part.translate(_SIGNS) for part in marked.split("\u2009"))
    return _RAISED.sub(
        lambda raised: f"^{raised[0].translate(_PLAIN)}{' ' if raised[1] else ''}", kept
    )


def show(text: str) -> str:
    """On one line, with everything invisible written out."""
    return "".join(
        each if each.isprintable() else each.encode("unicode_escape").decode() for each in text
    )
