"""The scales that universities use, and `make_scale`, which makes a scale of a stated one."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import assert_never

from kinegrade.grade_scale.scale import Scale, Step, begin_at_zero
from kinegrade.grade_scale.stated import Kind, StatedScale
from kinegrade.language.catalogue import Catalogue
from kinegrade.language.message import Message

_GERMAN = ("4.0", "3.7", "3.3", "3.0", "2.7", "2.3", "2.0", "1.7", "1.3", "1.0")  # those that pass
_GERMAN_FAIL = "5.0"
_LETTERS = {"A": 90, "B": 80, "C": 70, "D": 60, "F": 0}
_LEVELS = {
    Message("scale.excellent"): 90,
    Message("scale.good"): 80,
    Message("scale.fair"): 70,
    Message("scale.pass"): 60,
    Message("scale.fail"): 0,
}
_HALF, _THREE_FIFTHS = Fraction(1, 2), Fraction(3, 5)
_FULL = 100


def make_scale(stated: StatedScale, words: Catalogue) -> Scale:
    """The scale, with the names and the decimal mark of a language.

    A curve moves the bounds: a grade is given from the share on that counts as its bound.
    """
    steps = _list_steps(stated, words)
    reach = _invert_curve(stated)
    moved = [Step(step.grade, reach(step.least), step.passes) for step in steps]
    return Scale(begin_at_zero(moved), stated.absent)


def _list_steps(stated: StatedScale, words: Catalogue) -> Sequence[Step]:
    """The grades with the bounds that hold without a curve, the best first."""
    passing = stated.passing
    if stated.kind is None:
        return _step_down(stated.grades, Fraction(0) if passing is None else passing)
    return _list_usual(stated.kind, passing, words)


def _list_usual(kind: Kind, passing: Fraction | None, words: Catalogue) -> Sequence[Step]:
    """The grades of a kind; `passing` is the pass mark, None for the usual one."""
    match kind:
        case "german":
            return _list_german(_HALF if passing is None else passing, words)
        case "letters":
            return _step_down(_share_out(_LETTERS), passing or _THREE_FIFTHS)
        case "five-level":
            named = {words.write(level): least for level, least in _LEVELS.items()}
            return _step_down(_share_out(named), passing or _THREE_FIFTHS)
        case "hundred":
            return _list_hundred(passing or _THREE_FIFTHS)
        case _:
            assert_never(kind)


def _list_german(passing: Fraction, words: Catalogue) -> Sequence[Step]:
    """1.0 to 4.0 in equal steps between the pass mark and all points, and 5.0 below."""
    width = (1 - passing) / len(_GERMAN)
    steps = [
        Step(grade.replace(".", words.decimal_mark), passing + place * width, passes=True)
        for place, grade in enumerate(_GERMAN)
    ]
    fail = _GERMAN_FAIL.replace(".", words.decimal_mark)
    return (*reversed(steps), Step(fail, Fraction(0), passes=False))


def _list_hundred(passing: Fraction) -> Sequence[Step]:
    """The percentage as a whole number, halves rounded up; who passes is decided by it."""
    return [
        Step(str(number), Fraction(max(2 * number - 1, 0), 2 * _FULL), number >= passing * _FULL)
        for number in range(_FULL, -1, -1)
    ]


def _share_out(percentages: Mapping[str, int]) -> Mapping[str, Fraction]:
    return {grade: Fraction(least, _FULL) for grade, least in percentages.items()}


def _step_down(grades: Mapping[str, Fraction], passing: Fraction) -> Sequence[Step]:
    return [Step(grade, least, least >= passing) for grade, least in grades.items()]


def _invert_curve(stated: StatedScale) -> Callable[[Fraction], Fraction]:
    """Which share counts as a given one: the straight line through two points, read backwards."""
    if not stated.curve:
        return lambda share: share
    (first, counts), (second, more) = stated.curve
    slope = (second - first) / (more - counts)
    return lambda share: first + (share - counts) * slope
