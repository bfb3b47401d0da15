"""Labels that stand beside others, with which they would read as one word or as a product."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from kinegrade.figure.placing.extent import measure_symbol
from kinegrade.figure.placing.place import Floats, Wish, measure_gap
from kinegrade.figure.scene import Label
from kinegrade.mechanics.vector import Vector

# Millimetres between a letter and a label that make one word of them, and its demerit, as of a spot
# so much later that a letter still stands at its mark
_ADJOINS, _ONE_WORD = 1.5, 1.3
# Millimetres between two labels in one row that do not read as a product, and the share of its
# height by which one of them may be raised and still stand in the row
_SPACE, _IN_ROW = 3.0, 0.5


def adjoins(label: Label, others: Iterable[Label]) -> bool:
    """Whether a label is so close to another one that it would seem to be its index."""
    return any(measure_gap(label, other) < _ADJOINS for other in others)


def makes_word(label: Label, others: Iterable[Label]) -> bool:
    """Whether a label stands in one row with another one, close beside it."""
    return any(
        abs(label.centre.y - other.centre.y) < _IN_ROW * min(label.height, other.height)
        and measure_gap(label, other) < _SPACE
        for other in others
    )


def makes_product(label: Label, others: Iterable[Label]) -> bool:
    """Whether a label stands right beside another one in one row, as its factor would."""
    return any(adjoins(label, [other]) and makes_word(label, [other]) for other in others)


def rate_close(wish: Wish, others: Sequence[Label], apart: float) -> Floats:
    """For each spot of a wish 1 where the symbol is less than so far apart from one of some labels,
    else 0.
    """
    places = [wish.label_at(spot) for spot in range(len(wish.spots))]
    close = [any(measure_gap(place, other) < apart for other in others) for place in places]
    return np.asarray(close, dtype=float)


def keep_from_labels(wish: Wish, labels: Iterable[Label]) -> Wish:
    """The wish, rather not beside another label, with which the symbol would make a word."""
    size, others = measure_symbol(wish.symbol), tuple(labels)
    places = [Label(wish.symbol, Vector(x, y), *size) for x, y in wish.spots.tolist()]
    beside = [adjoins(place, others) or makes_word(place, others) for place in places]
    worse = _ONE_WORD * np.array(beside)
    return wish.worse_by(worse)
