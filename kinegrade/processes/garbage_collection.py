"""Raise the garbage-collection threshold while a class is printed or marked: there are hardly any
cycles to collect.

This file loads nothing of kinegrade, so that a new process is set up before it loads the rest.
"""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

# Objects between two collections, by default some 700: a paper makes a hundred thousand objects, a
# marked class a million, with hardly any cycles among them.
NEW_OBJECTS = 200_000


@contextmanager
def bulk_work() -> Iterator[None]:
    """Inside the block, existing objects are not searched for cycles, and new ones only rarely.

    What a program that calls kinegrade had frozen stays frozen.
    """
    usual, is_ours = gc.get_threshold(), not is_frozen()
    if is_ours:
        gc.freeze()
    gc.set_threshold(NEW_OBJECTS)
    try:
        yield
    finally:
        gc.set_threshold(*usual)
        if is_ours:
            gc.unfreeze()


def is_frozen() -> bool:
    """Whether a program has frozen anything; the interpreter counts all of it to say so."""
    return gc.get_freeze_count() > 0
