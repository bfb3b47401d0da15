"""Runs of whole numbers, thousands at once: which places belong to what, where so many stand one
behind the other.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_Places = NDArray[np.intp]


def list_runs(begins: _Places, counts: _Places) -> _Places:
    """So many numbers from where each run begins, run after run.

    >>> list_runs(np.array([7, 0]), np.array([2, 3])).tolist()
    [7, 8, 0, 1, 2]
    """
    return np.arange(counts.sum()) + np.repeat(begins - find_begins(counts), counts)


def find_begins(counts: _Places) -> _Places:
    """Where runs of so many begin that stand one behind the other.

    >>> find_begins(np.array([2, 3, 1])).tolist()
    [0, 2, 5]
    """
    return np.cumsum(counts) - counts
