"""`kinegrade generate`: the exam folder, written whole or not at all.

What students may see lies under `papers/` alone; everything else in the folder gives the key away
and says so.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping
from contextlib import closing, contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from msgspec import structs

from kinegrade.errors import Problem
from kinegrade.exam.bank.blueprint import Bank, Blueprint
from kinegrade.exam.folder.contents import CONTENTS, HEAD, UNFINISHED
from kinegrade.exam.folder.exam_secret import ExamSecret
from kinegrade.exam.folder.key.lines import KeyLine
from kinegrade.exam.folder.records import Candidate, ExamHead
from kinegrade.exam.generating.complaints import list_complaints, list_unbound
from kinegrade.exam.generating.earlier_exams import read_earlier_exams, require_enough
from kinegrade.exam.generating.exam_files import (
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
from kinegrade.exam.generating.replacing.paper_changes import PaperChanges
from kinegrade.exam.generating.replacing.replaced_exam import (
    ReplacedExam,
    remember,
    replaced_exam,
    require_own_ids,
    settle,
)
from kinegrade.exam.printing.class_printing import count_processes, print_class
from kinegrade.exam.printing.head_record import candidate, make_exam_head
from kinegrade.exam.printing.paper_languages import require_languages
from kinegrade.exam.printing.printing import Extras, PrintRun, require_tools
from kinegrade.exam.printing.room_booklets import write_room_booklets
from kinegrade.exam.resuming.begun import Basis, Begun, Order, describe_order, find_begun
from kinegrade.exam.resuming.journal import Journal, open_journal
from kinegrade.exam.roster.roster import Roster
from kinegrade.exam.roster.spare_papers import add_spare_papers
from kinegrade.exam.setting.dealing import ClassDeal, deal_exam
from kinegrade.figure.sketchbook import open_sketchbook
from kinegrade.files.output import Resumable, output_folder
from kinegrade.files.placing.standing import Standing, find_standing
from kinegrade.language import Language
from kinegrade.language.known import known_languages
from kinegrade.language.message import Message
from kinegrade.processes.executor import open_executor
from kinegrade.processes.garbage_collection import bulk_work


@dataclass(frozen=True)
class Generated:
    """What was written: how many papers, and `dealt` knows from how many combinations and why
    others were refused.

    `drawn` names the templates of the questions that the bank left to be drawn. Where a folder was
    replaced, `changes` tells what became of its papers and `remarks` of what else was in it.
    `resumed` papers were there from an earlier run.
    """

    dealt: ClassDeal
    drawn: dict[str, str]
    complaints: tuple[Problem, ...]
    changes: PaperChanges | None
    remarks: tuple[Message, ...]
    resumed: int = 0

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
    wish, extras, stood = options.wish, options.extras, find_standing(output, HEAD)
    require_tools(extras)
    old = replaced_exam(output, new_numbers=wish.new) if force else None
    begun = find_begun(output) if options.resume else None
    roster = _seat_class(roster, options, old)
    secret = begun.secret if begun else wish.secret(None if old is None else old.secret)
    stays = None if wish.new else old
    bank = _choose_bank(blueprint, secret, options, stays)
    require_languages(bank, language, roster)
    sources = source_files(bank) | translation_files(bank, known_languages())
    run = PrintRun(bank, language, options.press_order(bank), extras)
    basis = Basis(sources, roster, stays.papers if stays else {})
    order = _require_same_order(begun, run, basis, options)
    exam = _open_exam_folder(output, options, begun, stood, force=force)
    jobs = count_processes(options.processes, len(roster.students))
    processes = open_executor(jobs, "generate", cluster=options.cluster)
    with bulk_work(), exam as folder, processes as workers, open_sketchbook(jobs) as sketchbook:
        journal, kept = open_journal(folder, secret, order), _find_kept_papers(stays, secret)
        dealt = deal_exam(bank, roster, secret, workers, kept, sketchbook=sketchbook)
        require_enough(dealt)
        found = list_complaints(roster, run.press_order.press(), dealt, strict=options.strict)
        printer = partial(print_class, workers=workers, jobs=jobs)
        run, candidates = _print_papers(journal, run, dealt, printer, options)
        _write_rest(remember(stays, make_exam_head(dealt, candidates, run)), sources, folder)
        settled = settle(old, folder, options)
    drawn, said = _list_drawn_templates(blueprint, bank), (*found, *list_unbound(bank, extras))
    return Generated(dealt, drawn, said, *settled, resumed=len(journal.lines))


def _seat_class(roster: Roster, options: GenerateOptions, old: ReplacedExam | None) -> Roster:
    """The students in the order of their seats, then the spare papers, with places of files. Raises
    TableError where a student has the id that another had in the exam that stays.
    """
    require_own_ids(None if options.wish.new else old, roster)
    spares, files = old.spares if old else (), options.extras.files
    return add_spare_papers(roster.seated, options.spare, spares, files=files)


def _choose_bank(
    blueprint: Blueprint, secret: ExamSecret, options: GenerateOptions, stays: ReplacedExam | None
) -> Bank:
    """The bank that a secret makes, which keeps to what earlier exams leave."""
    earlier = read_earlier_exams(options.avoid, stays.head if stays else None, options.sheets)
    return structs.replace(blueprint.bank(secret.drawing), earlier=earlier)


def _require_same_order(
    begun: Begun | None, run: PrintRun, basis: Basis, options: GenerateOptions
) -> Order:
    """What is asked for. Raises OutputError where that is not what was begun."""
    order = describe_order(run, basis, (options.wish, options.spare))
    if begun is not None:
        begun.require_same(order)
    return order


def _print_papers(
    journal: Journal, run: PrintRun, dealt: ClassDeal, printer: Printer, options: GenerateOptions
) -> tuple[PrintRun, Iterator[Candidate]]:
    """Every paper that is not there yet, while progress is shown; then those that are short are
    filled up. Gives the run with the number of pages that all have, and who has which paper.
    """
    if not run.extras.papers:
        _require_printable(run, dealt, printer)
    students = dealt.roster.students
    missing = journal.list_missing(students)
    with closing(printer(run, replace(dealt, roster=Roster(missing, ())))) as papers:
        all_papers = journal.merge(students, options.progress(papers, len(missing)))
        written = write_papers(journal.folder, run, students, all_papers)
    run = fill_up_papers(journal.folder, run, dealt, written.pages, printer)
    return run, map(candidate, students, written.keys)


def _require_printable(run: PrintRun, dealt: ClassDeal, printer: Printer) -> None:
    """Raises TypesetError where the papers of an exam could not be printed later: one in each
    language is tried.
    """
    first = {each.language: each for each in reversed(dealt.roster.students)}
    plain, roster = structs.replace(run, extras=Extras()), Roster(tuple(first.values()), ())
    with closing(printer(plain, replace(dealt, roster=roster))) as papers:
        deque(papers, maxlen=0)


@contextmanager
def _open_exam_folder(
    output: Path, options: GenerateOptions, begun: Begun | None, stood: Standing, *, force: bool
) -> Iterator[Path]:
    """The folder, new or `begun`, which becomes `output` when it is whole, in place of what
    `stood` there.
    """
    with output_folder(
        output,
        marker=HEAD,
        contents=CONTENTS,
        force=force,
        access=options.access,
        resumable=Resumable(UNFINISHED, begun.folder if begun else None, options.resume),
    ) as folder:
        stood.require(output, output)
        yield folder


def _write_rest(head: ExamHead, sources: Mapping[str, bytes], folder: Path) -> None:
    """The booklets of rooms, the sources, the answer sheets and the head, which says what all other
    files were when they were made.
    """
    write_room_booklets(folder, head)
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
