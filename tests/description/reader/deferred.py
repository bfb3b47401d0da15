"""Values that can be computed only once the positions of some points are known."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

Value = TypeVar("Value")
Points = Mapping[str, complex]


@dataclass(frozen=True)
class Deferred(Generic[Value]):
    """A value that follows from the positions of the points it needs."""

    needs: frozenset[str]
    at: Callable[[Points], Value]


def known(value: Value) -> Deferred[Value]:
    """A value that needs no point."""
    return Deferred(frozenset(), lambda points: value)


def position(name: str) -> Deferred[complex]:
    """The position of the point of that name."""
    return Deferred(frozenset([name]), lambda points: points[name])


def combined(function: Callable[..., Value], *parts: Deferred[Any]) -> Deferred[Value]:
    """The function of the parts, each taken at the same positions."""
    needs = frozenset[str]().union(*(part.needs for part in parts))
    return Deferred(needs, lambda points: function(*(part.at(points) for part in parts)))
