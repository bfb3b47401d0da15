"""Zip files whose bytes depend on nothing but their contents.

Entries are written to disk one by one; only the zip's directory stays in memory, some hundred bytes
for each.
"""

from __future__ import annotations

import shutil
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO

from kinegrade.errors import ExportError
from kinegrade.files.output import output_file
from kinegrade.language.message import Message, Quoted

ORDINARY = 0o644  # of what is taken out: others may read it
_FIRST_DATE = (1980, 1, 1, 0, 0, 0)  # the earliest that a zip can have


class Package:
    """A zip that is being written; the same entries give the same bytes on every machine."""

    def __init__(self, archive: zipfile.ZipFile, mode: int = ORDINARY) -> None:
        self._archive, self._mode = archive, mode
        self._names: set[str] = set()

    def add(self, name: str, content: bytes) -> None:
        """Writes an entry. Raises ExportError where the name is taken already."""
        with self._entry(name) as entry:
            entry.write(content)

    def copy(self, name: str, stream: IO[bytes]) -> None:
        """Writes the whole of a stream as an entry, piece by piece. Raises ExportError as `add`
        does.
        """
        stream.seek(0)
        with self._entry(name) as entry:
            shutil.copyfileobj(stream, entry)

    def _entry(self, name: str) -> IO[bytes]:
        if name in self._names:
            raise ExportError(Message("quiz-file.name-taken", name=Quoted(name)))
        self._names.add(name)
        entry = zipfile.ZipInfo(name, _FIRST_DATE)
        entry.compress_type = zipfile.ZIP_DEFLATED
        entry.create_system, entry.external_attr = 3, self._mode << 16
        return self._archive.open(entry, "w")


@contextmanager
def open_package(target: Path, *, force: bool, mode: int = ORDINARY) -> Iterator[Package]:
    """A package that becomes `target` when the block ends without an error; who takes it apart
    gets files of that `mode`.

    With `force` an existing plain file is replaced. Raises OutputError.
    """
    with output_file(target, force=force) as partial, zipfile.ZipFile(partial, "x") as archive:
        yield Package(archive, mode)
