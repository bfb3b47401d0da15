"""The fast twin of `"%.6g" % number`: the texts of thousands of numbers at once.

Six digits are two halves of three, and tables hold the text of each half in each layout. A text is
put together from them in two words of eight letters, the first letter lowest. A number whose last
digit double precision cannot be sure of is written one by one.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinegrade.grading.fast.bounds import HALF, Flags, Numbers, Places

Words = NDArray[np.uint64]

FORMAT = "%.6g"
_DIGITS, _HALF = 6, 3
_WORD = 64  # bits
_LETTER = 8
_LONGEST = 2 * _WORD // _LETTER
_TOGETHER = 4000  # numbers: what is worked out for so many stays in a processor's cache
_LOWEST, _HIGHEST = -20, 20  # powers of ten that the tables know
_POWERS = np.array([10.0**power for power in range(_LOWEST - _DIGITS, _HIGHEST + _DIGITS + 1)])
_THOUSAND = 10**_HALF
_POINTS = range(_HALF + 1)  # after so many digits of a half; 0 where it has none


class Scaled(NamedTuple):
    """The sizes of numbers in units of the last digit that is written: `size` over ten to the
    `power`, times the `unit`; where they are not `known`, they are too large or too small for it.
    """

    size: Numbers
    power: Places
    unit: Numbers
    known: Flags

    @property
    def last(self) -> Numbers:
        """The number of these units, six digits before its point."""
        return self.size * self.unit


def scale_numbers(numbers: Numbers) -> Scaled:
    """Numbers as they are rounded to be written."""
    with np.errstate(all="ignore"):
        size = np.abs(numbers)
        floor = np.floor(np.log10(size))
        known = (floor >= _LOWEST) & (floor < _HIGHEST)
        power = np.where(known, floor, 0).astype(np.intp)
    return Scaled(size, power, _POWERS[_DIGITS - 1 - power - (_LOWEST - _DIGITS)], known)


def write_numbers(numbers: Numbers) -> list[bytes]:
    """The texts of some numbers, in ASCII."""
    texts: list[bytes] = tabulate_numbers(numbers).tolist()
    return texts


def tabulate_numbers(numbers: Numbers) -> NDArray[np.bytes_]:
    """The same side by side, no wider than they are."""
    words = np.empty((len(numbers), 2), dtype="<u8")
    for begin in range(0, len(numbers), _TOGETHER):
        part = slice(begin, begin + _TOGETHER)
        words[part] = _write_words(numbers[part])
    return words.view(f"S{_LONGEST}").ravel().astype(f"S{_find_width(words)}")


def _write_words(numbers: Numbers) -> Words:
    """The texts as two words for each."""
    scaled = scale_numbers(numbers)
    with np.errstate(all="ignore"):
        last, power = scaled.last, scaled.power
        rounded = np.floor(last + 0.5)
        known = scaled.known & (np.abs(last - np.floor(last) - 0.5) > HALF)
        known &= (rounded >= 10 ** (_DIGITS - 1)) & (rounded <= 10**_DIGITS)
    carried = known & (rounded == 10**_DIGITS)  # 999999.7 is 1 with the next power
    digits = np.where(known & ~carried, rounded, 10 ** (_DIGITS - 1)).astype(np.intp)
    words = _assemble(digits, power + carried, numbers < 0)
    letters = words.view(np.uint8)
    for place in np.flatnonzero(~known).tolist():
        text = (FORMAT % numbers[place]).encode("ascii")
        letters[place] = np.frombuffer(text.ljust(_LONGEST, b"\0"), dtype=np.uint8)
    return words


def _find_width(words: Words) -> int:
    """The most letters that texts have, one of which is not empty."""
    first, second = (int(np.bitwise_or.reduce(each, initial=0)) for each in words.T)
    bits = _WORD + second.bit_length() if second else first.bit_length()
    return max(1, -(-bits // _LETTER))


def _assemble(digits: Places, power: Places, negative: Flags) -> Words:
    """Two words for each text: its beginning, its halves and its exponent, one behind the other."""
    tables, row = _make_tables(), power - _LOWEST
    high = digits // _THOUSAND
    low = digits - high * _THOUSAND
    layout = 2 * row + (low == 0)
    pieces = (
        (tables.beginnings, 2 * row + negative),
        (tables.halves, tables.high_layout[layout] + high),
        (tables.halves, tables.low_layout[layout] + low),
        (tables.ends, row),
    )
    (beginnings, first), *others = pieces
    low, offset = beginnings.letters[first], beginnings.bits[first]
    high = np.zeros_like(low)
    for texts, which in others:
        bits = texts.bits[which]
        if bits.any():
            letters = texts.letters[which]
            # A shift by more than a word, also one that wraps around below zero, leaves nothing
            low |= letters << offset
            high |= (letters >> (_WORD - offset)) | (letters << (offset - _WORD))
            offset += bits
    return np.stack((low, high), axis=1).astype("<u8", copy=False)


class _Texts(NamedTuple):
    """Texts of at most a word, and how many bits each takes."""

    letters: Words
    bits: Words

    @classmethod
    def of(cls, texts: list[str]) -> _Texts:
        """These texts."""
        letters = [int.from_bytes(text.encode("ascii"), "little") for text in texts]
        bits = [_LETTER * len(text) for text in texts]
        return cls(np.array(letters, dtype=np.uint64), np.array(bits, dtype=np.uint64))


class _Tables(NamedTuple):
    """The texts before the digits, by power and sign; those of halves; those behind, by power; and
    for each power, and whether the lower half is zero, where the texts of either half begin.
    """

    beginnings: _Texts
    halves: _Texts
    ends: _Texts
    high_layout: Places
    low_layout: Places


class _Half(NamedTuple):
    """How a half is laid out: after how many digits its point stands, and whether zeros at its end
    are dropped.
    """

    point: int
    drops: bool

    def write(self, digits: str) -> str:
        """Three digits in this layout."""
        if not self.drops:
            return f"{digits[: self.point]}.{digits[self.point :]}" if self.point else digits
        before, after = digits[: self.point], digits[self.point :].rstrip("0")
        return f"{before}.{after}" if before and after else before + after


_HALVES = [_Half(point, drops) for point in _POINTS for drops in (False, True)]


@cache
def _make_tables() -> _Tables:
    powers = range(_LOWEST, _HIGHEST + 1)
    layouts = [_find_halves(power, is_zero) for power in powers for is_zero in (False, True)]
    high, low = (
        np.array([_HALVES.index(each) * _THOUSAND for each in halves], dtype=np.intp)
        for halves in zip(*layouts, strict=True)
    )
    written = [half.write(f"{number:03}") for half in _HALVES for number in range(_THOUSAND)]
    beginnings, ends = zip(*map(_find_surroundings, powers), strict=True)
    signed = [sign + each for each in beginnings for sign in ("", "-")]
    return _Tables(_Texts.of(signed), _Texts.of(written), _Texts.of([*ends]), high, low)


def _find_surroundings(power: int) -> tuple[str, str]:
    """What stands before the digits of a number of that power, and its exponent behind them."""
    text = FORMAT % float(f"1e{power}")
    return text[: text.index("1")], text[text.index("e") :] if "e" in text else ""


def _find_halves(power: int, is_zero: bool) -> tuple[_Half, _Half]:
    """The layouts of both halves where the lower one is zero, or is not."""
    before, _, after = (FORMAT % float(f"1.11111e{power}")).partition("1")
    point = 0 if before else len(after.partition(".")[0]) + 1
    if point <= _HALF:
        return _Half(point, drops=is_zero), _Half(0, drops=True)
    return _Half(0, drops=False), _Half(point - _HALF, drops=True)
