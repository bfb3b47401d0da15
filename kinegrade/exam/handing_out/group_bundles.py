"""`kinegrade papers --by-group`: the papers of each group of the roster in one file, as PDF to be
printed or as ZIP to be passed on.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Literal, assert_never

from kinegrade.errors import ExamError
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.handing_out.handout import KINDS, list_files, read_paper
from kinegrade.exam.roster.students import make_room_stems
from kinegrade.files.output import output_folder
from kinegrade.files.zip_package import open_package
from kinegrade.language.message import Fault, Message
from kinegrade.press.join import open_volume

Bundle = Literal["pdf", "zip"]
_NONE = "without-group"  # the file of students of whom no group is known


def hand_out_groups(exam: ExamFolder, output: Path, kind: Bundle, *, force: bool = False) -> int:
    """Write a file for each group, and nothing else: its papers in the order of the roster. A PDF
    begins each on a new sheet; a ZIP has every kind of file that there is. Gives the number of
    papers.

    With `force`, the contents of the folder `output` are replaced if they are such files of this
    exam and nothing else. Raises ExamError, also where nobody has a group, OutputError; then
    nothing is written.
    """
    files = list_files(exam, output)
    groups = _gather(exam.head.students)
    if not any(groups):
        what, do = Message("exam.no-groups"), Message("exam.hand-out-singly")
        raise ExamError(Fault(str(exam.head_file), what, Message("exam.roster-with-groups"), do))
    stems = _name_files(groups)
    with output_folder(
        output, marker=None, contents=[f"{stem}.{kind}" for stem in stems.values()], force=force
    ) as folder:
        for group, inside in groups.items():
            papers = [file for each in inside for file in files[each.student]]
            _write(folder / f"{stems[group]}.{kind}", papers, kind)
    return len(files)


def _gather(students: Iterable[Candidate]) -> Mapping[str, Sequence[Candidate]]:
    """The students of each group, "" for none."""
    groups: dict[str, list[Candidate]] = {}
    for student in students:
        groups.setdefault(student.group, []).append(student)
    return groups


def _name_files(groups: Iterable[str]) -> Mapping[str, str]:
    """The stem of each group's file."""
    named = [group for group in groups if group]
    stems = make_room_stems([*named, _NONE])
    return {**{group: stems[group] for group in named}, "": stems[_NONE]}


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
