"""The files of an exam folder, but for the papers themselves: written by `generate` into a new
folder, and by `adding` into a copy of one.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain, groupby
from pathlib import Path

from msgspec import structs

from kinegrade.errors import BankError
from kinegrade.exam.bank.blueprint import Bank
from kinegrade.exam.bank.formula_sheet import list_formula_files
from kinegrade.exam.folder.asks import Ask
from kinegrade.exam.folder.columns.writing import write_columns
from kinegrade.exam.folder.contents import (
    ANSWER_WORKBOOK,
    ANSWERS,
    BANK,
    HEAD,
    KEY,
    KEY_COLUMNS,
    LOGO,
    NOTICE,
    SPARES,
    TEMPLATES,
)
from kinegrade.exam.folder.printed_orders import read_held_questions
from kinegrade.exam.folder.records import ExamHead
from kinegrade.exam.folder.writing import encode_head
from kinegrade.exam.generating.answer_sheets.workbook import Rows, write_answer_workbook
from kinegrade.exam.generating.hand_work import OWN_COLUMNS
from kinegrade.exam.generating.key_books import write_key_books
from kinegrade.exam.printing.head_record import write_warning
from kinegrade.exam.printing.printed_files import printed_files
from kinegrade.exam.printing.printing import Printed, PrintRun
from kinegrade.exam.roster.students import Student
from kinegrade.files.csv_writing import neutralise, write_for_people
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.press.sheet import KeyPaper
from kinegrade.problem.template.beside import Translations
from kinegrade.problem.template.sections.opening import FOLDER
from kinegrade.problem.template.template import MechanismFile
from kinegrade.problem.template.translation_names import name_beside


@dataclass(frozen=True)
class WrittenPapers:
    """The key of each paper without its questions, and how many pages it has."""

    keys: tuple[KeyPaper, ...]
    pages: tuple[int, ...]


def write_papers(
    folder: Path,
    run: PrintRun,
    students: Sequence[Student],
    results: Iterator[Printed],
    *,
    earlier: Iterable[KeyPaper] = (),
    spare: Collection[str] = (),
) -> WrittenPapers:
    """The papers, and the solutions that are wanted, each alone and all in one file; and both keys,
    but that of the instructor where no papers are wanted.

    What stands in the folder already stays, with the keys of these papers as `earlier`; `spare` are
    those of them made without a student. The instructor's books are typeset, and all in one file
    bound, while papers are printed. Gives what was written for each of `students`.
    """
    written: list[tuple[KeyPaper, int]] = []
    with printed_files(folder, run.extras) as write:
        papers = _noted(_written(folder, results, students, write), written)
        apart = {*spare, *(each.student for each in students if each.spare)}
        if run.extras.papers:
            write_key_books(folder, run, chain(earlier, papers), apart)
        else:
            deque(papers, maxlen=0)
    keys, pages = zip(*written, strict=True) if written else ((), ())
    return WrittenPapers(keys, pages)


def _written(
    folder: Path,
    results: Iterator[Printed],
    students: Sequence[Student],
    write: Callable[[str, Printed], None],
) -> Iterator[Printed]:
    """The same papers, each written under the file name of its student, its key in a file of the
    folder.
    """
    for spare, part in groupby(zip(students, results, strict=True), lambda pair: pair[0].spare):
        with (folder / (SPARES if spare else KEY)).open("ab") as lines:
            for student, result in part:
                write(student.file_name, result)
                lines.write(result.record)
                yield result


def _noted(results: Iterator[Printed], written: list[tuple[KeyPaper, int]]) -> Iterator[KeyPaper]:
    """The keys of papers as they come; the head of each goes to `written`."""
    for result in results:
        written.append((replace(result.key, entries=()), result.pages))
        yield result.key


def source_files(bank: Bank) -> dict[str, bytes]:
    """The bank, its logo, its formula sheet, every template and every mechanism as they were, so
    that a newer kinegrade can mark the exam again.

    Raises BankError where two templates share different mechanisms of one name, as the folder keeps
    one file of a name.
    """
    templates = [question.template for question in bank.questions]
    shared = [template.file.mechanism for template in templates if template.file.mechanism]
    mechanisms: dict[str, MechanismFile] = {}
    faults = {
        mechanism.name: Fault(
            "bank", Message("bank.mechanism-name-taken", name=Quoted(mechanism.name))
        )
        for mechanism in shared
        if mechanisms.setdefault(mechanism.name, mechanism) != mechanism
    }
    if faults:
        raise BankError(*faults.values())
    logo = {LOGO: bank.header.logo} if bank.header.logo else {}
    texts = {
        BANK: bank.text,
        **logo,
        **{f"{TEMPLATES}/{template.name}.toml": template.file.text for template in templates},
        **{f"{TEMPLATES}/{FOLDER}/{name}.toml": each.text for name, each in mechanisms.items()},
    }
    return _encode(texts) | list_formula_files(bank.formula_sheet)


def _encode(texts: Mapping[str, str]) -> dict[str, bytes]:
    return {name: text.encode() for name, text in texts.items()}


def translation_files(bank: Bank, languages: Collection[Language]) -> dict[str, bytes]:
    """The files that translate what `source_files` gives into these languages, as they were."""
    files: dict[str, Translations] = {BANK: bank.translations}
    for template in (question.template for question in bank.questions):
        files[f"{TEMPLATES}/{template.name}.toml"] = template.file.translations
        if template.file.mechanism is not None:
            shared = template.file.mechanism
            files[f"{TEMPLATES}/{FOLDER}/{shared.name}.toml"] = shared.translations
    return _encode(
        {
            name_beside(file, language): text
            for file, translations in files.items()
            for language, text in translations.items()
            if language in languages
        }
    )


def write_sources(sources: Mapping[str, bytes], folder: Path) -> None:
    """Files by their path below the folder."""
    for name, content in sources.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def write_blank_answers(head: ExamHead, folder: Path) -> None:
    """The blank answer sheet as CSV: a row for each student, a column for each ask."""
    rows = (
        [each.student, neutralise(each.name), *[""] * len(head.columns)] for each in head.students
    )
    write_for_people(folder / ANSWERS, (*OWN_COLUMNS, *head.columns), rows)


def write_blank_workbook(head: ExamHead, folder: Path) -> None:
    """The same as a workbook, in which the cells of questions that a paper does not hold are grey.

    Raises ExamError where the folder's key cannot be read.
    """
    held = read_held_questions(folder / KEY, head)
    cells = [
        [each.student, each.name, each.paper, *_write_blanks(head.asks, held.get(each.student))]
        for each in head.students
    ]
    rows = Rows((*OWN_COLUMNS, "paper"), head.asks, cells)
    write_answer_workbook(folder / ANSWER_WORKBOOK, rows, open_catalogue(head.language))


def _write_blanks(asks: Iterable[Ask], held: Collection[str] | None) -> list[str | None]:
    """A blank for each ask of the questions held, None for the others."""
    return ["" if held is None or ask.question in held else None for ask in asks]


def write_head(head: ExamHead, editable: Mapping[str, str] | None, folder: Path) -> None:
    """exam.json and the notice to instructors, and the key of that head as arrays; `editable` are
    digests of files as generated.
    """
    stated = None if editable is None else dict(editable)
    (folder / HEAD).write_bytes(encode_head(structs.replace(head, editable=stated)))
    (folder / NOTICE).write_text(f"{write_warning()}\n", encoding="utf-8")
    write_columns(folder / KEY_COLUMNS, folder / KEY, head)
