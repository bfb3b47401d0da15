"""Whether code is being loaded, which a signal should not interrupt: modules written in other
languages report an exception while they are loaded as a crash, in many lines of their own.
"""

from __future__ import annotations

from collections.abc import Iterator
from types import FrameType

_LOADER = "<frozen importlib._bootstrap>"


def is_loading(frame: FrameType | None) -> bool:
    """Whether what was interrupted at that frame loads a module."""
    return any(each.f_code.co_filename == _LOADER for each in _list_callers(frame))


def _list_callers(frame: FrameType | None) -> Iterator[FrameType]:
    while frame is not None:
        yield frame
        frame = frame.f_back
