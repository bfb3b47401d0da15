"""`kinegrade papers --by-group`: the papers of each group of the roster in one file, and the spare
ones in another, as PDF to be printed or as ZIP to be passed on.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Literal, assert_never

from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.handing_out.handout import KINDS, HandedOut, list_files, read_paper
from kinegrade.exam.roster.volume_names import name_volumes
from kinegrade.files.output import output_folder
from kinegrade.files.zip_package import open_package
from kinegrade.language.message import Fault, Message
from kinegrade.press.join import open_volume

Bundle = Literal["pdf", "zip"]
_NONE = "without-group"  # the file of students of whom no group is known


def hand_out_groups(
    exam: ExamFolder, output: Path, kind: Bundle, *, force: bool = False
) -> HandedOut:
    """Write a file for each group, and nothing else: its papers in the order of the roster; and one
    of the spare papers. A PDF begins each on a new sheet; a ZIP has every kind of file that there
    is.

    With `force`, the contents of the folder `output` are replaced if they are such files of this
    exam and nothing else. Raises ExamError, also where nobody has a group, OutputError; then
    nothing is written.
    """
    files = list_files(exam, output)
    groups, spares = _gather(exam.head.students), exam.head.spares
    if not any(groups):
        what, do = Message("exam.no-groups"), Message("exam.hand-out-singly")
        raise ExamError(Fault(str(exam.head_file), what, Message("exam.roster-with-groups"), do))
    names = name_volumes(groups, _NONE)
    spare = f"{names.spare}.{kind}"
    contents = [*(f"{stem}.{kind}" for stem in names.stems.values()), spare]
    with output_folder(output, marker=None, contents=contents, force=force) as folder:
        for group, inside in groups.items():
            _write(folder / f"{names.stems[group]}.{kind}", _list_all(files, inside), kind)
        if spares:
            _write(folder / spare, _list_all(files, spares), kind)
    return HandedOut(len(files), (spare,) if spares else ())


def _list_all(files: Mapping[str, Sequence[Path]], owners: Iterable[Candidate]) -> list[Path]:
    """The files of all of them, one after another."""
    return [file for each in owners for file in files[each.student]]


def _gather(students: Iterable[Candidate]) -> Mapping[str, Sequence[Candidate]]:
    """The students of each group, "" for none."""
    groups: dict[str, list[Candidate]] = {}
    for student in students:
        groups.setdefault(student.group, []).append(student)
    return groups


def _write(target: Path, papers: Sequence[Path], kind: Bundle) -> None:
    match kind:
        case "pdf":
            with open_volume(target, duplex=True) as append:
                for paper in papers:
                    if paper.suffix == KINDS[0]:
                        append(read_paper(paper))
        case "zip":
            with open_package(target, force=False) as package:
                for paper in papers:
                    package.add(paper.name, read_paper(paper))
        case _:
            assert_never(kind)
