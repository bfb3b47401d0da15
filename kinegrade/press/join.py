"""PDF files joined one after another, by pikepdf (qpdf)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path

import pikepdf


@contextmanager
def open_volume(target: Path, *, duplex: bool = False) -> Iterator[Callable[[bytes], None]]:
    """A function that takes one PDF after another; at the end their pages are written to `target`.

    For printing on both sides, `duplex` starts each on a new sheet: a blank page follows an odd
    number of pages.
    """
    with pikepdf.new() as whole:

        def append(pdf: bytes) -> None:
            _append(whole, pdf)
            if duplex and len(whole.pages) % 2:
                left, bottom, right, top = map(float, whole.pages[-1].mediabox)
                whole.add_blank_page(page_size=(right - left, top - bottom))

        yield append
        with target.open("wb") as stream:  # pikepdf itself takes file names only in UTF-8
            whole.save(stream, deterministic_id=True)


def join_pages(pdfs: Iterable[bytes]) -> bytes:
    """The pages of all `pdfs` in order as one PDF; same input, same bytes."""
    whole_bytes = BytesIO()
    with pikepdf.new() as whole:
        for pdf in pdfs:
            _append(whole, pdf)
        whole.save(whole_bytes, deterministic_id=True)
    return whole_bytes.getvalue()


def count_pages(pdf: bytes) -> int:
    """The number of pages of a PDF."""
    with pikepdf.open(BytesIO(pdf)) as document:
        return len(document.pages)


def _append(whole: pikepdf.Pdf, pdf: bytes) -> None:
    # Faster than mapping such a small file
    with pikepdf.open(BytesIO(pdf), access_mode=pikepdf.AccessMode.stream) as part:
        whole.pages.extend(part.pages)
