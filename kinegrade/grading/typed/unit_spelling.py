"""Units as people write them, and their values: m/s², m·s⁻², m s^-2, m/s/s, metres per second, rpm.

`conversion` reads the unit behind an answer with `read_unit`.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, lru_cache
from unicodedata import normalize

from kinegrade.grading.typed.keyboard import fold
from kinegrade.language.message import Message, Part
from kinegrade.language.spellings import is_written_apart, list_spellings, match_spellings
from kinegrade.numbers.units import ONE, SCALES, TYPED

_WORDS = {
    "m": Message("typing.unit-m"),
    "cm": Message("typing.unit-cm"),
    "mm": Message("typing.unit-mm"),
    "dm": Message("typing.unit-dm"),
    "km": Message("typing.unit-km"),
    "in": Message("typing.unit-in"),
    "ft": Message("typing.unit-ft"),
    "s": Message("typing.unit-s"),
    "min": Message("typing.unit-min"),
    "h": Message("typing.unit-h"),
    "rad": Message("typing.unit-rad"),
    "deg": Message("typing.unit-deg"),
    "turn": Message("typing.unit-turn"),
    "%": Message("typing.unit-percent"),
}
_SYMBOLS = {"°": "deg", "%": "%", "dm": "dm"}
_PER = Message("typing.per")
_SQUARED, _SQUARE = Message("typing.squared"), Message("typing.square")  # behind a unit, before it
SHORT_UNITS = {"rpm": "turn/min", "rps": "turn/s", "kph": "km/h", "kmh": "km/h", "r": "turn"}
_RUN_TOGETHER = re.compile(r"\b((?:k|c|m)?m|rad)s(?=\^?\(?-?[0-9])")  # as in ms^-2
# The ordinal sign and the ring, which are next to ° on many keyboards
_DEGREE_SIGNS = str.maketrans("º˚", "°°")
_FACTOR = re.compile(
    r"([^\W\d_]+|°|%)(?:(?:\s*(?:\^|\*\*)\s*)?(?:([+-]?[0-9])|\(([+-]?[0-9])\)|\{([+-]?[0-9])\}))?"
)
_LINK = re.compile(r"\s*(\*|/|\.|)\s*")
_SHARE = re.compile(r"1\s*(?=/)|(?=/)")
# By the exponents of length, time and angle
_KINDS = {
    (0, 0, 0): Message("typing.kind-number"),
    (1, 0, 0): Message("typing.kind-length"),
    (0, 1, 0): Message("typing.kind-time"),
    (1, -1, 0): Message("typing.kind-speed"),
    (1, -2, 0): Message("typing.kind-acceleration"),
    (0, 0, 1): Message("typing.kind-angle"),
    (0, -1, 1): Message("typing.kind-angular-velocity"),
    (0, -2, 1): Message("typing.kind-angular-acceleration"),
    (0, -1, 0): Message("typing.kind-rate"),
    (0, -2, 0): Message("typing.kind-rate-of-rate"),
}
_PER_MINUTE = Counter({"min": -1})
_TURNS_PER_TIME = (Fraction(2), Fraction(1, 30))  # times pi: r/s and r/min in rad/s


@dataclass(frozen=True, slots=True)
class WrittenUnit:
    """factor * pi**pi in SI units and radians; `length`, `time` and `angle` are exponents."""

    factor: Fraction
    pi: int
    length: int
    time: int
    angle: int

    @property
    def kind(self) -> Part:
        """What it measures: a noun, or powers of units where there is none."""
        dimension = (self.length, self.time, self.angle)
        return _KINDS.get(dimension, f"m^{self.length} s^{self.time} rad^{self.angle}")

    @property
    def counts_turns(self) -> bool:
        """Whether it is a number of turns in a second or a minute, as r/min is and deg/s is not."""
        rate = (self.pi, self.length, self.time, self.angle) == (1, 0, -1, 1)
        return rate and self.factor in _TURNS_PER_TIME


@lru_cache(maxsize=4096)
def read_unit(text: str) -> WrittenUnit | None:
    """The value of a unit, None where the text is not written as one.

    >>> read_unit("m·s⁻²") == read_unit("米/秒²") == read_unit("m/s^2")
    True
    """
    powers = _read_powers(_fold(text))
    if powers is None or ("r" in powers and not (powers["min"] == -1 or powers["s"] == -1)):
        return None
    for name in [name for name in powers if name in SHORT_UNITS]:
        power = powers.pop(name)
        for part, exponent in (_read_powers(SHORT_UNITS[name]) or {}).items():
            powers[part] += power * exponent
    return _find_worth(powers)


def is_per_minute(text: str) -> bool:
    """Whether a text is a count per minute, without what is counted."""
    return _read_powers(_fold(text)) == _PER_MINUTE


def _fold(text: str) -> str:
    plain = fold(normalize("NFKC", fold(text.translate(_DEGREE_SIGNS)))).strip()
    for pattern, sign in _compile_rewritings():
        plain = pattern.sub(sign, plain)
    return _RUN_TOGETHER.sub(r"\1 s", plain)


@cache
def _compile_rewritings() -> tuple[tuple[re.Pattern[str], str], ...]:
    """Words between units, and the signs that they stand for: metres per second squared."""
    between = "|".join(
        rf"\s+{word}\s+" if is_written_apart(word) else word for word in list_spellings(_PER)
    )
    return (
        (re.compile(rf"\s*{match_spellings(_SQUARED)}"), "^2"),
        (re.compile(between), "/"),
        (re.compile(rf"{match_spellings(_SQUARE)}\s*([^\W\d_]+)"), r"\1^2"),
    )


def _read_powers(text: str) -> Counter[str] | None:
    """The exponent of each factor, None where the text is not written as a unit; a slash inverts
    one factor or bracket.
    """
    powers: Counter[str] = Counter()
    share = _SHARE.match(text)
    place = share.end() if share else 0
    while place < len(text) or not place:
        link = _LINK.match(text, place) if place or text[:1] == "/" else None
        start = link.end() if link else place
        turn = -1 if link and link[1] == "/" else 1
        found, place = (
            _read_bracket(text, start)
            if text[start : start + 1] == "("
            else _read_factor(text, start)
        )
        if found is None:
            return None
        for name, power in found.items():
            powers[name] += turn * power
    return powers


def _read_factor(text: str, place: int) -> tuple[Counter[str] | None, int]:
    found = _FACTOR.match(text, place)
    name = _find_name(found[1]) if found else None
    if found is None or name is None:
        return None, place
    power = int(next((digits for digits in found.groups()[1:] if digits), "1"))
    return (Counter({name: power}) if power else None), found.end()


def _read_bracket(text: str, place: int) -> tuple[Counter[str] | None, int]:
    end = text.find(")", place)
    inside = text[place + 1 : end]
    return (_read_powers(inside) if end > 0 and "(" not in inside else None), end + 1


def _find_name(written: str) -> str | None:
    """The unit's standard name; case is ignored, because phones capitalise."""
    names = list_unit_names()
    return names.get(written) or names.get(written.casefold())


@cache
def list_unit_names() -> Mapping[str, str]:
    """The standard name of a unit by each of its symbols and spellings."""
    spelled = {
        spelling.casefold(): name
        for name, words in _WORDS.items()
        for spelling in list_spellings(words)
    }
    return {**spelled, **_SYMBOLS, **{name: name for name in (*SCALES, *SHORT_UNITS)}}


def _find_worth(powers: Counter[str]) -> WrittenUnit:
    scale = ONE
    exponents = Counter[str]()
    for name, power in powers.items():
        size, dimension = TYPED[name]
        scale = scale * size**power
        exponents[dimension] += power
    factor = Fraction(int(scale.rational.p), int(scale.rational.q))
    lengths, times, angles = (exponents[name] for name in ("length", "time", "angle"))
    return WrittenUnit(factor, scale.power, lengths, times, angles)
