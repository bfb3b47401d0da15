"""PDF files joined one after another, with one structure for all."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from shutil import copyfileobj
from tempfile import TemporaryFile

from kinegrade.press.binding.part import read_part
from kinegrade.press.binding.volume import Volume


@contextmanager
def open_volume(target: Path, *, duplex: bool = False) -> Iterator[Callable[[bytes], None]]:
    """A function that takes one PDF after another; at the end their pages are written to `target`.

    For printing on both sides, `duplex` starts each on a new sheet: a blank page follows an odd
    number of pages.
    """
    # What stands at `target` may be one of the parts
    with TemporaryFile(dir=target.parent) as draft:
        volume = Volume(draft)

        def append(pdf: bytes) -> None:
            volume.add(read_part(pdf))
            if duplex and volume.pages % 2:
                volume.add_blank_page()

        yield append
        volume.close()
        draft.seek(0)
        with target.open("wb") as stream:
            copyfileobj(draft, stream)


def join_pages(pdfs: Iterable[bytes]) -> bytes:
    """The pages of all `pdfs` in order as one PDF; same input, same bytes."""
    whole = BytesIO()
    volume = Volume(whole)
    for pdf in pdfs:
        volume.add(read_part(pdf))
    volume.close()
    return whole.getvalue()
