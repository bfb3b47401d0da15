"""Files that a bank names beside itself: a logo, a formula sheet."""

from __future__ import annotations

from pathlib import Path
from stat import S_ISREG

from kinegrade.errors import FieldError
from kinegrade.files.fields.values import found
from kinegrade.language.message import Message


def read_file_beside(path: Path, most: int, expected: Message) -> bytes:
    """The bytes of a file that has no more than `most`. Raises FieldError."""
    try:
        status = path.stat()
        if not S_ISREG(status.st_mode):
            raise FieldError(found(path.name), expected)
        with path.open("rb") as file:
            content = file.read(most + 1)
    except OSError as fault:
        what = Message("files.cannot-be-read", reason=str(fault.strerror))
        raise FieldError(what, expected) from fault
    if len(content) > most:
        raise FieldError(Message("bank.file-too-large", name=found(path.name), most=most // 1000))
    return content
