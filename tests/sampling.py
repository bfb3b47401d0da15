"""Which tests and cases `make test` tries; `make prove` tries all of them ("whole tests").

@pytest.mark.sampled(4)                 every fourth value of the parameter `name`, from the first
@pytest.mark.sampled(4, first=2)        ... from the third: tests that stand together take turns
@pytest.mark.sampled(4, by="path")      ... of the parameter `path`
@pytest.mark.sampled(4, also=("cam",))  ... and this value, whatever its place
@pytest.mark.left(beside="test_it")     `make prove` alone runs this test, or this case of one; what
                                        breaks it breaks, as a rule, that cheaper one as well
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import pytest
from _pytest.mark.structures import ParameterSet

MARK = "sampled"
LEFT = "left"


@dataclass(frozen=True)
class Sample:
    """Every so many-th value of a parameter, beginning with the place `first`, and some `also`."""

    every: int
    first: int = 0
    by: str = "name"
    also: Collection[object] = ()

    def has(self, place: int, value: object) -> bool:
        """Whether the value at a place among all is tried."""
        return place % self.every == self.first or value in self.also


def drop_unsampled(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave the cases that no sample has out of a run, and say how many they are."""
    left = [item for item in items if not _is_tried(item)]
    if left:
        config.hook.pytest_deselected(items=left)
        out = set(map(id, left))
        items[:] = [item for item in items if id(item) not in out]


def _is_tried(item: pytest.Item) -> bool:
    if item.get_closest_marker(LEFT) is not None:
        return False
    samples = [Sample(*mark.args, **mark.kwargs) for mark in item.iter_markers(MARK)]
    return all(_has(sample, item) for sample in samples)


def _has(sample: Sample, item: pytest.Item) -> bool:
    """Whether a sample has the case of a test."""
    if not isinstance(item, pytest.Function):
        return True
    value = item.callspec.params[sample.by]
    return sample.has(_find_place(item, sample.by), value)


def _find_place(item: pytest.Function, name: str) -> int:
    """The place of a parameter's value among all that it has: those of a test, or of a fixture."""
    for mark in item.iter_markers("parametrize"):
        if mark.args[0] == name:
            return list(map(_read, mark.args[1])).index(item.callspec.params[name])
    return item.callspec.indices[name]


def _read(case: object) -> object:
    """The value of a case that may be a `pytest.param`."""
    return case.values[0] if isinstance(case, ParameterSet) else case
