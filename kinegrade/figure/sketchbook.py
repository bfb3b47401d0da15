"""Figures that several processes need: drawn by the first of them, and kept in a folder for the
others.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache, partial
from hashlib import sha256
from pathlib import Path

import msgspec

from kinegrade.figure.scene import Scene
from kinegrade.figure.similar_mechanisms import Subject
from kinegrade.figure.sketch import PLAIN, Sketcher, draw_unit_figure, size_figure, sketch
from kinegrade.mechanics.mechanism import Mechanism
from kinegrade.problem.template.hints import FigureHints


@contextmanager
def open_sketchbook(processes: int) -> Iterator[Path | None]:
    """A private folder where so many processes share figures, removed after the block; None for
    one process, which keeps its figures itself. Raises OutputError.
    """
    if processes == 1:
        yield None
        return
    # A paper that is printed alone shares no figures
    from kinegrade.files.temporary import temporary_folder  # noqa: PLC0415

    with temporary_folder() as book:
        yield book


def choose_sketcher(book: Path | None) -> Sketcher:
    """What draws figures as `sketch` does, and keeps them in the folder `book` if there is one."""
    return partial(sketch_once, book) if book else sketch


def sketch_once(book: Path, mechanism: Mechanism, hints: FigureHints = PLAIN) -> Scene:
    """The figure that `sketch` gives, read from the folder `book` if another process has drawn it.

    Raises TemplateError as `sketch` does.
    """
    return size_figure(lambda shown: _read_kept(book, shown), mechanism, hints)


@lru_cache(maxsize=1024)
def _read_kept(book: Path, shown: Subject) -> Scene:
    """The figure of a mechanism of unit size, read from the book or added to it. A page is written
    atomically.
    """
    page = book / sha256(shown.text.encode()).hexdigest()
    try:
        scene = msgspec.json.decode(page.read_bytes(), type=Scene)
    except FileNotFoundError:
        scene = draw_unit_figure(shown)
        draft = page.with_suffix(f".{os.getpid()}")
        draft.write_bytes(msgspec.json.encode(scene))
        draft.replace(page)
    return scene
