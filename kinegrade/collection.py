"""How often Python looks for cyclic rubbish while a class is printed or marked: seldom, for there is hardly any.

This file loads nothing of kinegrade, so that a new process is set up before it loads what it works with.
"""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

# Between two looks, usually some 700: a paper makes a hundred thousand objects, a marked class a million, and hardly
# any cycles among them.
NEW_OBJECTS = 50_000


@contextmanager
def seldom_collected() -> Iterator[None]:
    """Meanwhile, looking for cyclic rubbish costs little: what is there stays, and what is made is freed without it."""
    usual = gc.get_threshold()
    gc.freeze()
    gc.set_threshold(NEW_OBJECTS)
    try:
        yield
    finally:
        gc.set_threshold(*usual)
        gc.unfreeze()
