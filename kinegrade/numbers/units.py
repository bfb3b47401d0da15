"""Units as textbooks write them: factors to SI, and how they print.

Internally, everything is in SI with angles in radians; degrees and millimetres are used only for
input and output. A unit is a product of powers, `m/s^2`, `rad/s`, `1`; hertz is not radians per
second and is not known here.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

from flint import fmpq

from kinegrade.errors import ExpressionError, find_nearest
from kinegrade.language.message import Fault, Message, Quoted, list_choices, list_plainly

FACTORS: dict[str, tuple[Any, str]] = {
    "m": (fmpq(1), "length"),
    "cm": (fmpq(1, 100), "length"),
    "mm": (fmpq(1, 1000), "length"),
    "km": (fmpq(1000), "length"),
    "in": (fmpq(127, 5000), "length"),
    "ft": (fmpq(381, 1250), "length"),
    "s": (fmpq(1), "time"),
    "min": (fmpq(60), "time"),
    "h": (fmpq(3600), "time"),
    "rad": (fmpq(1), "angle"),
    "deg": (fmpq(1), "angle"),
    "1": (fmpq(1), "number"),
}
HALF_TURNS: dict[str, Any] = {
    "deg": fmpq(1, 180),
    "turn": fmpq(2),
}  # angles as exact parts of pi radians
_PART = re.compile(r"(?P<mark>[*/]?)(?P<name>[a-z]+|1)(?:\^(?P<power>-?[1-4]))?", re.ASCII)


@dataclass(frozen=True)
class Unit:
    """A unit: its text, its factor to SI (degrees excepted: see `degrees`), and its dimension.

    `length` and `time` are exponents; `angle` distinguishes radians from plain numbers.
    """

    text: str
    factor: Any
    length: int
    time: int
    angle: int

    @property
    def degrees(self) -> bool:
        """Whether this is the degree, which enters and leaves as an angle and not by a factor."""
        return self.text == "deg"

    @property
    def is_length(self) -> bool:
        """Whether this is the unit of a length."""
        return self.length == 1 and self.time == 0

    @property
    def latex(self) -> str:
        """The unit in upright LaTeX math, with `^\\circ` for degrees and nothing for pure
        numbers.
        """
        if self.degrees:
            return r"^\circ"
        body = re.sub(r"([a-z]+)", r"\\mathrm{\1}", re.sub(r"\^(-\d)", r"^{\1}", self.text))
        return "" if self.text == "1" else body

    @property
    def printed(self) -> str:
        """The unit in plain text for people: superscripts and the degree sign."""
        return self.text.replace("^2", "²").replace("deg", "°")


def _explain_unknown(text: str, name: str) -> ExpressionError:
    """The error for a unit that has a part that is none."""
    what = Message("expression.unit", unit=Quoted(text))
    expected = Message("expression.unit-like", units=list_plainly(sorted(FACTORS)))
    near = find_nearest(name, FACTORS)
    names = list_choices(map(Quoted, near))
    do = Message("grammar.did-you-mean", names=names) if near else ""
    return ExpressionError(Fault("", what, expected, do))


def read_unit(text: str) -> Unit:
    """The unit written as `text`. Raises ExpressionError for an unknown unit.

    >>> read_unit("mm/s^2").factor, read_unit("rad/s").angle
    (1/1000, 1)
    """
    factor, exponents, place = fmpq(1), {"length": 0, "time": 0, "angle": 0, "number": 0}, 0
    while place < len(text) or not place:
        match = _PART.match(text, place)
        if match is None or match["name"] not in FACTORS or (place > 0) != bool(match["mark"]):
            raise _explain_unknown(text, match["name"] if match else text[place:])
        size, dimension = FACTORS[match["name"]]
        power = int(match["power"] or 1) * (-1 if match["mark"] == "/" else 1)
        factor, place = factor * size**power, match.end()
        exponents[dimension] += power
    if "deg" in text and text != "deg":
        raise ExpressionError(Message("expression.degrees-alone", unit=Quoted(text)))
    return Unit(text, factor, exponents["length"], exponents["time"], exponents["angle"])
