"""Points as a hand writes them: 1.5, 1,5, or as a fraction, 1/2, 1 1/2 and 1½."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from unicodedata import normalize

from kinegrade.files.cell_text import shorten
from kinegrade.language.message import Message, Quoted, Text
from kinegrade.numbers.amounts import PLACES, write_amount

_DECIMAL = re.compile(rf"\+?([0-9]{{1,9}}(?:[.,][0-9]{{1,{PLACES}}})?)")
_FRACTION = re.compile(r"\+?(?:([0-9]{1,9}) +)?([0-9]{1,4}) ?[/⁄] ?([1-9][0-9]{0,3})")
_SIGN_OF_FRACTION = re.compile(r"(?<=[0-9])(?=[¼-¾⅐-⅞])")


@dataclass(frozen=True, slots=True)
class TypedPoints:
    """The points, and of a fraction alone the numbers above and below its bar."""

    points: Fraction
    part: tuple[Fraction, Fraction] | None = None


def read_typed_points(cell: str) -> TypedPoints | None:
    """The points in a cell, None where it holds none.

    >>> [str(read_typed_points(cell).points) for cell in ("1,5", "1/2", "1½")]
    ['3/2', '1/2', '3/2']
    """
    written = normalize("NFKC", _SIGN_OF_FRACTION.sub(" ", cell))
    number = _DECIMAL.fullmatch(written)
    if number is not None:
        return TypedPoints(Fraction(number[1].replace(",", ".")))
    fraction = _FRACTION.fullmatch(written)
    if fraction is None:
        return None
    whole, above, below = (Fraction(one or 0) for one in fraction.groups())
    part = (above, below) if fraction[1] is None else None
    return TypedPoints(whole + above / below, part)


def explain_points(cell: str, maximum: Fraction | None) -> tuple[Message, Text, Text] | None:
    """What is wrong with the points in a cell, what is expected, and what to do; None where they
    are sound. 3/4 of the points to be had may be three of four, or three quarters of one.
    """
    typed = read_typed_points(cell)
    if typed is None:
        return _expect_decimals(cell)
    above, below = typed.part or (typed.points, None)
    if below is not None and below == maximum and above != typed.points:
        points, part, out_of = map(write_amount, (typed.points, above, below))
        found = Quoted(shorten(cell))
        what = Message("marking.points-or-part", cell=found, points=points, part=part, of=out_of)
        return what, "", Message("marking.write-one-number")
    exact = (typed.points * 10**PLACES).denominator == 1
    return None if exact else _expect_decimals(cell)


def _expect_decimals(cell: str) -> tuple[Message, Text, Text]:
    what = Message("marking.points-are", cell=Quoted(shorten(cell)))
    return what, Message("marking.hand-points", places=PLACES), ""
