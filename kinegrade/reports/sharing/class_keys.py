"""The keys of a class as arrays, read part by part, so that a class of any size takes no object for
each of its keys.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.columns.gathering import read_mistakes
from kinegrade.exam.folder.papers import Paper
from kinegrade.exam.folder.sitting import Sitting
from kinegrade.grading.fast.bounds import Numbers, Rules, tabulate_rules
from kinegrade.reports.sharing.fits import Windows, find_windows

_PART = 1000  # papers read together


class Person(NamedTuple):
    """A student."""

    student: str
    name: str


class _Part(NamedTuple):
    """Some papers: `values` and `rules` have a row for each and a column for each ask; of what
    mistakes lead to, `places` are those of the asks, counted through these papers.
    """

    people: Sequence[Person]
    values: Numbers
    rules: Numbers
    periods: Sequence[float]
    places: NDArray[np.int32]
    wrong: Numbers


@dataclass(frozen=True)
class ClassKeys:
    """What is right on the papers of a class, in the order of `people`: `values` have a row for
    each paper and a column for each ask, NaN where it is not asked.

    For each ask, `windows` are what would be right on each paper, and the same together with what
    mistakes lead to.
    """

    asks: tuple[Ask, ...]
    people: tuple[Person, ...]
    values: Numbers
    windows: tuple[tuple[Windows, Windows], ...]

    @cached_property
    def papers(self) -> Sequence[bytes]:
        """The papers by what is right on them: two are equal where all of it is the same."""
        return [row.tobytes() for row in self.values + 0.0]  # 0 for -0

    @cached_property
    def unlike(self) -> Numbers:
        """For each student the number of others with a different paper, or 1 where there is
        none.
        """
        alike = Counter(self.papers)
        others = [len(self.papers) - alike[paper] for paper in self.papers]
        return np.maximum(1.0, np.array(others, dtype=np.float64))


def read_class_keys(exam: Sitting) -> ClassKeys:
    """The keys of all papers. Raises ExamError where they cannot be read."""
    papers, parts = exam.papers(), []
    while block := list(islice(papers, _PART)):
        parts.append(_read_part(block, len(exam.asks)))
    people = tuple(person for part in parts for person in part.people)
    values = np.concatenate([part.values for part in parts])
    windows = tuple(_find_both(parts, ask) for ask in range(len(exam.asks)))
    return ClassKeys(exam.asks, people, values, windows)


def _read_part(papers: Sequence[Paper], width: int) -> _Part:
    keys = [paper.keys for paper in papers]
    led_to = read_mistakes(keys, np.arange(len(keys) * width), width)
    periods = np.array([[float(each or 0) for each in own.list_periods()] for own in keys])
    return _Part(
        [Person(paper.student, paper.name) for paper in papers],
        np.array([each.list_values() for each in keys], dtype=np.float64),
        tabulate_rules([each.list_rules() for each in keys]).table.reshape(4, -1, width),
        periods.max(axis=0).tolist(),
        np.repeat(np.arange(len(keys) * width, dtype=np.int32), led_to.counts),
        led_to.values,
    )


def _find_both(parts: Sequence[_Part], ask: int) -> tuple[Windows, Windows]:
    """What is right at an ask, and the same with what mistakes lead to."""
    width, first = parts[0].values.shape[1], 0
    papers, wrong = [], []
    for part in parts:
        chosen = part.places % width == ask
        papers.append(first + part.places[chosen] // width)
        wrong.append(part.wrong[chosen])
        first += len(part.people)
    right = np.concatenate([part.values[:, ask] for part in parts])
    rules = Rules(np.concatenate([part.rules[:, :, ask] for part in parts], axis=1))
    period = max(part.periods[ask] for part in parts)
    own = np.arange(first)
    led = np.concatenate([own, *papers])
    return (
        find_windows(own, right, rules, period),
        find_windows(led, np.concatenate([right, *wrong]), rules, period),
    )
