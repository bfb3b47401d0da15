"""The keys of many papers side by side, as judges compare with them: in one step where they stand
in one part, else paper by paper.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain, islice
from typing import assert_never

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.columns.blocks import PartRows
from kinegrade.exam.folder.columns.part import KeyPart, PartKeys
from kinegrade.exam.folder.columns.record import PART
from kinegrade.exam.folder.columns.runs import list_runs
from kinegrade.exam.folder.key.stated_keys import StatedKeys, read_stated_mistakes
from kinegrade.exam.folder.keys import Keys
from kinegrade.exam.folder.papers import Paper, RightAnswers
from kinegrade.exam.folder.sitting import Sitting
from kinegrade.numbers.decimals import FEW_DIGITS
from kinegrade.numbers.tolerance import Tolerance

Numbers = NDArray[np.float64]
Places = NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class LedTo:
    """What mistakes lead to in some asks, one after the other: so many in each ask, which of those
    that are `known`, and the wrong values, which are decimals `as_written` or any numbers.
    """

    counts: Places
    names: NDArray[np.integer]
    values: Numbers
    known: Sequence[str]
    as_written: bool

    @classmethod
    def of(cls, mistakes: Sequence[Mapping[str, float | Fraction]]) -> LedTo:
        """The same from the mistakes of each ask."""
        numbers: dict[str, int] = {}
        names = [numbers.setdefault(name, len(numbers)) for each in mistakes for name in each]
        values = [*chain.from_iterable(each.values() for each in mistakes)]
        return cls(
            np.array([len(each) for each in mistakes], dtype=np.intp),
            np.array(names, dtype=np.intp),
            np.array(values, dtype=np.float64),
            tuple(numbers),
            all(isinstance(value, float) for value in values),
        )


def read_centres(papers: Sequence[Keys]) -> Numbers:
    """The right answers in double precision, a row for each paper; NaN where a number of turns is
    right too, or nothing was asked.
    """
    found = _find_rows(papers)
    if found is not None:
        part, rows = found
        return part.centres[rows]
    return np.array([keys.list_centres() for keys in papers], dtype=np.float64)


def list_rules(papers: Sequence[Keys]) -> Sequence[tuple[Tolerance, ...]]:
    """The rules of each paper; where papers share all of them, the same object."""
    match papers:
        case PartRows():
            return papers.list_rules()
        case Sequence():
            return [keys.list_rules() for keys in papers]
        case _:
            assert_never(papers)


def find_decimals(papers: Sequence[Keys], places: Places, width: int) -> NDArray[np.bool_]:
    """Which of the right answers at these places, counted through all papers of so many asks, are
    decimals of few digits.
    """
    asked = (divmod(place, width) for place in places.tolist())
    found = [_is_decimal(papers[row].state(ask)) for row, ask in asked]
    return np.array(found, dtype=np.bool_)


def _is_decimal(text: str) -> bool:
    """Whether a number written as a decimal or a fraction is a decimal of few digits."""
    numerator, _, denominator = text.partition("/")
    if not denominator:
        return len(text) <= FEW_DIGITS
    digits, rest = divmod(int(numerator) * 10**FEW_DIGITS, int(denominator))
    return not rest and len(str(abs(digits)).rstrip("0")) <= FEW_DIGITS


def read_right_answers(exam: Sitting) -> Iterator[RightAnswers]:
    """What is right on all papers of an exam, in the order of the roster, and then on those of its
    pool. Raises ExamError where they cannot be read.
    """
    done = 0
    for part in exam.right_answers():
        yield part
        done += len(part.values)
    others = islice(exam.papers(), done, None) if done < len(exam.students) else ()
    rest = chain(others, exam.variants())
    while papers := list(islice(rest, PART)):
        yield _gather_right_answers(papers)


def _gather_right_answers(papers: Sequence[Paper]) -> RightAnswers:
    """What is right on these papers."""
    keys = [paper.keys for paper in papers]
    values = np.array([each.list_values() for each in keys], dtype=np.float64)
    listed = zip(*(each.list_periods() for each in keys), strict=True)
    periods = [float(max(period or 0 for period in own)) for own in listed]
    return RightAnswers(values, [each.list_rules() for each in keys], periods)


def read_mistakes(papers: Sequence[Keys], places: Places, width: int) -> LedTo:
    """What mistakes lead to in the asks at these places, counted through all papers of so many
    asks. Raises ExamError as `StatedKeys.mistakes` does.
    """
    found = _find_rows(papers)
    if found is not None:
        part, rows = found
        return _gather_mistakes(part, rows[places // width] * width + places % width)
    asked = [(papers[place // width], place % width) for place in places.tolist()]
    stated = [(keys, ask) for keys, ask in asked if isinstance(keys, StatedKeys)]
    if len(stated) == len(asked):
        return LedTo.of(read_stated_mistakes(stated))
    return LedTo.of([keys[ask].mistakes for keys, ask in asked])


def _gather_mistakes(part: KeyPart, places: Places) -> LedTo:
    """Those of the asks of a part at these places, as they stand there one after the other."""
    begins = part.ends[places]
    counts = part.ends[places + 1] - begins
    chosen = list_runs(begins, counts)
    return LedTo(counts, part.names[chosen], part.wrong[chosen], part.known, as_written=True)


def _find_rows(papers: Sequence[Keys]) -> tuple[KeyPart, Places] | None:
    """The part in which the keys of all papers stand, and their rows; None where there is none."""
    match papers:
        case PartRows(part=part, rows=rows):
            return part, np.arange(rows.start, rows.stop)
        case Sequence():
            return _find_common_part(papers)
        case _:
            assert_never(papers)


def _find_common_part(papers: Sequence[Keys]) -> tuple[KeyPart, Places] | None:
    """The same of keys that are held one by one."""
    held = [keys for keys in papers if isinstance(keys, PartKeys)]
    if not held or len(held) < len(papers):
        return None
    part = held[0].part
    if any(keys.part is not part for keys in held):
        return None
    return part, np.array([keys.row for keys in held], dtype=np.intp)
