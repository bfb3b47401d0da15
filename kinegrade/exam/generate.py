"""`kinegrade generate`: the exam folder, written whole or not at all.

What students may see lies under `papers/` alone; everything else in the folder gives the key away
and says so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager, closing
from dataclasses import dataclass, replace
from pathlib import Path
from typing import BinaryIO

from msgspec import structs

from kinegrade.csv_writing import neutralised, write_for_people
from kinegrade.errors import BankError, TableError
from kinegrade.exam.answer_workbook import write_answer_workbook
from kinegrade.exam.blueprint import Bank, Blueprint
from kinegrade.exam.class_printing import CHUNK, printed
from kinegrade.exam.dealing import ClassDeal, deal_exam
from kinegrade.exam.document import KeyPaper, PaperSize
from kinegrade.exam.exam_secret import ExamSecret, SecretWish
from kinegrade.exam.folder.contents import (
    ANSWER_WORKBOOK,
    ANSWERS,
    BANK,
    CONTENTS,
    FOR_STUDENTS,
    HEAD,
    KEY,
    NOTICE,
    TEMPLATES,
)
from kinegrade.exam.folder.records import ExamHead, KeyLine
from kinegrade.exam.folder.writing import head_json
from kinegrade.exam.hand_work import editable
from kinegrade.exam.head_record import WARNING, candidate, exam_head
from kinegrade.exam.pages import key_book
from kinegrade.exam.press import Engine, Press
from kinegrade.exam.printed_files import printed_files, write_key
from kinegrade.exam.printing import Extras, PressOrder, Printed, PrintRun, require_tools
from kinegrade.exam.replaced_exam import PaperChanges, ReplacedExam, replaced_exam, settle
from kinegrade.exam.roster import Roster
from kinegrade.exam.roster_complaints import roster_complaints
from kinegrade.files import Access, output_folder
from kinegrade.garbage_collection import bulk_work
from kinegrade.language import Language
from kinegrade.problem.sections.opening import FOLDER
from kinegrade.processes import executor

PRIVATE = Access(0o700, 0o600, FOR_STUDENTS)
SHARED_WITH_GROUP = Access(0o750, 0o640, FOR_STUDENTS)
PLAIN = Extras()
Progress = Callable[[Iterator[Printed], int], Iterator[Printed]]


@dataclass(frozen=True)
class Generated:
    """What was written: how many papers, and `dealt` knows from how many combinations and why
    others were refused.

    `drawn` names the templates of the questions that the bank left to be drawn. Where a folder was
    replaced, `changes` tells what became of its papers and `remarks` of what else was in it.
    """

    dealt: ClassDeal
    drawn: dict[str, str]
    complaints: tuple[str, ...]
    changes: PaperChanges | None
    remarks: tuple[str, ...]

    @property
    def papers(self) -> int:
        """How many there are."""
        return len(self.dealt.roster.students)


@dataclass(frozen=True)
class Place:
    """Where the exam folder goes, whether it may replace one that stands there, and who may read
    it.
    """

    path: Path
    force: bool = False
    access: Access = PRIVATE

    def folder(self) -> AbstractContextManager[Path]:
        """A hidden folder to write into, which becomes the exam folder at the end.

        Raises OutputError.
        """
        return output_folder(
            self.path, marker=HEAD, contents=CONTENTS, force=self.force, access=self.access
        )


@dataclass(frozen=True)
class Printing:
    """How papers are printed: by up to `jobs` processes; the engine is the bank's unless one is
    given.
    """

    paper_size: PaperSize = "a4"
    engine: Engine | None = None
    jobs: int = 1

    def order(self, bank: Bank) -> PressOrder:
        """The press for an exam."""
        return PressOrder(self.engine or bank.engine, self.paper_size)


ORDINARY = Printing()


def generate(
    blueprint: Blueprint,
    roster: Roster,
    place: Place,
    wish: SecretWish,
    language: Language,
    *,
    strict: bool = False,
    printing: Printing = ORDINARY,
    extras: Extras = PLAIN,
    progress: Progress = lambda papers, count: papers,
) -> Generated:
    """Write an exam folder at `place`.

    `wish` says what its numbers are drawn from: those of a folder that is replaced stay as they
    are. `extras` says what is written beside papers and key; what would be a complaint is refused
    where `strict`. Raises KinegradeError; then nothing is written.
    """
    require_tools(extras)
    old = replaced_exam(place.path, new_numbers=wish.new) if place.force else None
    secret = wish.secret(None if old is None else old.secret)
    bank = blueprint.bank(secret.drawing)
    sources = source_files(bank)
    jobs = max(min(printing.jobs, len(roster.students) // CHUNK), 1)
    with bulk_work(), place.folder() as folder, executor(jobs, "generate") as workers:
        order = printing.order(bank)
        press = order.press()
        dealt = deal_exam(bank, roster, secret, workers, kept_papers(old, secret))
        said = (*roster_complaints(roster, press), *dealt.shortages())
        require_none(said if strict else ())
        run = PrintRun(bank, language, order, extras)
        with closing(printed(run, dealt, workers, jobs)) as papers:
            results = progress(papers, len(roster.students))
            keys = write_papers(dealt, run, press, folder, results)
        write_sources(sources, folder)
        candidates = map(candidate, roster.students, keys)
        write_head(exam_head(dealt, candidates, run), dealt, folder)
        settled = settle(old, folder, new_numbers=wish.new, solutions=extras.solutions)
    return Generated(dealt, drawn_templates(blueprint, bank), said, *settled)


def write_head(head: ExamHead, dealt: ClassDeal, folder: Path) -> None:
    """The answer sheet, exam.json and the notice to instructors; all other files stand there
    already.
    """
    write_blank_answers(dealt, folder)
    whole = structs.replace(head, editable=editable(folder))
    (folder / HEAD).write_bytes(head_json(whole))
    (folder / NOTICE).write_text(WARNING + "\n", encoding="utf-8")


def drawn_templates(blueprint: Blueprint, bank: Bank) -> dict[str, str]:
    """For each question that was drawn the name of its template."""
    return {
        slot.identifier: question.template.name
        for slot, question in zip(blueprint.slots, bank.questions, strict=True)
        if slot.drawn
    }


def write_papers(
    dealt: ClassDeal, run: PrintRun, press: Press, folder: Path, results: Iterator[Printed]
) -> list[KeyPaper]:
    """The papers, and the solutions that are wanted, each alone and all in one file; and both keys.

    The instructor's book is typeset, and all in one file bound, while papers are printed. Gives the
    key of each paper without its questions.
    """
    keys: list[KeyPaper] = []
    with (
        (folder / KEY).open("wb") as lines,
        printed_files(folder, solutions=run.extras.solutions) as write,
    ):
        papers = noted(written(results, dealt.roster, write), lines, keys)
        write_key(folder, press.key(key_book(run.bank, papers, run.language)))
    return keys


def written(
    results: Iterator[Printed], roster: Roster, write: Callable[[str, Printed], None]
) -> Iterator[Printed]:
    """The same papers, each written under the file name of its student."""
    for student, result in zip(roster.students, results, strict=True):
        write(student.file_name, result)
        yield result


def noted(results: Iterator[Printed], lines: BinaryIO, keys: list[KeyPaper]) -> Iterator[KeyPaper]:
    """The keys of papers as they come; a line of each goes to `lines`, its head to `keys`."""
    for result in results:
        lines.write(result.record)
        keys.append(replace(result.key, entries=()))
        yield result.key


def source_files(bank: Bank) -> dict[str, str]:
    """The bank, every template and every mechanism as they were, so that a newer kinegrade can mark
    the exam again.

    Raises BankError where two templates share different mechanisms of one name, as the folder keeps
    one file of a name.
    """
    templates = [question.template for question in bank.questions]
    shared = [template.file.mechanism for template in templates if template.file.mechanism]
    mechanisms: dict[str, str] = {}
    faults = {
        mechanism.name: "bank: templates of this bank share two different mechanisms named "
        f'"{mechanism.name}": rename one file'
        for mechanism in shared
        if mechanisms.setdefault(mechanism.name, mechanism.text) != mechanism.text
    }
    if faults:
        raise BankError(*faults.values())
    return {
        BANK: bank.text,
        **{f"{TEMPLATES}/{template.name}.toml": template.file.text for template in templates},
        **{f"{TEMPLATES}/{FOLDER}/{name}.toml": text for name, text in mechanisms.items()},
    }


def write_sources(sources: Mapping[str, str], folder: Path) -> None:
    """Texts by their path below the folder."""
    for name, text in sources.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="")


def write_blank_answers(dealt: ClassDeal, folder: Path) -> None:
    """The blank answer sheet, as CSV and as a workbook: a row for each student, a column for each
    ask.
    """
    columns = [
        f"{question.identifier}.{ask.name}"
        for question in dealt.bank.questions
        for ask in question.asks
    ]
    header, blank = ["student", "name", *columns], [""] * len(columns)
    students = dealt.roster.students
    write_for_people(
        folder / ANSWERS,
        header,
        ([student.student, neutralised(student.name), *blank] for student in students),
    )
    write_answer_workbook(
        folder / ANSWER_WORKBOOK,
        header,
        ([student.student, student.name, *blank] for student in students),
    )


def kept_papers(old: ReplacedExam | None, secret: ExamSecret) -> Mapping[str, KeyLine]:
    """The papers that stay: those of the folder that is replaced, where the secret stays too."""
    return old.kept if old is not None and old.secret == secret else {}


def require_none(complaints: tuple[str, ...]) -> None:
    """Raises TableError where there are complaints."""
    if complaints:
        raise TableError(*complaints)
