"""Raise the garbage-collection threshold while a class is printed or marked: there are hardly any
cycles to collect.

This file loads nothing of kinegrade, so that a new process is set up before it loads what it works
with.
"""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

# Between two collections, usually some 700: a paper makes a hundred thousand objects, a marked
# class a million, and hardly any cycles among them.
NEW_OBJECTS = 50_000


@contextmanager
def bulk_work() -> Iterator[None]:
    """Inside the block, what exists is not looked through for cycles, and new objects only
    rarely.
    """
    usual = gc.get_threshold()
    gc.freeze()
    gc.set_threshold(NEW_OBJECTS)
    try:
        yield
    finally:
        gc.set_threshold(*usual)
        gc.unfreeze()
