"""`kinegrade archive`: an exam folder in one file, with a checksum of each of its files."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files.placing.droppings import DESKTOP_DROPPINGS
from kinegrade.files.zip_package import open_package
from kinegrade.language.message import Fault, Message

EXAM = "EXAM"
MARKS = "MARKS"
#: As `sha256sum` writes them: `sha256sum -c CHECKSUMS.txt` compares them.
CHECKSUMS = "CHECKSUMS.txt"
PRIVATE = 0o600  # it gives the key away


@dataclass(frozen=True)
class Archived:
    """How many files an archive holds, and the checksum of the archive itself."""

    files: int
    checksum: str


def write_archive(
    exam: ExamFolder, marks: Path | None, target: Path, *, force: bool = False
) -> Archived:
    """All of an exam folder, and of a marks folder where one is given, in a zip at `target`, whose
    bytes depend on nothing but these.

    Raises ExamError where a file is a link, OutputError.
    """
    files = dict(_list_files(exam.path, EXAM))
    if marks is not None:
        files |= _list_files(marks, MARKS)
    sums: dict[str, str] = {}
    with open_package(target, force=force, mode=PRIVATE) as package:
        for name, file in sorted(files.items()):
            content = file.read_bytes()
            sums[name] = sha256(content).hexdigest()
            package.add(name, content)
        package.add(CHECKSUMS, write_checksums(sums).encode())
    target.chmod(PRIVATE)
    return Archived(len(sums), sha256(target.read_bytes()).hexdigest())


def write_checksums(sums: Mapping[str, str]) -> str:
    """The lines of checksums by file name.

    >>> write_checksums({"EXAM/key.jsonl": "0a"})
    '0a  EXAM/key.jsonl\\n'
    """
    return "".join(f"{checksum}  {name}\n" for name, checksum in sums.items())


def read_checksums(text: str) -> dict[str, str]:
    """The checksums by file name; lines of another form are no checksums.

    >>> read_checksums("0a  EXAM/key.jsonl\\n\\n")
    {'EXAM/key.jsonl': '0a'}
    """
    pairs = (line.split("  ", 1) for line in text.splitlines() if "  " in line)
    return {name: checksum for checksum, name in pairs}


def _list_files(folder: Path, name: str) -> Iterator[tuple[str, Path]]:
    """Each file of a folder, by its name in the archive."""
    for file in folder.rglob("*"):
        if file.is_symlink():
            what, do = Message("archive.is-link"), Message("archive.copy-instead")
            raise ExamError(Fault(str(file), what, do=do))
        if file.is_file() and file.name not in DESKTOP_DROPPINGS:
            yield f"{name}/{file.relative_to(folder).as_posix()}", file
