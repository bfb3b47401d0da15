"""`kinegrade reprint`: a template's text is corrected after papers were generated, and the numbers
stay.

The corrected template takes the place of the folder's copy, everything is worked out from the
values that the folder keeps and compared with its key, and the papers are printed again.
"""

from __future__ import annotations

import shutil
from collections.abc import Callable, Generator
from contextlib import closing
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from msgspec import structs

from kinegrade.errors import ExamError, Problem, suggest
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.folder.contents import KEY, SPARES, TEMPLATES
from kinegrade.exam.folder.exam_folder import ExamFolder
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.folder.writing import encode_line
from kinegrade.exam.generating.exam_files import (
    source_files,
    translation_files,
    write_head,
    write_papers,
    write_sources,
)
from kinegrade.exam.generating.growing.grown_folder import (
    copy_exam,
    digest_grown,
    open_grown_folder,
)
from kinegrade.exam.generating.hand_work import digest_editable, find_edited, refuse_edited
from kinegrade.exam.generating.key_books import list_spare_ids
from kinegrade.exam.generating.options import Progress
from kinegrade.exam.printing.class_printing import count_processes
from kinegrade.exam.printing.class_reprint import print_class_again
from kinegrade.exam.printing.head_record import make_ask
from kinegrade.exam.printing.printing import Printed, PrintRun
from kinegrade.exam.printing.reprint import find_printed, kept_run
from kinegrade.exam.printing.room_booklets import write_room_booklets
from kinegrade.exam.roster.students import Student
from kinegrade.exam.roster.usual_pages import count_usual, find_most_pages
from kinegrade.exam.setting.kept_exam import KeptExam, student_of
from kinegrade.exam.setting.key_mistakes import find_mistaken_answers
from kinegrade.exam.setting.key_record import make_key_line
from kinegrade.exam.setting.setting import SetPaper
from kinegrade.language import Language
from kinegrade.language.known import known_languages
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.problem.statement_faults import check_statements
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.template import Template
from kinegrade.problem.template.texts import require_language
from kinegrade.processes.executor import open_executor
from kinegrade.processes.garbage_collection import bulk_work

_NAMED = 10  # changes that a refusal names
_Printer = Callable[[PrintRun], Generator[Printed, None, None]]


@dataclass(frozen=True)
class CorrectionWishes:
    """`accept` lets answers, givens and points change; papers are printed by up to `jobs`
    processes, and `progress` is given them one after another, and their number.
    """

    accept: bool
    jobs: int
    progress: Progress


@dataclass(frozen=True)
class Corrected:
    """How many papers were printed again, and what changed on them for whom."""

    papers: int
    changes: tuple[Problem, ...]


def correct_template(exam: ExamFolder, file: Path, wishes: CorrectionWishes) -> Corrected:
    """Put the template of that file into the exam in place of the one of its name, and print all
    papers again, as they were printed.

    Raises ExamError where the exam has no template of that name, or where an answer, a given or
    points would change that may not; TemplateError, OutputError; then nothing is written.
    """
    template = _read_correction(exam, file)
    jobs = count_processes(wishes.jobs, len(exam.students))
    with bulk_work(), open_grown_folder(exam) as folder, open_executor(jobs, "reprint") as workers:
        copy_exam(exam, folder)
        _write_template(template, exam, folder)
        changes = _settle_changes(exam, KeptExam(replace(exam, path=folder)), accept=wishes.accept)
        kept = KeptExam(replace(exam, path=folder))
        run = kept_run(exam, kept, **find_printed(exam))
        print_again = partial(print_class_again, kept, workers=workers, jobs=jobs)
        pages = _print_alike(exam, run, wishes.progress, print_again, folder)
        head = _restate(exam.head, kept.bank)
        corrections = head.corrections + bool(changes)
        given = _note_given(exam, folder)
        head = structs.replace(head, pages=pages, corrections=corrections, given=given)
        _write_head(exam, head, template, folder)
    return Corrected(len(exam.students), changes)


def _read_correction(exam: ExamFolder, file: Path) -> Template:
    """The template of a file, which corrects one of the exam. Raises TemplateError, ExamError."""
    template = load_template(str(file), steps=_has_steps(exam, file.stem))
    known = [each.template for each in exam.head.questions]
    if template.name not in known:
        what = Message("exam.no-template", template=Quoted(template.name), exam=str(exam.path))
        do = suggest(template.name, known)
        raise ExamError(Fault(str(file), what, Message("exam.name-as-generated"), do))
    check_statements(template)
    for language in {exam.language, *(each.language for each in exam.head.students)} - {""}:
        require_language([template], Language(language))
    return template


def _has_steps(exam: ExamFolder, name: str) -> bool:
    """Whether an exam has a question of that name with steps, whose file only exams have."""
    kept = exam.templates.readable.values()
    return any(each.name == name and not each.scheme.has_mechanism for each in kept)


def _write_template(template: Template, exam: ExamFolder, folder: Path) -> None:
    """The template's files in place of those of its name, its translations too."""
    bank = KeptExam(exam).bank
    (question, *_) = (each for each in bank.questions if each.template.name == template.name)
    corrected = structs.replace(bank, questions=(structs.replace(question, template=template),))
    templates = folder / TEMPLATES
    for stale in (*templates.glob(f"{template.name}.*.toml"), templates / f"{template.name}.toml"):
        stale.unlink(missing_ok=True)
    sources = source_files(corrected) | translation_files(corrected, known_languages())
    write_sources(sources, folder)


def _note_given(exam: ExamFolder, folder: Path) -> dict[str, str]:
    """A digest of each source that is corrected, as it was given: the folder's copy may have been
    corrected in place, and may have been corrected before.
    """
    fresh, stated = digest_editable(folder), exam.head.editable or {}
    before = {**digest_editable(exam.path), **stated}
    sources = (name for name in before if name.startswith(f"{TEMPLATES}/"))
    corrected = {name: before[name] for name in sources if before[name] != fresh.get(name)}
    return {**corrected, **exam.head.given}


def _settle_changes(exam: ExamFolder, kept: KeptExam, *, accept: bool) -> tuple[Problem, ...]:
    """What changes for whom; where that is accepted, the key states it from now on.

    Raises ExamError where it is not, and where nothing follows from the values any more.
    """
    reworked = [kept.rework(candidate) for candidate in kept.exam.head.everybody]
    changes = tuple(each for _, differences in reworked for each in differences)
    if changes and not accept:
        more = [Message("exam.more-changes", count=len(changes) - _NAMED)]
        refusal = Fault(
            str(exam.keys.file), Message("exam.would-change"), do=Message("exam.accept")
        )
        raise ExamError(*changes[:_NAMED], *(more if len(changes) > _NAMED else ()), refusal)
    if not changes:
        return ()
    _write_key(kept, [paper for paper, _ in reworked])
    old = Fault(str(exam.path), Message("exam.marks-before"), do=Message("exam.mark-again"))
    return (*changes, old)


def _write_key(kept: KeptExam, papers: list[SetPaper]) -> None:
    """The key of the students, and that of the spare papers."""
    lines = [
        encode_line(make_key_line(paper, mistakes, ordered=kept.bank.states_orders))
        for paper, mistakes in zip(papers, find_mistaken_answers(papers), strict=True)
    ]
    students = len(kept.exam.head.students)
    kept.exam.keys.file.write_bytes(b"".join(lines[:students]))
    if lines[students:]:
        kept.exam.keys.spare_file.write_bytes(b"".join(lines[students:]))


def _print_alike(
    exam: ExamFolder, run: PrintRun, progress: Progress, print_again: _Printer, folder: Path
) -> int:
    """Print all papers over those of the folder, and give the number of pages that each has: that
    of the longest, or as many as before where nobody reads large print.
    """
    keys = {
        name: (folder / name).read_bytes() for name in (KEY, SPARES) if (folder / name).exists()
    }
    students = _list_students(exam.head)
    # Earlier versions made all papers as long as one in large print
    distrusted = any(student.reads_large_print for student in students)
    first = structs.replace(run, pages=None if distrusted else run.pages)
    pages = _print_once(exam, first, progress, print_again, folder)
    most = find_most_pages(students, pages)
    if any(count < most for _, count in count_usual(students, pages)):
        alike = structs.replace(run, pages=most)
        _print_once(exam, alike, progress, print_again, folder)
    write_room_booklets(folder, exam.head)
    for name, lines in keys.items():  # as they were: another version might write other mistakes
        (folder / name).write_bytes(lines)
    return most


def _print_once(
    exam: ExamFolder, run: PrintRun, progress: Progress, print_again: _Printer, folder: Path
) -> tuple[int, ...]:
    for name in run.extras.folders:
        shutil.rmtree(folder / name)
        (folder / f"{name}.pdf").unlink(missing_ok=True)
    students, spare = _list_students(exam.head), list_spare_ids(exam.head)
    with closing(print_again(run)) as papers:
        shown = progress(papers, len(students))
        return write_papers(folder, run, students, shown, spare=spare).pages


def _list_students(head: ExamHead) -> tuple[Student, ...]:
    """Those of all papers, in the order in which they are printed."""
    return tuple(replace(student_of(each), spare=each in head.spares) for each in head.everybody)


def _restate(head: ExamHead, bank: Bank) -> ExamHead:
    """The head with the asks as the corrected templates state them."""
    asked = {each.identifier: each for each in bank.questions}
    questions = []
    for stated in head.questions:
        question = asked[stated.question]
        asks = tuple(make_ask(question, ask, head.language) for ask in question.asks)
        questions.append(structs.replace(stated, points=question.points, asks=asks))
    return structs.replace(head, questions=tuple(questions))


def _write_head(exam: ExamFolder, head: ExamHead, template: Template, folder: Path) -> None:
    """The head. Raises OutputError where a file would be lost that was edited by hand."""
    own = f"{TEMPLATES}/{template.name}."
    lost = [name for name in find_edited(exam.path, exam.head, folder) if not name.startswith(own)]
    if lost:
        raise refuse_edited(exam.path, lost)
    write_head(head, digest_grown(exam, folder), folder)
