"""Output put in place in one step, whatever stands there; and what may be replaced by it: nothing
that somebody else has put there.
"""

from __future__ import annotations

import ctypes
import errno
import os
import secrets
import sys
from collections.abc import Collection, Iterator
from pathlib import Path, PurePosixPath

from kinegrade.errors import OutputError
from kinegrade.files.placing.droppings import DESKTOP_DROPPINGS
from kinegrade.files.placing.leftovers import remove
from kinegrade.files.placing.one_at_a_time import alone_in
from kinegrade.files.placing.readings import forget_readings, require_readings
from kinegrade.files.placing.standing import Standing
from kinegrade.language.message import Fault, Message, list_plainly

_MOST_NAMED = 5

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


def publish(path: Path, partial: Path, target: Path, stood: Standing) -> None:
    """Puts what was built beside its place there. Raises OutputError where something else stands
    there than `stood`.
    """
    with alone_in(target.parent):
        stood.require(target, path)
        forget_readings(partial)
        require_readings()
        if not target.exists():
            move_to_free_place(path, partial, target)
        elif not _rename_atomically(partial, target, exchange=True):
            _replace_in_two_steps(path, partial, target, stood)
        forget_readings(target)
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


def _replace_in_two_steps(path: Path, partial: Path, target: Path, stood: Standing) -> None:
    """Network disks need this: there no lock holds others off, so that what was taken away is
    looked at again.
    """
    previous = target.with_name(f".{target.name}.previous-{secrets.token_hex(4)}")
    os.rename(target, previous)
    try:
        stood.require(previous, path)
    except OutputError:
        os.rename(previous, target)
        raise
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


def check_folder(
    path: Path, target: Path, marker: str | None, contents: Collection[str] | None, force: bool
) -> None:
    """Raises OutputError where `target`, which `path` leads to, must not be replaced by a folder.

    `marker` and `contents` are as `output_folder` has them.
    """
    if not target.exists():
        return
    if not target.is_dir():
        raise OutputError(Fault(str(path), Message("files.not-a-folder")))
    if not force:
        raise OutputError(Fault(str(path), Message("files.folder-exists")))
    names = set(_list_names(target, contents or ()))
    if names and marker is not None and marker not in names:
        raise OutputError(Fault(str(path), Message("files.not-ours", marker=marker)))
    strangers = sorted(names - set(contents)) if contents is not None else []
    if strangers:
        lost = list_plainly(strangers[:_MOST_NAMED])
        raise OutputError(
            Fault(
                str(path),
                Message("files.would-be-lost", names=lost),
                Message("files.only-what-is-written-again"),
                Message("files.move-elsewhere"),
            )
        )
    _require_no_protection(path, target)


def _require_no_protection(path: Path, target: Path) -> None:
    """Raises OutputError where somebody protected the folder, or one in it: it could be taken away
    from its place, and not be removed.
    """
    for place, _, _ in os.walk(target, onerror=_raise):
        if not os.access(place, os.W_OK):
            inner = path / Path(place).relative_to(target)
            what, expected = Message("files.write-protected"), Message("files.replaceable")
            raise OutputError(Fault(str(inner), what, expected, Message("files.unprotect")))


def _raise(fault: OSError) -> None:
    raise fault


def check_file(path: Path, target: Path, force: bool) -> None:
    """Raises OutputError where `target`, which `path` leads to, must not be replaced by a file."""
    if target.exists() and not target.is_file():
        raise OutputError(Fault(str(path), Message("files.not-a-file")))
    if target.exists() and not force:
        raise OutputError(Fault(str(path), Message("files.file-exists")))


def _list_names(folder: Path, contents: Collection[str]) -> Iterator[str]:
    """The names at the top of a folder; in place of a folder there, of which contents are paths
    below it, the paths of what it holds.
    """
    inner = {path.parts[0] for path in map(PurePosixPath, contents) if len(path.parts) > 1}
    for entry in _list_entries(folder):
        if entry.name in inner and entry.is_dir():
            yield from (f"{entry.name}/{each.name}" for each in _list_entries(entry))
        else:
            yield entry.name


def _list_entries(folder: Path) -> Iterator[Path]:
    return (entry for entry in folder.iterdir() if entry.name not in DESKTOP_DROPPINGS)
