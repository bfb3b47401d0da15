"""News that the file, or a file that is read with it, has been saved."""

from __future__ import annotations

from collections.abc import AsyncIterator
from pathlib import Path
from threading import Event

from watchfiles import Change, awatch

_CALM = 30  # milliseconds without another change, after which what was saved is read
_PATIENCE = 200  # milliseconds at most, for editors that save in several steps
_SILENCE = 1000  # milliseconds without a change


async def watch_file(path: Path, ended: Event) -> AsyncIterator[bool]:
    """Yields True after each change of a file, or of what a template or a bank may be read with:
    the files beside it, and those in the folders there; and False when for a while there was none.
    Stops when the preview has ended.
    """
    changes = awatch(
        *_find_folders(path.resolve().parent),
        watch_filter=_is_read,
        debounce=_PATIENCE,
        step=_CALM,
        rust_timeout=_SILENCE,
        yield_on_timeout=True,
        stop_event=ended,
        recursive=False,  # the folder may be somebody's home
    )
    async for changed in changes:
        yield bool(changed)


def _find_folders(folder: Path) -> set[Path]:
    """A folder, and those directly inside it that hold templates or mechanisms."""
    return {folder, *(each.parent for each in folder.glob("*/*.toml"))}


def _is_read(_: Change, name: str) -> bool:
    return name.endswith(".toml")
