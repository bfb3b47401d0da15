"""Units as people write them, and their values: m/s², m·s⁻², m s^-2, m/s/s, metres per second, rpm.

`find_conversion` is called by `answers` for the text after a number. It compares dimensions before
any numbers are compared, and converts exactly: a factor and a power of pi, because a turn is 2 pi
radians.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, lru_cache
from unicodedata import normalize

from kinegrade.grading.typed.number_text import TypingFault, Unreadable, fold, show
from kinegrade.language.message import Message, Part, Quoted
from kinegrade.language.spellings import is_written_apart, list_spellings, match_spellings
from kinegrade.numbers.units import FACTORS, HALF_TURNS

_WORDS = {
    "m": Message("typing.unit-m"),
    "cm": Message("typing.unit-cm"),
    "mm": Message("typing.unit-mm"),
    "dm": Message("typing.unit-dm"),
    "km": Message("typing.unit-km"),
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
_CYCLES = Message("typing.turns-per-second")
_SHORT = {"rpm": "turn/min", "rps": "turn/s", "kph": "km/h", "kmh": "km/h", "r": "turn"}
_PER_MINUTE = Counter({"min": -1})
_RUN_TOGETHER = re.compile(r"\b((?:k|c|m)?m|rad)s(?=\^?\(?-?[0-9])")  # as in ms^-2
# The ordinal sign and the ring, which are next to ° on many keyboards
_DEGREE_SIGNS = str.maketrans("º˚", "°°")
_TIMES = re.compile(r"^\*\s*(?=[^\W\d]|°)")
_FACTOR = re.compile(
    r"([^\W\d_]+|°|%)(?:(?:\s*(?:\^|\*\*)\s*)?(?:([+-]?[0-9])|\(([+-]?[0-9])\)|\{([+-]?[0-9])\}))?"
)
_LINK = re.compile(r"\s*(\*|/|\.|)\s*")
_SHARE = re.compile(r"1\s*(?=/)|(?=/)")
_PURE = ("", "1")  # as a unit: none
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


class WrongUnit(TypingFault):
    """A well-written unit that measures something other than what is asked."""


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


@dataclass(frozen=True, slots=True)
class Conversion:
    """A typed number times factor * pi**pi is the number in the ask's unit."""

    factor: Fraction = Fraction(1)
    pi: int = 0


_SAME = Conversion()


@lru_cache(maxsize=4096)
def find_conversion(typed: str, unit: str) -> Conversion:
    """How a number typed with the unit `typed` becomes one in `unit`; no unit means the ask's.

    Radians may be left out (1/s for rad/s), never added. Raises WrongUnit for another dimension, Hz
    included, and Unreadable for an unknown unit.

    >>> find_conversion("r/min", "rad/s"), find_conversion("cm/s²", "m/s^2").factor
    (Conversion(factor=Fraction(1, 30), pi=1), Fraction(1, 100))
    """
    written = _drop_brackets(typed)
    if written in ("", unit) or (unit in _PURE and written == "1"):
        return _SAME
    wanted = read_unit(unit) if unit not in _PURE else WrittenUnit(Fraction(1), 0, 0, 0, 0)
    _refuse_turns_per_time(written, unit, wanted)
    found = read_unit(written)
    if found is None or wanted is None:
        raise Unreadable(_describe_unknown(Quoted(show(typed.strip())), unit))
    lengths_and_times = (found.length, found.time) == (wanted.length, wanted.time)
    radians_left_out = found.angle == 0 and wanted.angle == 1 and wanted.time < 0 and wanted.pi == 0
    if not lengths_and_times or not (found.angle == wanted.angle or radians_left_out):
        raise WrongUnit(_describe_other_kind(Quoted(show(written)), found.kind, wanted.kind, unit))
    return Conversion(found.factor / wanted.factor, found.pi - wanted.pi)


def _describe_unknown(typed: Quoted, unit: str) -> Message:
    if unit in _PURE:
        return Message("typing.no-unit-wanted", typed=typed)
    return Message("typing.unknown-unit", typed=typed, unit=Quoted(unit))


def _describe_other_kind(typed: Quoted, found: Part, wanted: Part, unit: str) -> Message:
    if unit in _PURE:
        return Message("typing.not-pure", typed=typed, found=found, wanted=wanted)
    return Message("typing.other-kind", typed=typed, found=found, wanted=wanted, unit=Quoted(unit))


def _refuse_turns_per_time(written: str, unit: str, wanted: WrittenUnit | None) -> None:
    typed = Quoted(show(written))
    if _compile_turn_counts().fullmatch(written):
        raise WrongUnit(_describe_turns(typed, unit, wanted))
    if wanted is not None and wanted.angle and _read_powers(_fold(written)) == _PER_MINUTE:
        raise Unreadable(Message("typing.per-minute", typed=typed))


@cache
def _compile_turn_counts() -> re.Pattern[str]:
    return re.compile(rf"[kM]?Hz|{match_spellings(_CYCLES)}", re.IGNORECASE)


def _describe_turns(typed: Quoted, unit: str, wanted: WrittenUnit | None) -> Message:
    if wanted is None:
        return Message("typing.turns-for-unit", typed=typed, unit=Quoted(unit))
    if unit in _PURE:
        return Message("typing.turns-for-number", typed=typed, wanted=wanted.kind)
    return Message("typing.turns-for-kind", typed=typed, wanted=wanted.kind, unit=Quoted(unit))


def _drop_brackets(typed: str) -> str:
    written = _TIMES.sub("", typed.strip())
    if written[:1] + written[-1:] in ("()", "[]", "\uff08\uff09", "【】", "{}"):
        return written[1:-1].strip()
    return written


@lru_cache(maxsize=4096)
def read_unit(text: str) -> WrittenUnit | None:
    """The value of a unit, None where the text is not written as one.

    >>> read_unit("m·s⁻²") == read_unit("米/秒²") == read_unit("m/s^2")
    True
    """
    powers = _read_powers(_fold(text))
    if powers is None or ("r" in powers and not (powers["min"] == -1 or powers["s"] == -1)):
        return None
    for name in [name for name in powers if name in _SHORT]:
        power = powers.pop(name)
        for part, exponent in (_read_powers(_SHORT[name]) or {}).items():
            powers[part] += power * exponent
    return _find_worth(powers)


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
    names = _list_names()
    return names.get(written) or names.get(written.casefold())


@cache
def _list_names() -> Mapping[str, str]:
    """The standard name of a unit by each of its symbols and spellings."""
    spelled = {
        spelling.casefold(): name
        for name, words in _WORDS.items()
        for spelling in list_spellings(words)
    }
    return {**spelled, **_SYMBOLS, **{name: name for name in (*FACTORS, *_SHORT)}}


def _find_worth(powers: Counter[str]) -> WrittenUnit:
    factor, pi = Fraction(1), 0
    exponents = Counter[str]()
    for name, power in powers.items():
        size, dimension = _find_size(name)
        factor *= size**power
        pi += power * (name in HALF_TURNS)
        exponents[dimension] += power
    return WrittenUnit(factor, pi, exponents["length"], exponents["time"], exponents["angle"])


def _find_size(name: str) -> tuple[Fraction, str]:
    if name == "%":
        return Fraction(1, 100), "number"
    if name == "dm":
        return Fraction(1, 10), "length"
    size, dimension = (HALF_TURNS[name], "angle") if name in HALF_TURNS else FACTORS[name]
    return Fraction(int(size.p), int(size.q)), dimension
