"""`kinegrade verify`: whether an archive, or an exam folder, is whole and its key still follows."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path, PurePosixPath

from kinegrade.errors import ExamError, KinegradeError, Problem
from kinegrade.exam.archiving.archive import CHECKSUMS, EXAM, MARKS, read_checksums
from kinegrade.exam.archiving.changed_pages import solve_again
from kinegrade.exam.archiving.other_hands import find_changed_keys, find_copied_papers
from kinegrade.exam.archiving.unpacked import name_inside
from kinegrade.exam.folder.exam_folder import ExamFolder, open_exam
from kinegrade.exam.generating.hand_work import digest_editable
from kinegrade.files.temporary import temporary_folder
from kinegrade.language.message import Fault, Message
from kinegrade.marks_folder import folder as marks_folder

_SAMPLE = 20  # papers that are solved again unless all are wanted
_MOST_BYTES = 4 * 10**9  # of an archive that is unpacked: ten thousand papers
_MOST_FILES = 100_000


@dataclass(frozen=True)
class Verified:
    """How many files were compared, how many of the papers were solved again, and what is wrong."""

    files: int
    solved: int
    papers: int
    problems: tuple[Problem, ...]


def verify(path: Path, *, everything: bool) -> Verified:
    """Whether the archive or the exam folder at `path` is whole; of its key a sample of papers is
    solved again, or everything.

    Raises ExamError where it is neither.
    """
    if path.is_dir():
        return _verify_folder(path, _find_edited(open_exam(path)), 0, everything=everything)
    with _unpack(path) as folder:
        files = _read_sums(folder)
        wrong: tuple[Problem, ...] = tuple(_compare(folder, files))
        if (folder / MARKS).is_dir():
            wrong += _check_marks(folder / MARKS)
        found = _verify_folder(folder / EXAM, wrong, len(files), everything=everything)
        named = tuple(name_inside(problem, folder) for problem in found.problems)
        return replace(found, problems=named)


def _verify_folder(
    path: Path, wrong: tuple[Problem, ...], files: int, *, everything: bool
) -> Verified:
    try:
        exam = open_exam(path)
        exam.require_sound_key()
        papers = exam.head.everybody
        copied, changed = tuple(find_copied_papers(exam)), tuple(find_changed_keys(exam))
        missing = *_find_missing(exam), *copied, *changed
        sample = papers if everything else papers[:: max(1, len(papers) // _SAMPLE)]
        contradictions = tuple(solve_again(exam, sample, frozenset(each.where for each in copied)))
    except KinegradeError as error:
        return Verified(files, 0, 0, (*wrong, *error.faults))
    return Verified(files, len(sample), len(papers), (*wrong, *missing, *contradictions))


def _find_missing(exam: ExamFolder) -> Iterator[Fault]:
    """The papers that are not in the folder, and should be."""
    if exam.head.forgotten or exam.head.unprinted:
        return
    for candidate in exam.head.everybody:
        if not (exam.path / candidate.file).is_file():
            yield Fault(str(exam.path / candidate.file), Message("archive.missing"))


def _find_edited(exam: ExamFolder) -> tuple[Fault, ...]:
    """The files that people edit and that are no longer as they were generated."""
    found = digest_editable(exam.path)
    stated: Mapping[str, str] = exam.head.editable or {}
    return tuple(
        Fault(str(exam.path / name), Message("archive.edited"))
        for name, digest in stated.items()
        if found.get(name) != digest and not name.endswith(".xlsx")
    )


def _check_marks(folder: Path) -> tuple[Problem, ...]:
    try:
        marks_folder.open_marks(folder)
    except KinegradeError as error:
        return error.faults
    return ()


@contextmanager
def _unpack(path: Path) -> Iterator[Path]:
    """The files of an archive, in a folder that is removed afterwards. Raises ExamError."""
    with temporary_folder() as folder:
        try:
            with zipfile.ZipFile(path) as archive:
                _require_harmless(path, archive)
                archive.extractall(folder)
        except (OSError, zipfile.BadZipFile, NotImplementedError, RuntimeError) as fault:
            what = Message("archive.unreadable", reason=str(fault))
            raise ExamError(Fault(str(path), what, Message("archive.an-archive"))) from fault
        yield folder


def _require_harmless(path: Path, archive: zipfile.ZipFile) -> None:
    """Raises ExamError for names that lead out of the archive, and for too much of it."""
    entries = archive.infolist()
    size = sum(entry.file_size for entry in entries)
    strange = any(not _is_inside(entry.filename) for entry in entries)
    if strange or size > _MOST_BYTES or len(entries) > _MOST_FILES:
        raise ExamError(Fault(str(path), Message("archive.strange"), Message("archive.an-archive")))


def _is_inside(name: str) -> bool:
    parts = PurePosixPath(name).parts
    return bool(parts) and parts[0] in (EXAM, MARKS, CHECKSUMS) and ".." not in parts


def _read_sums(folder: Path) -> dict[str, str]:
    """The checksums that an archive states. Raises ExamError where it states none."""
    file = folder / CHECKSUMS
    if not file.is_file():
        what = Message("archive.no-checksums", file=CHECKSUMS)
        raise ExamError(Fault("", what, Message("archive.an-archive")))
    return read_checksums(file.read_text(encoding="utf-8", errors="replace"))


def _compare(folder: Path, sums: Mapping[str, str]) -> Iterator[Fault]:
    """The files that are missing, changed or added."""
    found = {
        file.relative_to(folder).as_posix(): file for file in folder.rglob("*") if file.is_file()
    }
    for name, checksum in sums.items():
        if name not in found:
            yield Fault(name, Message("archive.missing"))
        elif sha256(found[name].read_bytes()).hexdigest() != checksum:
            yield Fault(name, Message("archive.changed"))
    for name in found.keys() - sums.keys() - {CHECKSUMS}:
        yield Fault(name, Message("archive.added"))
