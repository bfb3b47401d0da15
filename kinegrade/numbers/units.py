"""Units as textbooks write them: factors to SI, and how they print.

Internally, everything is in SI with angles in radians; degrees, revolutions and millimetres are
used only for input and output. A unit is a product of powers, `m/s^2`, `rad/s`, `r/min`, `1`; hertz
is not radians per second and is not known here.
"""

from __future__ import annotations

import re
from typing import Any

from flint import fmpq
from msgspec import Struct
from msgspec.structs import replace

from kinegrade.errors import ExpressionError, find_nearest
from kinegrade.language.message import Fault, Message, Quoted, list_choices, list_plainly


class Scale(Struct, frozen=True):
    """What a unit is in SI: rational * pi**power, exactly."""

    rational: Any
    power: int = 0

    def __mul__(self, other: Scale) -> Scale:
        return Scale(self.rational * other.rational, self.power + other.power)

    def __truediv__(self, other: Scale) -> Scale:
        return Scale(self.rational / other.rational, self.power - other.power)

    def __pow__(self, exponent: int) -> Scale:
        return Scale(self.rational**exponent, self.power * exponent)


ONE = Scale(fmpq(1))
SCALES: dict[str, tuple[Scale, str]] = {
    "m": (ONE, "length"),
    "cm": (Scale(fmpq(1, 100)), "length"),
    "mm": (Scale(fmpq(1, 1000)), "length"),
    "km": (Scale(fmpq(1000)), "length"),
    "in": (Scale(fmpq(127, 5000)), "length"),
    "ft": (Scale(fmpq(381, 1250)), "length"),
    "s": (ONE, "time"),
    "min": (Scale(fmpq(60)), "time"),
    "h": (Scale(fmpq(3600)), "time"),
    "rad": (ONE, "angle"),
    "deg": (Scale(fmpq(1, 180), 1), "angle"),
    "r": (Scale(fmpq(2), 1), "angle"),
    "1": (ONE, "number"),
}
TYPED: dict[str, tuple[Scale, str]] = {
    **SCALES,
    "turn": SCALES["r"],
    "dm": (Scale(fmpq(1, 10)), "length"),
    "%": (Scale(fmpq(1, 100)), "number"),
}  # with those that are read behind answers alone
SHORT = {"rpm": "r/min"}  # units with a name of their own
_TURNING = ("deg", "r")  # angles that stand for themselves or in rates
# As people write some, who are told how they are written here
_WRITTEN_OTHERWISE = {
    "U/min": "r/min",
    "°": "deg",
    "degree": "deg",
    "degrees": "deg",
    "feet": "ft",
    "foot": "ft",
    "hour": "h",
    "inch": "in",
    "inches": "in",
    "kmh": "km/h",
    "kph": "km/h",
    "meter": "m",
    "metre": "m",
    "radian": "rad",
    "radians": "rad",
    "rev": "r",
    "rps": "r/s",
    "sec": "s",
    "turn": "r",
}
_PART = re.compile(r"(?P<mark>[*/]?)(?P<name>[a-z]+|1)(?:\^(?P<power>-?[1-4]))?", re.ASCII)


class Unit(Struct, frozen=True):
    """A unit: its text, its scale to SI, and its dimension. An angle in degrees, though, enters and
    leaves as an `Angle`: see `degrees`.

    `length` and `time` are exponents; `angle` distinguishes radians from plain numbers.
    """

    text: str
    scale: Scale
    length: int
    time: int
    angle: int

    @property
    def degrees(self) -> bool:
        """Whether this is the degree, which enters and leaves as an angle and not by a factor."""
        return self.text == "deg"

    @property
    def counts_turns(self) -> bool:
        """Whether this is a number of turns in a time, as r/min is."""
        return self.text in SHORT or self.text.startswith("r/")

    @property
    def is_si(self) -> bool:
        """Whether its numbers are those of SI; degrees count, as angles have no other numbers."""
        return self.scale == ONE or self.degrees

    @property
    def is_length(self) -> bool:
        """Whether this is the unit of a length."""
        return self.length == 1 and self.time == 0

    @property
    def lengths(self) -> frozenset[str]:
        """The units of length in its text: mm in mm/s^2."""
        names = (part["name"] for part in _PART.finditer(self.text))
        known = (name for name in names if name in SCALES)  # rpm is none of them
        return frozenset(name for name in known if SCALES[name][1] == "length")

    def count_lengths(self, old: str, new: str) -> Unit:
        """The same with one unit of length in place of another.

        >>> read_unit("mm/s^2").count_lengths("mm", "in").text
        'in/s^2'
        """
        if old == new or old not in self.lengths:
            return self
        return read_unit(re.sub(rf"\b{old}\b", new, self.text))

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
    expected = Message("expression.unit-like", units=list_plainly(sorted((*SCALES, *SHORT))))
    otherwise = _WRITTEN_OTHERWISE.get(text) or _WRITTEN_OTHERWISE.get(name)
    plain = text.replace("²", "^2").replace("³", "^3").replace("·", "*")
    if plain != text and is_unit(plain):
        otherwise = plain
    near = [otherwise] if otherwise else find_nearest(name, (*SCALES, *SHORT))
    names = list_choices(map(Quoted, near))
    do = Message("grammar.did-you-mean", names=names) if near else ""
    return ExpressionError(Fault("", what, expected, do))


def read_unit(text: str) -> Unit:
    """The unit written as `text`. Raises ExpressionError for an unknown unit.

    >>> read_unit("mm/s^2").scale, read_unit("r/min").scale
    (Scale(rational=1/1000, power=0), Scale(rational=1/30, power=1))
    """
    if text in SHORT:
        return replace(read_unit(SHORT[text]), text=text)
    scale, place, turning = ONE, 0, False
    exponents = {"length": 0, "time": 0, "angle": 0, "number": 0}
    while place < len(text) or not place:
        match = _PART.match(text, place)
        if match is None or match["name"] not in SCALES or (place > 0) != bool(match["mark"]):
            raise _explain_unknown(text, match["name"] if match else text[place:])
        size, dimension = SCALES[match["name"]]
        power = int(match["power"] or 1) * (-1 if match["mark"] == "/" else 1)
        scale, place = scale * size**power, match.end()
        exponents[dimension] += power
        turning = turning or match["name"] in _TURNING
    unit = Unit(text, scale, exponents["length"], exponents["time"], exponents["angle"])
    if turning and not (unit.degrees or _is_rate(unit)):
        raise ExpressionError(Message("expression.degrees-alone", unit=Quoted(text)))
    return unit


def is_unit(word: str) -> bool:
    """Whether a word is a unit, as it is written here or as people write some.

    >>> is_unit("rad/s"), is_unit("m/s²"), is_unit("degrees"), is_unit("with")
    (True, True, True, False)
    """
    try:
        read_unit(word.replace("²", "^2"))
    except ExpressionError:
        return word in _WRITTEN_OTHERWISE
    return True


def _is_rate(unit: Unit) -> bool:
    """Whether a unit is one of angular velocities or accelerations."""
    return (unit.length, unit.angle) == (0, 1) and unit.time in (-1, -2)
