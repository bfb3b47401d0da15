"""How alike two figures of a template are: the figure of another student is another picture.

Both are laid over each other, their middles together and their diagonals made equal. Every stroke counts alike,
however long it is, so that the rim of a ring gear does not hide that the arm in it has turned.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import hypot
from statistics import median

import numpy as np
from numpy.typing import NDArray
from shapely import get_coordinates, get_parts, line_interpolate_point
from shapely.geometry.base import BaseGeometry

from kinegrade.figure.similar_mechanisms import Subject
from tests.figures.svg_shapes import Picture

DIAGONAL = 60.0  # millimetres, to which figures are brought before they are compared
APART = 2.0  # millimetres beyond which ink is at another place
EVERY = 1.0  # millimetres between the places of a stroke that are looked at
ENOUGH = 0.08  # the share of strokes in which two papers differ, typically
SELDOM = 0.07  # the largest share of pairs of papers that have about one picture
SAME_PLACE = 0.03  # of the size of a mechanism, up to which a point is at about the same place

# Whose figures are alike for the reason that is given; the list only shrinks
ALIKE: Mapping[str, str] = {
    "belt-driven-bicycle": "wheels in a row; it travels to either side",
    "differential-epicyclic-train": "gears of one size; the arm alone turns",
    "epicyclic-train-by-tooth-counts": "gears of one size; the arm alone turns",
    "geneva-drive": "four slots fix the shape; the crank is at either side, below or above",
    "pin-in-two-rings": "two equal rings; how far they overlap alone differs",
    "pinion-between-two-racks": "one pinion and two racks; their ends alone differ",
    "rolling-wheel-pole-acceleration": "one wheel on a straight track; the senses alone differ",
    "tangent-cam-with-roller": "the profile is tight; it is mirrored in half of the papers",
    "two-stage-belt-drive": "pulleys in a row; the layout is mirrored in half of the papers",
}


@dataclass(frozen=True)
class Strokes:
    """Places on the strokes of a figure, and for each the number of its stroke."""

    places: NDArray[np.float64]
    owners: NDArray[np.intp]


def trace(picture: Picture) -> Strokes:
    """The strokes of a figure, about its middle and as large as all others. Letters are left out."""
    traced = [_walk(shape) for shape in picture.ink]
    places = np.vstack(traced)
    owners = np.repeat(np.arange(len(traced)), [len(each) for each in traced])
    low, high = places.min(axis=0), places.max(axis=0)
    return Strokes((places - (low + high) / 2) * (DIAGONAL / np.hypot(*(high - low))), owners)


def _walk(shape: BaseGeometry) -> NDArray[np.float64]:
    """Places along the outline of what is seen of a stroke."""
    lines = get_parts(shape.boundary)
    return np.vstack(
        [get_coordinates(line_interpolate_point(x, np.arange(0.0, x.length, EVERY))) for x in lines]
    )


def measure_difference(one: Strokes, other: Strokes) -> float:
    """The share of strokes that are at another place in the other figure: 0 where both are one
    picture, 1 where nothing is common.
    """
    return (_find_alone(one, other) + _find_alone(other, one)) / 2


def _find_alone(one: Strokes, other: Strokes) -> float:
    ways = one.places[:, None, :] - other.places[None, :, :]
    alone = (ways**2).sum(axis=2).min(axis=1) > APART**2
    totals = np.bincount(one.owners)
    shares = np.bincount(one.owners, alone)[totals > 0] / totals[totals > 0]
    return float(shares.mean())


def find_typical_difference(pictures: Sequence[Picture]) -> float:
    """The difference of a pair of papers: half of all pairs differ more."""
    return median(_list_differences(pictures))


def _list_differences(pictures: Sequence[Picture]) -> Iterator[float]:
    for one, other in combinations(list(map(trace, pictures)), 2):
        yield measure_difference(one, other)


def list_alike(template: str, pictures: Sequence[Picture]) -> list[str]:
    """What is wrong with the figures of a template's papers, in words."""
    found = find_typical_difference(pictures)
    if found >= ENOUGH or template in ALIKE:
        return []
    return [f"{template}: two papers differ in {found:.0%} of their strokes, not {ENOUGH:.0%}"]


def find_share_of_repeats(subjects: Sequence[Subject]) -> float:
    """The share of pairs of papers whose points are all at about the same places."""
    pairs = list(combinations(subjects, 2))
    return sum(_repeats(one, other) for one, other in pairs) / len(pairs)


def _repeats(one: Subject, other: Subject) -> bool:
    places = other.mechanism.points
    ways = (at - places[name] for name, at in one.mechanism.points.items())
    return all(hypot(*way) < SAME_PLACE for way in ways)
