"""Volumes of equal files are joined once in each process of tests: joining the papers and the key of
a small exam takes a third as long as all else that sets it. `make prove` joins them anew.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path

from kinegrade.exam.handing_out import group_bundles
from kinegrade.exam.printing import printed_files, room_booklets
from kinegrade.press import join
from kinegrade.press.typst import feedback, press

MANY = 60  # volumes, of which each takes as much memory as its file
MOST = 2_000_000  # bytes of one that is kept
_kept: dict[str, bytes] = {}


@contextmanager
def open_volume(target: Path, *, duplex: bool = False) -> Iterator[Callable[[bytes], None]]:
    """As `open_volume` of join, once nothing failed in between."""
    parts: list[bytes] = []
    yield parts.append
    key = _identify(parts, duplex)
    if key in _kept:
        target.write_bytes(_kept[key])
        return
    with join.open_volume(target, duplex=duplex) as append:
        for part in parts:
            append(part)
    _keep(key, target.read_bytes())


def join_pages(pdfs: Iterable[bytes]) -> bytes:
    """As `join_pages` of join."""
    parts = list(pdfs)
    key = _identify(parts, None)
    if key not in _kept:
        return _keep(key, join.join_pages(parts))
    return _kept[key]


def _identify(parts: Iterable[bytes], duplex: bool | None) -> str:
    digests = [sha256(part).hexdigest() for part in parts]
    return sha256(repr((digests, duplex)).encode()).hexdigest()


def _keep(key: str, volume: bytes) -> bytes:
    """The volume, kept in place of the oldest where many are."""
    if len(volume) <= MOST:
        _kept[key] = volume
        if len(_kept) > MANY:
            _kept.pop(next(iter(_kept)))
    return volume


def keep_volumes() -> None:
    """Let all tests of this process share volumes of equal files."""
    for module in (group_bundles, printed_files, room_booklets):
        module.open_volume = open_volume
    for module in (press, feedback):
        module.join_pages = join_pages
