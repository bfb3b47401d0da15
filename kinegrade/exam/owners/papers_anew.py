"""Papers of an exam folder that change hands: their keys, and all that is printed of them, anew."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from msgspec import structs

from kinegrade.exam.folder.contents import KEY, POOL, SPARES
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.key.lines import KeyLine
from kinegrade.exam.folder.records import Candidate
from kinegrade.exam.folder.writing import encode_line
from kinegrade.exam.generating.key_books import list_spare_ids, write_key_books, write_spare_key
from kinegrade.exam.printing.key_pages import make_kept_keys
from kinegrade.exam.printing.printed_files import collect_files, replace_papers, write_solutions
from kinegrade.exam.printing.printing import print_papers
from kinegrade.exam.printing.reprint import find_printed, kept_run
from kinegrade.exam.roster.students import read_place
from kinegrade.exam.setting.kept_exam import KeptExam


def replace_lines(exam: ExamFolder, folder: Path, changed: Mapping[str, KeyLine]) -> None:
    """Write the keys of the exam into a copy of its folder, those of these ids changed.

    Raises ExamError where a line is damaged.
    """
    with (folder / KEY).open("wb") as lines:
        for number, text in exam.keys.texts():
            line = changed.get(exam.keys.read_line(number, text).student)
            lines.write(_end(text) if line is None else encode_line(line))
    if exam.keys.has_pool:
        _rename_variants(exam, folder, changed)
    if exam.keys.spare_file.exists():
        spares = (changed.get(each.student, each) for each in exam.keys.spare_lines())
        (folder / SPARES).write_bytes(b"".join(map(encode_line, spares)))


def _rename_variants(exam: ExamFolder, folder: Path, changed: Mapping[str, KeyLine]) -> None:
    """Write the lines of a pool into a copy of the folder, under the ids of now."""
    variants = dict(
        zip((text for _, text in exam.keys.pool_texts()), exam.keys.pool_lines(), strict=True)
    )
    with (folder / POOL).open("wb") as lines:
        for text, line in variants.items():
            after = changed.get(line.student)
            renamed = after and structs.replace(line, student=after.student)
            lines.write(encode_line(renamed) if renamed else text)


def print_anew(exam: ExamFolder, owners: Sequence[Candidate]) -> None:
    """Print the papers of these, and their worked solutions, in every kind of file that the folder
    has of them, bind all in one file again, and print the instructor's key.

    Raises ExamError where something else follows from the folder than its key says, BankError,
    TypesetError.
    """
    kept = KeptExam(exam)
    run = kept_run(exam, kept, **find_printed(exam))
    papers = [kept.paper(each) for each in owners]
    printed = print_papers(run, run.press_order.press(), papers)
    for paper, each in zip(papers, printed, strict=True):
        _replace_files(exam.path, collect_files(paper.student.file_name, each))
    places = [read_place(each.file) for each in exam.head.everybody]
    if run.extras.solutions:
        write_solutions(exam.path, (), places)
    if not run.extras.papers:
        return
    replace_papers(exam.path, (), places)
    spare = list_spare_ids(exam.head)
    if all(each.student in spare for each in owners):
        apart = (each for each in exam.head.everybody if each.student in spare)
        write_spare_key(exam.path, run, make_kept_keys(kept, apart))
    else:
        write_key_books(exam.path, run, make_kept_keys(kept, exam.head.everybody), spare)


def _end(text: bytes) -> bytes:
    """A line with its end, which the last one may lack."""
    return text if text.endswith(b"\n") else text + b"\n"


def _replace_files(folder: Path, files: Mapping[str, bytes]) -> None:
    """Files over those of the same names: worked solutions may be printed for some alone."""
    for name, content in files.items():
        if (folder / name).exists():
            (folder / name).write_bytes(content)
