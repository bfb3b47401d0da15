r"""Symbols of figures in Braille: a letter, a number, or a letter with an index, as the mathematics
of a language writes them. What is longer gets a number instead, which a key explains.

English: Guidelines for Technical Material of Unified English Braille (ICEB 2014), in grade 1;
German: System der Mathematikschrift (BSKDL 2015), with its index sign. Chinese papers have the
English signs, whose letters are those of annex G of GB/T 15720-2008.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import count
from typing import assert_never

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.math.reading import read_math
from kinegrade.language.math.tree import (
    Accent,
    Environment,
    Fenced,
    Function,
    Group,
    Letter,
    Lettering,
    LineBreak,
    Mark,
    Node,
    Number,
    Quotient,
    Root,
    Row,
    Scripts,
    Sign,
    Space,
    Text,
    Unit,
)

_LATIN = "abcdefghijklmnopqrstuvwxyz"
_CELLS = "⠁⠃⠉⠙⠑⠋⠛⠓⠊⠚⠅⠇⠍⠝⠕⠏⠟⠗⠎⠞⠥⠧⠺⠭⠽⠵"
_NUMBER_SIGN, _HYPHEN = "⠼", "⠤"
_DIGITS = dict(zip("1234567890", _CELLS, strict=False))
_GREEK = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "zeta",
    "eta",
    "theta",
    "iota",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "omicron",
    "pi",
    "rho",
    "sigma",
    "tau",
    "upsilon",
    "phi",
    "chi",
    "psi",
    "omega",
]
_LONGEST = 7  # cells


def write_braille_number(*numbers: int) -> str:
    """Numbers with a hyphen between them.

    >>> write_braille_number(2, 10)
    '⠼⠃⠤⠼⠁⠚'
    """
    return _HYPHEN.join(
        _NUMBER_SIGN + "".join(_DIGITS[digit] for digit in str(number)) for number in numbers
    )


def label_in_braille(symbols: Iterable[str], language: Language) -> Mapping[str, str]:
    r"""The cells of each symbol, given as LaTeX math; of what Braille writes too long, a number
    that no symbol is.

    Raises TypesetError for a symbol that is no math.

    >>> label_in_braille(["A", r"\omega_{0}", r"\frac{R}{2}"], "en")
    {'A': '⠠⠁', '\\omega_{0}': '⠨⠺⠢⠼⠚', '\\frac{R}{2}': '⠼⠁'}
    """
    written = {symbol: _write_symbol(symbol, language) for symbol in symbols}
    taken = set(written.values())
    free = (cells for number in count(1) if (cells := write_braille_number(number)) not in taken)
    return {symbol: cells or next(free) for symbol, cells in written.items()}


def _write_symbol(symbol: str, language: Language) -> str:
    """The cells of a symbol; "" where it takes too many, or other signs."""
    cells = [_write_node(node, language) for node in read_math(symbol, "figure.labels")]
    whole = "".join(cells)
    return whole if all(cells) and len(whole) <= _LONGEST else ""


def _write_node(node: Node, language: Language) -> str:
    """The cells of a letter, a number or a letter with an index; "" for anything else."""
    match node:
        case Letter(name):
            return _write_letter(name, language)
        case Number(digits):
            return write_braille_number(int(digits)) if digits.isdigit() else ""
        case Scripts(base, lower, 0, None) if base and lower:
            letter, index = _write_node(base, language), _write_row(lower, language)
            sign = open_catalogue(language).text("braille.index")
            return letter + sign + index if letter and index else ""
        case Group(row) | Lettering(_, row):
            return _write_row(row, language)
        case Scripts() | Sign() | Function() | Text() | Unit() | Space() | Quotient() | Root():
            return ""
        case Accent() | Fenced() | Environment() | LineBreak() | Mark():
            return ""
        case _:
            assert_never(node)


def _write_row(row: Row, language: Language) -> str:
    cells = [_write_node(node, language) for node in row]
    return "".join(cells) if all(cells) else ""


def _write_letter(name: str, language: Language) -> str:
    words = open_catalogue(language)
    plain = name.removeprefix("var")
    if plain in _GREEK:
        letters = words.text("braille.greek-letters")
        return words.text("braille.greek") + letters[_GREEK.index(plain)]
    if name.lower() not in _LATIN:
        return ""
    cell = _CELLS[_LATIN.index(name.lower())]
    return words.text("braille.capital") + cell if name.isupper() else cell
