"""`kinegrade papers`: what students may have of an exam folder, copied to a place they can read."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import chain, islice
from pathlib import Path, PurePosixPath

from kinegrade.errors import ExamError, OutputError
from kinegrade.exam.folder.contents import HEAD, PAPERS
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.faults import explain_broken
from kinegrade.exam.roster.spare_papers import name_spares
from kinegrade.exam.roster.students import read_place
from kinegrade.files.csv_writing import neutralise, write_for_people
from kinegrade.files.output import output_file, output_folder
from kinegrade.files.placing.previous import Previous
from kinegrade.language.message import Fault, Message, Quoted

SEND_COLUMNS = ("student", "name", "email", "file")
# Every student has the first, and those who read by touch the last
KINDS = (".pdf", ".docx", ".html", ".tactile.zip")
_IN_PAPERS = re.compile(rf"{PAPERS}/([0-9]+/)?(?!\.\.?/)[^/\\]+{re.escape(KINDS[0])}")


@dataclass(frozen=True)
class HandedOut:
    """How many papers there are, those to spare among them, and which files hold these."""

    papers: int
    spare: tuple[str, ...]


def hand_out(exam: ExamFolder, output: Path, *, force: bool = False) -> HandedOut:
    """Copy every student's paper and the spare ones, in each kind of file that there is, and
    nothing else.

    With `force`, the contents of the folder `output` are replaced if they are papers of this exam
    and nothing else. Raises ExamError, OutputError; then nothing is written.
    """
    files = list_files(exam, output)
    places = *_list_places(exam), *_list_assigned(exam)
    names = [f"{place}{kind}" for place in places for kind in KINDS]
    with output_folder(output, marker=None, contents=names, force=force) as folder:
        for file in chain.from_iterable(files.values()):
            copy = folder / file.relative_to(exam.path / PAPERS)
            copy.parent.mkdir(exist_ok=True)
            copy.write_bytes(read_paper(file))
    spare = tuple(f"{read_place(each.file)}{KINDS[0]}" for each in exam.head.spares)
    return HandedOut(len(files), spare)


def list_files(exam: ExamFolder, output: Path) -> Mapping[str, Sequence[Path]]:
    """The files of everybody's paper, by id, those of spare ones by their names, of every kind
    that there is, which are to go to `output`. A PDF that is missing is noticed when it is read.

    Raises ExamError where papers are not printed, or not where papers are; OutputError.
    """
    _require_outside(exam.path, output)
    _require_printed(exam)
    owners = [each.student for each in exam.head.everybody]
    found = (tuple(_list_kinds(exam.path / PAPERS, place)) for place in _list_places(exam))
    return dict(zip(owners, found, strict=True))


@contextmanager
def send_list(
    exam: ExamFolder,
    folder: Path,
    files: Mapping[str, Path],
    target: Path,
    *,
    force: bool = False,
) -> Iterator[int]:
    """A table for mail merges, which takes its place when the block ends: who gets which of the
    `files` that the block writes into a folder, by student, each by its whole path. Gives how many
    have an address.

    Raises OutputError, also where it would lie among the files, which others may see.
    """
    if folder.resolve() in target.resolve().parents:
        what = Message("exam.list-among-papers", folder=str(folder))
        raise OutputError(Fault(str(target), what, do=Message("exam.list-elsewhere")))
    listed = [each for each in exam.head.students if each.student in files]
    rows = [
        [
            neutralise(each.student),
            neutralise(each.name),
            neutralise(each.email),
            str(files[each.student].resolve()),
        ]
        for each in listed
    ]
    with output_file(target, force=force, previous=Previous.ALL) as partial:
        write_for_people(partial, SEND_COLUMNS, rows)
        yield sum(bool(each.email) for each in listed)


def list_papers(exam: ExamFolder, papers: Path) -> dict[str, Path]:
    """Where `hand_out` puts everybody's paper, by student."""
    return {
        each.student: papers / f"{read_place(each.file)}{KINDS[0]}" for each in exam.head.students
    }


def _require_outside(exam: Path, output: Path) -> None:
    """Raises OutputError where `output` is the exam folder, or lies in it or around it."""
    inner, outer = output.resolve(), exam.resolve()
    if outer == inner or outer in inner.parents or inner in outer.parents:
        raise OutputError(Fault(str(output), Message("exam.output-in-exam", exam=str(exam))))


def _require_printed(exam: ExamFolder) -> None:
    """Raises ExamError where papers are printed only when they are asked for."""
    if exam.head.unprinted:
        expected, do = Message("exam.printed-papers"), Message("exam.print-on-demand")
        raise ExamError(Fault(str(exam.path), Message("exam.unprinted"), expected, do))


def _list_places(exam: ExamFolder) -> list[str]:
    """The place of every paper. Raises ExamError if a paper is not where the others are."""
    for candidate in exam.head.everybody:
        if not _IN_PAPERS.fullmatch(candidate.file):
            paper = Quoted(candidate.file)
            what = Message("exam.strange-paper", paper=paper, kind=KINDS[0], folder=PAPERS)
            raise explain_broken(exam.path / HEAD, [what])
    return [read_place(candidate.file) for candidate in exam.head.everybody]


def _list_assigned(exam: ExamFolder) -> list[str]:
    """Where papers may have been copied while they were spare that are those of students now."""
    assigned = [each for each in exam.head.students if each.was_spare]
    made = len(assigned) + len(exam.head.spares)
    folders = {PurePosixPath(read_place(each.file)).parent for each in assigned}
    return [str(each / name) for each in folders for name in islice(name_spares(), made)]


def _list_kinds(papers: Path, place: str) -> Iterator[Path]:
    for kind in KINDS:
        file = papers / f"{place}{kind}"
        if kind == KINDS[0] or file.is_file():
            yield file


def read_paper(file: Path) -> bytes:
    """The bytes of a paper. Raises ExamError."""
    if file.is_symlink():
        raise ExamError(Fault(str(file), Message("exam.paper-is-link")))
    try:
        return file.read_bytes()
    except OSError as fault:
        what = Message("exam.paper-unreadable", reason=str(fault.strerror))
        raise ExamError(Fault(str(file), what)) from fault
