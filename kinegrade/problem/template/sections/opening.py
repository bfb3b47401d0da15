"""A template's file opened: its tables, laid over those of the mechanism that it shares."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence

from msgspec import Struct

from kinegrade.errors import FieldError, Problem, TemplateError, suggest
from kinegrade.files.fields.document import Document, FileKind, toml_table
from kinegrade.files.fields.faults import Faults
from kinegrade.files.fields.lines import lines_of_toml
from kinegrade.files.fields.place import Source
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.values import found
from kinegrade.language.message import Fault, Message, Quoted
from kinegrade.problem.template.beside import Beside, LaidIn, Translations, lay_in, state_texts
from kinegrade.problem.template.sections.keys import (
    KNOWN,
    MAX_CHARACTERS,
    NEEDED,
    SHARED,
    SHARED_LISTS,
)
from kinegrade.problem.template.sections.layers import Layer, Layers, is_sharable
from kinegrade.problem.template.sections.translated_places import (
    list_translated_places,
    open_bodies,
)
from kinegrade.problem.template.template import MechanismFile, TemplateFile

FOLDER = "mechanisms"  # beside the templates
TEMPLATE = FileKind(Message("template.a-template"), TemplateError, 4 * MAX_CHARACTERS)
_FILE_NAME = re.compile(r"[a-z0-9]+([-_][a-z0-9]+)*", re.ASCII)
# The mechanism of that name; raises KinegradeError when there is none.
Mechanisms = Callable[[str], MechanismFile]


class Opened(Struct, frozen=True):
    """The tables of a template together, the files that they come from, and the faults of both.

    `strays` are the names in tables that are not known, which may be misspelt ones.
    """

    table: Table
    file: TemplateFile
    faults: tuple[Faults, ...]
    strays: frozenset[str]


def no_mechanisms(name: str) -> MechanismFile:
    """Refuses every mechanism: a text alone has no folder beside it."""
    raise FieldError(
        Message("template.no-folder", name=Quoted(name)), do=Message("template.load-from-file")
    )


def require_file_name(name: str) -> None:
    """Raises TemplateError for what cannot be a template's name."""
    if not _FILE_NAME.fullmatch(name):
        raise TemplateError(Fault(f"{name}.toml", Message("template.file-name")))


def open_template(
    name: str, text: str, mechanisms: Mechanisms, translations: Translations
) -> Opened:
    """The tables of the template of that name.

    Raises TemplateError where a file is not TOML, or where the mechanism cannot be loaded.
    """
    require_file_name(name)
    file = f"{name}.toml"
    template = _read_toml(file, text)
    if "mechanism" in template:
        mechanism = _read_mechanism(template, mechanisms)
        kept = TemplateFile(text, mechanism, translations)
        return _lay_over_mechanism(template, file, kept, mechanism)
    document = Document(file, text, lines_of_toml)
    laid = _lay_in(template.content, document, translations, file)
    table = Table(Faults(laid.source, TemplateError), (), laid.content)
    return Opened(
        table if "steps" in table else _require_known(table, NEEDED),
        TemplateFile(text, None, translations),
        (table.faults, *laid.faults),
        _find_strays(template),
    )


def _lay_in(
    content: Mapping[str, object], source: Source, translations: Translations, file: str
) -> LaidIn:
    beside = Beside(file, TEMPLATE, translations)
    if translations:
        content = open_bodies(content)
    places = list_translated_places(content)
    if translations:
        content = state_texts(content, places.values())
    return lay_in(content, source, beside, places)


def _read_toml(file: str, text: str) -> Table:
    if len(text) > MAX_CHARACTERS:
        what = Message("template.characters", count=len(text))
        expected = Message("template.of-at-most", most=MAX_CHARACTERS)
        raise TemplateError(Fault(file, what, expected, Message("template.shorten-it")))
    return toml_table(file, text, TEMPLATE)


def _require_known(table: Table, needed: Sequence[str]) -> Table:
    """The tables that are known; others, and needed ones that are missing, are faults."""
    known = table.only(*KNOWN, unknown=Message("fields.unknown-table-or-key"))
    for key in needed:
        if key not in known:
            known.missing(key, _explain_missing(table, key))
    return known


def _explain_missing(table: Table, key: str) -> Message:
    """That every template has a key; where it stands inside a table, that it stands too low."""
    for name, value in table.content.items():
        if isinstance(value, dict) and key in value:
            return Message("template.above-tables", table=name)
    return Message("template.in-every-template")


def _find_strays(table: Table) -> frozenset[str]:
    unknown = [value for key, value in table.content.items() if key not in KNOWN]
    return frozenset(name for value in unknown if isinstance(value, dict) for name in value)


def _read_mechanism(template: Table, mechanisms: Mechanisms) -> MechanismFile:
    """The file that a template shares. Raises TemplateError where it cannot be loaded, with the
    other faults of the template that can then be found.
    """

    def load(value: object) -> MechanismFile:
        return mechanisms(_read_mechanism_name(value))

    mechanism = template.required("mechanism", load)
    if mechanism is None:
        raise TemplateError(*_find_outline_faults(template))
    return mechanism


def _read_shared(template: Table, file: str, mechanism: MechanismFile) -> Table:
    """The tables of the mechanism's file. Raises TemplateError where it is not TOML."""
    try:
        return _read_toml(file, mechanism.text)
    except TemplateError as error:
        raise TemplateError(*_find_outline_faults(template), *error.faults) from error


def _find_outline_faults(template: Table) -> tuple[Problem, ...]:
    """The faults that can be found in a template whose mechanism cannot be read."""
    _require_known(template, [key for key in NEEDED if key not in SHARED])
    return template.faults.raised().faults


def _read_mechanism_name(value: object) -> str:
    """A name that can stand for a file in the folder and nowhere else."""
    if isinstance(value, str) and _FILE_NAME.fullmatch(value):
        return value
    raise FieldError(found(value), Message("template.mechanism-name", folder=FOLDER))


def _lay_over_mechanism(
    template: Table, file: str, kept: TemplateFile, mechanism: MechanismFile
) -> Opened:
    shared_file = f"{FOLDER}/{mechanism.name}.toml"
    shared = _read_shared(template, shared_file, mechanism)
    for key, value in shared.content.items():
        if not is_sharable(key, value):
            _refuse(shared, key, value)
    document = Document(shared_file, mechanism.text, lines_of_toml)
    under = _lay_in(shared.content, document, mechanism.translations, shared_file)
    layers = Layers(
        Layer(template.content, Document(file, kept.text, lines_of_toml)),
        Layer(under.content, under.source),
    )
    over = _lay_in(layers.content(), layers, kept.translations, file)
    both = Table(Faults(over.source, TemplateError), (), over.content)
    table = _require_known(both, [key for key in NEEDED if key not in shared])
    faults = (table.faults, shared.faults, *over.faults, *under.faults)
    return Opened(table, kept, faults, _find_strays(template))


def _refuse(shared: Table, key: str, value: object) -> None:
    """Note why what stands under a key of a mechanism's file cannot be shared."""
    if key == "mechanism":
        what, do = Message("template.no-further-mechanism"), Message("template.write-all-tables")
        shared.fault(key, what, do=do)
    elif key in SHARED:
        listed = key in SHARED_LISTS
        expected = Message("fields.a-list") if listed else Message("fields.a-table")
        shared.fault(key, found(value), expected)
    else:
        remedy = Message("template.leave-to-templates", hint=suggest(key, SHARED))
        shared.fault(key, Message("template.cannot-be-shared"), do=remedy)
