"""How rounding bears on an answer: how far off it may be, and which terms cancel in it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING, Generic, TypeVar

if TYPE_CHECKING:
    from kinegrade.numbers.noting.pad import Doubles

_Number = TypeVar("_Number", float, "Doubles")


@dataclass(frozen=True)
class Rounding(Generic[_Number]):
    """How rounding bears on an answer, in its unit, in one instance or an array of them.

    No student is further off than the `bound`. `largest` is the largest term that goes into the
    answer, which is far larger than the answer where terms cancel; it is between a
    hundred-millionth and the whole of the mechanism's scale of such quantities.
    """

    bound: _Number
    largest: _Number


UNBOUNDED = Rounding(inf, 0.0)  # of an answer that cannot be worked out


def take_one(roundings: Mapping[str, Rounding[Doubles]], place: int) -> dict[str, Rounding[float]]:
    """The rounding of one of several instances, by ask."""
    return {
        name: Rounding(float(each.bound[place]), float(each.largest[place]))
        for name, each in roundings.items()
    }
