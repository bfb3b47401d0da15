"""The bank's file, an exam's blueprint: which questions are asked, for how many points, within
which tolerance.

`keys` lists what may be written in it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import get_args

from msgspec.structs import replace

from kinegrade.errors import BankError, suggest
from kinegrade.exam.bank.blueprint import LMS, Bank, Blueprint, Slot
from kinegrade.exam.bank.by_hand import HandQuestion, find_hand_places
from kinegrade.exam.bank.entries.entries import MAX_QUESTIONS, Entries, Entry
from kinegrade.exam.bank.entries.named_templates import NamedTemplates
from kinegrade.exam.bank.entries.together import require_carried, require_fit
from kinegrade.exam.bank.formula_sheet import read_formula_sheet
from kinegrade.exam.bank.header import find_header_places, read_header
from kinegrade.exam.bank.keys import BANK
from kinegrade.exam.bank.terms import BankTolerance, read_bank_tolerance, read_room
from kinegrade.exam.bank.versions import LETTERS
from kinegrade.exam.folder.contents import HEAD
from kinegrade.exam.folder.faults import REMEDY
from kinegrade.exam.homework import Homework, number_title, read_homework
from kinegrade.files.fields.document import Document, FileKind, read_text, toml_table
from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.lines import lines_of_toml
from kinegrade.files.fields.place import Place
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import choice, date_text, flag, whole
from kinegrade.grade_scale.stated import read_scale
from kinegrade.language.lines import shorten
from kinegrade.language.message import Fault, Message, Quoted, list_plainly
from kinegrade.numbers.tolerance import LEAST_CARRY, MOST_CARRY, USUAL_CARRY
from kinegrade.press.protocol import ENGINES
from kinegrade.problem.template.beside import Beside, Translations, lay_in, read_translations
from kinegrade.problem.template.library.library import find_shipped, list_names
from kinegrade.problem.template.translated import Translated
from kinegrade.problem.template.translations import translated
from kinegrade.stated_marking import read_credit

MAX_BYTES = 200_000
_BANK_FILE = FileKind(Message("bank.a-bank-file"), BankError, MAX_BYTES)
_SYSTEMS: tuple[LMS, ...] = get_args(LMS)
_TEXTS = ("title", "course")  # what a translation beside a bank may hold
_NO_TEXT = Translated(plain="")


def find_bank(path: Path) -> Path:
    """A bank's file: the one at that path, or the shipped bank of that name. Raises BankError if
    there is neither.
    """
    folder = find_shipped("banks")
    banks = {name: folder / f"{name}.toml" for name in list_names(folder)}
    if not path.is_file() and str(path) in banks:
        return banks[str(path)]
    if path.suffix != ".toml" and not path.exists():
        name = Quoted(shorten(str(path)))
        raise BankError(Message("bank.none", name=name, hint=suggest(str(path), banks)))
    return path


def read_bank(path: Path, secret: str = "") -> Bank:
    """The exam that a secret makes of a bank's file; the secret matters where the bank draws by
    family or tag.

    Raises BankError with all faults at once.
    """
    return read_blueprint(path).bank(secret)


def read_kept_bank(path: Path, folder: Path, chosen: Mapping[str, str]) -> Bank:
    """The bank of an exam from the copy at `path` that is kept with it; `chosen` names the template
    of each question, and `folder` holds copies of those.

    Raises BankError with all faults at once.
    """
    bank = read_blueprint(path, folder, kept=True).choose(chosen)
    if [(each.identifier, each.template.name) for each in bank.questions] != [*chosen.items()]:
        what = Message("bank.differing-questions", head=HEAD)
        expected = Message("bank.questions-of-exam", questions=list_plainly(chosen))
        raise BankError(Fault(str(path), what, expected, REMEDY))
    return bank


def read_blueprint(
    path: Path, folder: Path | None = None, *, kept: bool = False, before: str = ""
) -> Blueprint:
    """The blueprint in a file; `folder` holds the templates: by default the shipped ones, and for a
    bank that is `kept` with an exam those of the exam. Lines `before` the file's belong to it.

    Raises BankError with all faults at once.
    """
    text = f"{before}{read_text(path, _BANK_FILE)}"
    translations = read_translations(path, _BANK_FILE)
    whole, faults = _open(path, text, translations)
    table = whole.only(*BANK, hint=_hint)
    header = read_header(table, path.parent, kept=kept)
    formulas = read_formula_sheet(table, path.parent, kept=kept)
    frame = replace(_read_frame(table, text, translations), header=header, formula_sheet=formulas)
    shipped = folder or find_shipped("templates")
    templates = NamedTemplates(table.faults, shipped, path.parent, kept)
    entries = Entries(templates, frame.space)
    slots, by_hand = _read_questions(table, entries, frame)
    _require_none((table.faults, *faults))
    return Blueprint(replace(frame, by_hand=by_hand), slots)


def read_bank_texts(path: Path) -> tuple[Translated, Translated]:
    """The title and the course of the bank in a file. Raises BankError."""
    text, translations = read_text(path, _BANK_FILE), read_translations(path, _BANK_FILE)
    table, faults = _open(path, text, translations)
    title, course = _read_texts(table, read_homework(table))
    _require_none((table.faults, *faults))
    return title, course


def _read_texts(table: Table, homework: Homework) -> tuple[Translated, Translated]:
    title, course = (table.required(key, translated) for key in _TEXTS)
    return number_title(title or _NO_TEXT, homework), course or _NO_TEXT


def _open(path: Path, text: str, translations: Translations) -> tuple[Table, tuple[Faults, ...]]:
    """The bank's tables with the texts of the translations beside it, and the faults of these."""
    plain = toml_table(str(path), text, _BANK_FILE)
    document = Document(str(path), text, lines_of_toml)
    places: dict[Place, Place] = {(key,): (key,) for key in _TEXTS if key in plain}
    places |= find_header_places(plain.value("header"))
    places |= find_hand_places(plain.value("questions"))
    laid = lay_in(plain.content, document, Beside(str(path), _BANK_FILE, translations), places)
    return Table(Faults(laid.source, BankError), (), laid.content), laid.faults


def _require_none(files: Iterable[Faults]) -> None:
    """Raises BankError with the faults of all these files."""
    faults = [fault for file in files for fault in file.raised().faults]
    if faults:
        raise BankError(*faults)


def _read_frame(table: Table, text: str, translations: Translations) -> Bank:
    """Everything but the questions; an entry at fault is left empty or at its default."""
    homework = read_homework(table)
    title, course = _read_texts(table, homework)
    stated = read_bank_tolerance(table, BankTolerance(honest=True))
    return Bank(
        title=title,
        course=course,
        date=table.with_default("date", date_text, ""),
        tolerance=stated.tolerance,
        questions=(),
        text=text,
        translations=translations,
        honest=stated.honest,
        carry=table.with_default("carry", whole(LEAST_CARRY, MOST_CARRY), USUAL_CARRY),
        space=table.with_default("space", read_room, 0.0),
        shuffle=table.with_default("shuffle", flag, False),
        versions=table.with_default("versions", whole(1, len(LETTERS)), 0),
        engine=table.with_default("engine", choice(ENGINES), "typst"),
        credit=read_credit(table, lambda: _list_mistake_names(table)),
        scale=read_scale(table),
        homework=homework,
        solutions=table.with_default("solutions", flag, False),
        cycle=table.with_default("cycle", flag, False),
        lms=table.optional("lms", choice(_SYSTEMS)),
    )


def _list_mistake_names(table: Table) -> tuple[str, ...]:
    # Few banks give credit for mistakes
    from kinegrade.exam.bank.entries.own_questions import list_mistake_names  # noqa: PLC0415

    return list_mistake_names(table.value("questions"))


def _read_questions(
    table: Table, entries: Entries, frame: Bank
) -> tuple[tuple[Slot, ...], tuple[HandQuestion, ...]]:
    """The exam's questions q1, q2 ... in the bank's order, those to be marked by hand apart; an
    entry may stand for several.
    """
    tables = table.tables("questions")
    if not 1 <= len(tables) <= MAX_QUESTIONS:
        _miscounted(table, len(tables))
        return (), ()
    stated = BankTolerance(frame.tolerance, frame.honest)
    read: list[Entry] = []
    for entry in tables:
        first = sum(before.count for before in read) + 1
        read.append(entries.read(entry, first, stated))
    slots = tuple(slot for entry in read for slot in entry.slots)
    by_hand = tuple(entry.by_hand for entry in read if entry.by_hand is not None)
    require_fit(table, read)
    if not entries.templates.kept:
        require_carried(read, frame.carry)
    return slots, by_hand


def _miscounted(table: Table, count: int) -> None:
    expected = Message("bank.tables-from-one", most=MAX_QUESTIONS)
    if "questions" not in table:
        table.missing("questions", expected)
    elif isinstance(table.value("questions"), list):
        table.fault("questions", Message("bank.tables", count=count), expected)


def _hint(key: str) -> Message:
    """What is done about a key that no bank has."""
    return Message("bank.language-told") if key == "language" else suggest(key, BANK)
