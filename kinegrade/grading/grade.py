"""From an exam folder and an answer sheet to a folder of marks: the whole of `kinegrade grade`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import assert_never

from kinegrade.answer_file import AnswerFile
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.files import output_folder
from kinegrade.garbage_collection import bulk_work
from kinegrade.grading.accepted import alternatives
from kinegrade.grading.class_sheet import class_sheet
from kinegrade.grading.decimal_style import Mark as DecimalMark
from kinegrade.grading.follow import Follows
from kinegrade.grading.kept_totals import Kept
from kinegrade.grading.kept_totals import never_lower as with_kept_totals
from kinegrade.grading.marks import ClassGrades, class_grades, marked_blocks
from kinegrade.grading.marks_folder import KEPT, read_totals
from kinegrade.grading.other_papers import OtherPapers
from kinegrade.grading.policy import Policy
from kinegrade.grading.policy_reading import read_policy, stated_policy
from kinegrade.grading.pool import VARIANTS, pool_of
from kinegrade.grading.report import POLICY, write_grades, write_marks
from kinegrade.printed_order import PRINTED, write_printed
from kinegrade.tables import Table, read_table

MARKER = "complaints.csv"
FILES = ("marks.csv", "grades.csv", "complaints.csv", POLICY, KEPT, VARIANTS, PRINTED)
Export = Callable[[Path], str]  # a folder with these files -> the text of one more
_NO_EXPORTS: Mapping[str, Export] = MappingProxyType({})


def grade(
    exam: ExamFolder,
    answers: Path | Table | Sequence[AnswerFile],
    output: Path,
    *,
    force: bool = False,
    exports: Mapping[str, Export] = _NO_EXPORTS,
    decimal: DecimalMark | None = None,
    policy: Path | None = None,
    never_lower: Path | None = None,
    follows: Follows | None = None,
    own_papers: bool = False,
) -> ClassGrades:
    """Writes the folder `output`, whole or not at all, and gives all grades and complaints.

    `answers` is an answer sheet, as a file or a table, or the files of one class as
    `kinegrade.lms.responses` reads them. `exports` names the files for other systems that go into
    the folder too, such as `{"moodle.csv": kinegrade.lms.moodle.export}`. `decimal` declares the
    decimal mark of the sheet. `policy` is the file of a policy, of which the folder gets a copy;
    `never_lower` an earlier folder of marks below whose totals nobody falls; `follows` works out
    what follows from wrong answers. A marking in which most answers fit other papers is refused,
    unless they are said to be to `own_papers`. Raises ExamError, PolicyError, TableError,
    OutputError.
    """
    written = output_folder(output, marker=MARKER, contents=(*FILES, *exports), force=force)
    with bulk_work(), written as folder:
        files = _files(answers)
        sheet, rules = class_sheet(files, exam), _policy_for(exam, policy)
        pool, others = pool_of(exam, sheet), OtherPapers(exam.asks)
        accepted = alternatives(exam, rules, exam, pool.put_together(exam, sheet), pool.papers)
        blocks = marked_blocks(exam, sheet, decimal, rules, accepted, follows=follows, pool=pool)
        grades = class_grades(exam, sheet, write_marks(folder, others.watched(blocks)))
        if not own_papers:
            others.refuse(exam, ", ".join(each.table.file for each in files))
        grades, kept = _with_kept_totals(grades, never_lower)
        write_grades(folder, grades, rules, kept)
        write_printed(folder, exam.printed_orders())
        _write_exports(folder, exports)
    return grades


def _with_kept_totals(
    grades: ClassGrades, never_lower: Path | None
) -> tuple[ClassGrades, tuple[Kept, ...] | None]:
    """The grades with the earlier totals that stand, and those; without an earlier folder as is."""
    if never_lower is None:
        return grades, None
    return with_kept_totals(grades, read_totals(never_lower))


def _write_exports(folder: Path, exports: Mapping[str, Export]) -> None:
    """Files for other systems, made of what stands in the folder."""
    for name, export in exports.items():
        (folder / name).write_text(export(folder), encoding="utf-8", newline="")


def _files(answers: Path | Table | Sequence[AnswerFile]) -> Sequence[AnswerFile]:
    match answers:
        case Path():
            return [AnswerFile(read_table(answers))]
        case Table():
            return [AnswerFile(answers)]
        case Sequence():
            return answers
        case _:
            assert_never(answers)


def _policy_for(exam: ExamFolder, policy: Path | None) -> Policy:
    """The policy of that file, or what the bank states where there is none. Raises PolicyError."""
    return stated_policy(exam) if policy is None else read_policy(policy, exam)
