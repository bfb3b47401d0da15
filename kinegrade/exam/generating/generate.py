"""`kinegrade generate`: the exam folder, written whole or not at all.

What students may see lies under `papers/` alone; everything else in the folder gives the key away
and says so.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, closing
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from kinegrade.errors import Problem, TableError
from kinegrade.exam.bank.blueprint import Bank, Blueprint
from kinegrade.exam.folder.contents import CONTENTS, HEAD
from kinegrade.exam.folder.exam_secret import ExamSecret
from kinegrade.exam.folder.records import ExamHead, KeyLine
from kinegrade.exam.generating.earlier_exams import (
    list_repeated,
    read_earlier_exams,
    require_enough,
)
from kinegrade.exam.generating.exam_files import (
    WrittenPapers,
    source_files,
    translation_files,
    write_blank_answers,
    write_blank_workbook,
    write_head,
    write_papers,
    write_sources,
)
from kinegrade.exam.generating.hand_work import digest_editable
from kinegrade.exam.generating.options import GenerateOptions
from kinegrade.exam.generating.page_counts import Printer, fill_up_papers
from kinegrade.exam.generating.replaced_exam import (
    PaperChanges,
    ReplacedExam,
    replaced_exam,
    settle,
)
from kinegrade.exam.printing.class_printing import count_processes, print_class
from kinegrade.exam.printing.head_record import candidate, make_exam_head
from kinegrade.exam.printing.paper_languages import require_languages
from kinegrade.exam.printing.printing import Extras, PrintRun, require_tools
from kinegrade.exam.printing.room_booklets import write_room_booklets
from kinegrade.exam.roster.complaints import roster_complaints
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.spare_papers import add_spare_papers
from kinegrade.exam.setting.dealing import ClassDeal, deal_exam
from kinegrade.exam.setting.kept_exam import student_of
from kinegrade.figure.sketchbook import open_sketchbook
from kinegrade.files.output import Access, output_folder
from kinegrade.language import Language
from kinegrade.language.known import known_languages
from kinegrade.language.message import Fault, Message
from kinegrade.press.protocol import Press
from kinegrade.processes.executor import open_executor
from kinegrade.processes.garbage_collection import bulk_work


@dataclass(frozen=True)
class Generated:
    """What was written: how many papers, and `dealt` knows from how many combinations and why
    others were refused.

    `drawn` names the templates of the questions that the bank left to be drawn. Where a folder was
    replaced, `changes` tells what became of its papers and `remarks` of what else was in it.
    """

    dealt: ClassDeal
    drawn: dict[str, str]
    complaints: tuple[Problem, ...]
    changes: PaperChanges | None
    remarks: tuple[Message, ...]

    @property
    def papers(self) -> int:
        """How many there are."""
        return len(self.dealt.roster.students)


def generate(
    blueprint: Blueprint,
    roster: Roster,
    output: Path,
    language: Language,
    options: GenerateOptions,
    *,
    force: bool = False,
) -> Generated:
    """Write an exam folder at `output`, where `force` may replace one.

    Raises KinegradeError; then nothing is written.
    """
    wish, extras = options.wish, options.extras
    require_tools(extras)
    old = replaced_exam(output, new_numbers=wish.new) if force else None
    roster = add_spare_papers(roster.seated, options.spare, () if old is None else old.spares)
    secret = wish.secret(None if old is None else old.secret)
    stays = None if wish.new else old
    bank = _choose_bank(blueprint, secret, options, stays)
    require_languages(bank, language, roster)
    sources = source_files(bank) | translation_files(bank, known_languages())
    jobs = count_processes(options.jobs, len(roster.students))
    exam = _open_exam_folder(output, options.access, force=force)
    processes, book = open_executor(jobs, "generate"), open_sketchbook(jobs)
    with bulk_work(), exam as folder, processes as workers, book as sketchbook:
        run = PrintRun(bank, language, options.press_order(bank), extras)
        kept = _find_kept_papers(stays, secret)
        dealt = deal_exam(bank, roster, secret, workers, kept, sketchbook=sketchbook)
        require_enough(dealt)
        found = list_complaints(roster, run.press_order.press(), dealt, strict=options.strict)
        said = (*found, *_list_unbound(bank, extras))
        printer = partial(print_class, workers=workers, jobs=jobs)
        written = _print_papers(folder, run, dealt, printer, options)
        run = fill_up_papers(folder, run, dealt, written.pages, printer)
        candidates = map(candidate, roster.students, written.keys)
        _write_rest(make_exam_head(dealt, candidates, run), sources, folder)
        settled = settle(old, folder, new_numbers=wish.new, solutions=extras.solutions)
    return Generated(dealt, _list_drawn_templates(blueprint, bank), said, *settled)


def _choose_bank(
    blueprint: Blueprint, secret: ExamSecret, options: GenerateOptions, stays: ReplacedExam | None
) -> Bank:
    """The bank that a secret makes, which keeps to what earlier exams leave."""
    earlier = read_earlier_exams(options.avoid, stays.head if stays else None)
    return replace(blueprint.bank(secret.drawing), earlier=earlier)


def _print_papers(
    folder: Path, run: PrintRun, dealt: ClassDeal, printer: Printer, options: GenerateOptions
) -> WrittenPapers:
    """Every paper, while its progress is shown."""
    students = dealt.roster.students
    with closing(printer(run, dealt)) as papers:
        return write_papers(folder, run, students, options.progress(papers, len(students)))


def _open_exam_folder(output: Path, access: Access, *, force: bool) -> AbstractContextManager[Path]:
    """The new folder, which becomes `output` when it is whole."""
    return output_folder(output, marker=HEAD, contents=CONTENTS, force=force, access=access)


def _write_rest(head: ExamHead, sources: Mapping[str, bytes], folder: Path) -> None:
    """The booklets of rooms, the sources, the answer sheets and the head, which says what all other
    files were when they were made.
    """
    write_room_booklets(folder, map(student_of, head.students))
    write_sources(sources, folder)
    write_blank_answers(head, folder)
    write_blank_workbook(head, folder)
    write_head(head, digest_editable(folder), folder)


def _list_drawn_templates(blueprint: Blueprint, bank: Bank) -> dict[str, str]:
    """For each question that was drawn the name of its template."""
    drawn = {slot.identifier for slot in blueprint.slots if slot.drawn}
    return {
        each.identifier: each.template.name for each in bank.questions if each.identifier in drawn
    }


def _find_kept_papers(old: ReplacedExam | None, secret: ExamSecret) -> Mapping[str, KeyLine]:
    """The papers that stay: those of the folder that is replaced, where the secret stays too."""
    return old.kept if old is not None and old.secret == secret else {}


def _list_unbound(bank: Bank, extras: Extras) -> Iterator[Fault]:
    """That papers in other kinds of files lack the formula sheet."""
    if bank.formula_sheet is not None and extras.also:
        what, do = Message("exam.without-formulas"), Message("exam.hand-out-formulas")
        yield Fault(", ".join(extras.also), what, do=do)


def list_complaints(
    roster: Roster, press: Press, dealt: ClassDeal, *, strict: bool
) -> tuple[Problem, ...]:
    """What a person should look at before papers of a class are handed out. Raises TableError
    where that is refused.
    """
    found = (*roster_complaints(roster, press), *dealt.shortages(), *list_repeated(dealt))
    require_none(found if strict else ())
    return found


def require_none(complaints: tuple[Problem, ...]) -> None:
    """Raises TableError where there are complaints."""
    if complaints:
        raise TableError(*complaints)
