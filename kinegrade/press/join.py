"""PDF files joined one after another, by pikepdf (qpdf), with one structure for all."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO

if TYPE_CHECKING:
    import pikepdf

    from kinegrade.press.structure import JoinedStructure


@contextmanager
def open_volume(target: Path, *, duplex: bool = False) -> Iterator[Callable[[bytes], None]]:
    """A function that takes one PDF after another; at the end their pages are written to `target`.

    For printing on both sides, `duplex` starts each on a new sheet: a blank page follows an odd
    number of pages.
    """
    import pikepdf

    from kinegrade.press.structure import JoinedStructure

    with pikepdf.new() as whole:
        structure = JoinedStructure(whole)

        def append(pdf: bytes) -> None:
            _append(whole, structure, pdf)
            if duplex and len(whole.pages) % 2:
                left, bottom, right, top = map(float, whole.pages[-1].mediabox)
                whole.add_blank_page(page_size=(right - left, top - bottom))

        yield append
        structure.close()
        with target.open("wb") as stream:  # pikepdf itself takes file names only in UTF-8
            _save(whole, stream)


def join_pages(pdfs: Iterable[bytes]) -> bytes:
    """The pages of all `pdfs` in order as one PDF; same input, same bytes."""
    import pikepdf

    from kinegrade.press.structure import JoinedStructure

    whole_bytes = BytesIO()
    with pikepdf.new() as whole:
        structure = JoinedStructure(whole)
        for pdf in pdfs:
            _append(whole, structure, pdf)
        structure.close()
        _save(whole, whole_bytes)
    return whole_bytes.getvalue()


def count_pages(pdf: bytes) -> int:
    """The number of pages of a PDF."""
    import pikepdf

    with pikepdf.open(BytesIO(pdf)) as document:
        return len(document.pages)


def _append(whole: pikepdf.Pdf, structure: JoinedStructure, pdf: bytes) -> None:
    import pikepdf

    # Faster than mapping such a small file
    with pikepdf.open(BytesIO(pdf), access_mode=pikepdf.AccessMode.stream) as part:
        before = len(whole.pages)
        whole.pages.extend(part.pages)
        structure.add(part, [whole.pages[place] for place in range(before, len(whole.pages))])


def _save(whole: pikepdf.Pdf, target: BinaryIO) -> None:
    """Write a PDF; packed, as the elements of a structure are many and small."""
    import pikepdf

    whole.save(target, deterministic_id=True, object_stream_mode=pikepdf.ObjectStreamMode.generate)
