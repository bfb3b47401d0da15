"""Output put in place in one step, whatever stands there."""

from __future__ import annotations

import ctypes
import errno
import os
import secrets
import sys
from pathlib import Path

from kinegrade.errors import OutputError
from kinegrade.files.leftovers import remove
from kinegrade.language.message import Fault, Message

_CURRENT_FOLDER = -100  # AT_FDCWD
_LINUX_NO_REPLACE, _LINUX_EXCHANGE = 1, 2
_MACOS_SWAP, _MACOS_EXCLUSIVE = 2, 4
_UNSUPPORTED = (errno.ENOSYS, errno.EINVAL, errno.ENOTSUP, errno.EOPNOTSUPP)


def sync_folder(folder: Path) -> None:
    """Flushes the entries of a folder to disk, where the system can."""
    if os.name == "nt":  # folders cannot be opened there
        return
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def publish(path: Path, partial: Path, target: Path) -> None:
    """Puts what was built beside its place there. Raises OutputError where the place was taken."""
    if not target.exists():
        move_to_free_place(path, partial, target)
    elif not _rename_atomically(partial, target, exchange=True):
        _replace_in_two_steps(partial, target)
    sync_folder(target.parent)


def move_to_free_place(path: Path, partial: Path, target: Path) -> None:
    """Refuses if the place was taken while the output was being made."""
    try:
        if not _rename_atomically(partial, target, exchange=False):
            if target.exists():
                raise FileExistsError
            os.rename(partial, target)
    except FileExistsError:
        raise OutputError(Fault(str(path), Message("files.name-taken"))) from None


def _replace_in_two_steps(partial: Path, target: Path) -> None:
    previous = target.with_name(f".{target.name}.previous-{secrets.token_hex(4)}")
    os.rename(target, previous)
    os.rename(partial, target)
    remove(previous)


def _rename_atomically(source: Path, target: Path, *, exchange: bool) -> bool:
    """Swaps two entries, or moves one to a free name; False where the system cannot. Raises
    OSError.
    """
    if os.name != "posix":
        return False
    library = ctypes.CDLL(None, use_errno=True)
    old, new = os.fsencode(source), os.fsencode(target)
    if sys.platform == "darwin" and hasattr(library, "renamex_np"):
        status = library.renamex_np(old, new, _MACOS_SWAP if exchange else _MACOS_EXCLUSIVE)
    elif sys.platform == "linux" and hasattr(library, "renameat2"):
        flag = _LINUX_EXCHANGE if exchange else _LINUX_NO_REPLACE
        status = library.renameat2(_CURRENT_FOLDER, old, _CURRENT_FOLDER, new, ctypes.c_uint(flag))
    else:
        return False
    code = ctypes.get_errno()
    if status != 0 and code not in _UNSUPPORTED:
        raise OSError(code, os.strerror(code), str(target))
    return bool(status == 0)
