"""Output that appears whole or not at all.

A folder (or a file) is built beside its place under a hidden name, flushed to disk, and put in
place in one atomic step. A process killed at any moment leaves the old output or the new one. Its
unfinished output stays behind as `.NAME.partial-HOST-PID-TOKEN`; the next run for the same target
on the same machine removes it, or goes on with it where it can.

A folder is replaced atomically by `renameat2(RENAME_EXCHANGE)` on Linux, `renamex_np(RENAME_SWAP)`
on macOS. Where the system or the file system has neither, two renames are made: a process killed
between the two leaves the old output whole beside its place, as `.NAME.previous-TOKEN`, which is
never deleted automatically.
"""

from __future__ import annotations

import errno
import os
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from kinegrade.errors import OutputError
from kinegrade.files.endings import Kind, is_filled_in, require_ending
from kinegrade.files.placing.leftovers import (
    clear_leftovers,
    leave,
    list_in_use,
    list_leftovers,
    make_process_name,
    remove,
)
from kinegrade.files.placing.previous import Previous, keep_previous
from kinegrade.files.placing.publishing import (
    check_file,
    check_folder,
    move_to_free_place,
    publish,
    sync_folder,
)
from kinegrade.files.placing.readings import forget_readings, require_readings
from kinegrade.files.placing.standing import find_standing
from kinegrade.files.temporary import clear_temporary_folders
from kinegrade.language.message import Fault, Message

_FULL = (errno.ENOSPC, errno.EDQUOT)


@dataclass(frozen=True)
class Access:
    """Who may read a folder: the modes of its folders and files, regardless of the umask of the
    process.

    The names at its top in `ordinary` keep the mode with which they were created; users who may not
    enter the folder cannot reach them.
    """

    folder: int
    file: int
    ordinary: Collection[str] = ()


@dataclass(frozen=True)
class Resumable:
    """A folder that another process may go on with: `workings` names the folder in it that says how
    far it is, and is no part of the output; `begun` is what a killed process left, None for a new
    folder. Where it `stays`, a process that ends early in another way leaves it, too.
    """

    workings: str
    begun: Path | None = None
    stays: bool = False


@contextmanager
def output_folder(
    path: Path,
    *,
    marker: str | None,
    contents: Collection[str] | None = None,
    force: bool = False,
    access: Access | None = None,
    resumable: Resumable | None = None,
) -> Iterator[Path]:
    """Gives a hidden folder to write into; it becomes `path` when the block ends without an error.

    `marker` is the file by which kinegrade recognises its own folders, None where they have none;
    `contents` are all that it writes: names at their top, or paths of files in folders there. With
    `force` an existing folder is replaced only if it is empty, or contains the marker and nothing
    beyond `contents`, so that no file of the user's is lost; and only if nothing changed in it
    during the block, so that what was read of it there holds. With `access` the folder is closed to
    all other users from the start; without it, the mode of a replaced folder is kept. Raises
    OutputError.
    """
    target = _find_place(path)
    with _open_partial(path, target, resumable) as partial:
        check_folder(path, target, marker, contents, force)
        stood = find_standing(target)
        if not partial.exists():
            partial.mkdir(mode=0o777 if access is None else 0o700)
        if target.exists() and access is None:
            partial.chmod(target.stat().st_mode | 0o700)
        yield partial
        if access is not None:
            _restrict(partial, access)
        _bring_to_disk(partial)
        # Another process may have written there in the meantime
        check_folder(path, target, marker, contents, force)
        if resumable:
            remove(partial / resumable.workings)
        publish(path, partial, target, stood)


def find_unfinished(path: Path, workings: str) -> Path | None:
    """What a killed process left of the folder `path`, the last where there is more; None where
    nothing can be gone on with. Raises OutputError where another process may be writing it.
    """
    target = _find_place(path)
    if not target.parent.is_dir():
        return None
    if used := list_in_use(target.parent, _make_beginning(target)):
        what = Message("files.being-written", name=used[0].name)
        expected, do = Message("files.one-process"), Message("files.wait-or-remove")
        raise OutputError(Fault(str(path), what, expected, do))
    left = list_leftovers(target.parent, _make_beginning(target))
    found = [each for each in left if (each / workings).is_dir()]
    return max(found, key=lambda each: (each / workings).stat().st_mtime_ns, default=None)


def write_file(path: Path, content: bytes, kind: Kind, *, force: bool = False) -> None:
    """Writes a file of that kind whole or not at all; with `force` over an existing plain file,
    which is kept beside it.

    Raises OutputError, too where the file's name is that of another kind.
    """
    require_ending(path, kind)
    previous = Previous.ALL if is_filled_in(kind) else Previous.LAST
    with output_file(path, force=force, previous=previous) as partial:
        partial.write_bytes(content)


@contextmanager
def output_file(
    path: Path, *, force: bool = False, previous: Previous = Previous.LAST
) -> Iterator[Path]:
    """Gives a hidden name for a file to write; it becomes `path` when the block ends without an
    error.

    With `force` an existing plain file is replaced, and kept beside it as `previous` says. Raises
    OutputError, before the block where `path` exists and must not be replaced.
    """
    target = _find_place(path)
    with _open_partial(path, target) as partial:
        check_file(path, target, force)
        yield partial
        _flush(partial)
        require_readings()
        if force:
            keep_previous(target, partial, previous)
            os.replace(partial, target)
        else:
            move_to_free_place(path, partial, target)
        sync_folder(target.parent)


def _find_place(path: Path) -> Path:
    try:
        target = path.resolve()
    except (OSError, RuntimeError) as fault:
        raise _explain_unwritable(path, fault) from fault
    if not target.name:
        raise OutputError(Fault(str(path), Message("files.root")))
    return target


def _explain_unwritable(path: Path, fault: Exception) -> OutputError:
    reason = Message("files.cannot-be-written", reason=str(fault))
    do = Message("files.choose-another")
    if isinstance(fault, OSError) and fault.errno in _FULL and path.exists():
        do = Message("files.make-room-there")  # what changes a folder in its place has no other
    return OutputError(Fault(str(path), reason, Message("files.place-with-room"), do))


@contextmanager
def _open_partial(path: Path, target: Path, resumable: Resumable | None = None) -> Iterator[Path]:
    """A hidden name beside `target`, which what was begun gets; whatever has this name at the end
    is removed, but for what another process may go on with.

    The leftovers of killed runs are removed first, including their temporary folders, which may
    contain the key.
    """
    partial = target.with_name(make_process_name(_make_beginning(target)))
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        if resumable and resumable.begun:
            resumable.begun.rename(partial)
        clear_leftovers(target.parent, _make_beginning(target))
        clear_temporary_folders()
        yield partial
    except OSError as fault:
        raise _explain_unwritable(path, fault) from fault
    finally:
        if resumable and resumable.stays and (partial / resumable.workings).is_dir():
            leave(partial, _make_beginning(target))
        forget_readings(partial)  # what was written is looked at where it was written
        remove(partial)


def _make_beginning(target: Path) -> str:
    return f".{target.name}.partial"


def _restrict(folder: Path, access: Access) -> None:
    """Give every folder and file its mode; ordinary ones keep theirs."""
    for entry in folder.iterdir():
        if entry.name in access.ordinary:
            continue
        if entry.is_dir():
            _restrict(entry, replace(access, ordinary=()))
        else:
            entry.chmod(access.file)
    folder.chmod(access.folder)


def _bring_to_disk(folder: Path) -> None:
    """Flushes every file and folder, so that they are whole even if the power fails after the
    renaming.
    """
    for place, _, names in os.walk(folder):
        for name in names:
            _flush(Path(place, name))
        sync_folder(Path(place))


def _flush(file: Path) -> None:
    handle = os.open(file, os.O_RDWR)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)
