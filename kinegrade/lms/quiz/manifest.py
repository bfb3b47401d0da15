"""An imsmanifest.xml that grows on disk while a package is written."""

from __future__ import annotations

from tempfile import TemporaryFile
from typing import IO

from kinegrade.lms.quiz.xml_text import Xml


class Manifest:
    """The list of a package's resources between `head` and `foot`; a context, because it holds a
    temporary file.
    """

    def __init__(self, head: str, foot: str) -> None:
        self._foot = foot
        self._stream: IO[bytes] = TemporaryFile()  # noqa: SIM115 - closed on leaving the context
        self._stream.write(head.encode())

    def __enter__(self) -> Manifest:
        return self

    def __exit__(self, *_: object) -> None:
        self._stream.close()

    def add(self, *resources: Xml) -> None:
        """Appends resources."""
        for resource in resources:
            self._stream.write(f"{resource}\n".encode())

    def finished(self) -> IO[bytes]:
        """The whole manifest."""
        self._stream.write(self._foot.encode())
        return self._stream
