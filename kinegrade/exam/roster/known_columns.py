"""What the columns of rosters are called: in each language, and by systems that give one word
another meaning.

The words of a language stand in its catalogue, `roster.columns-...`; those of other languages, in
which systems export too, in `_ELSEWHERE`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Literal, TypeAlias

from kinegrade.files.cell_text import make_header_key
from kinegrade.language.message import Message
from kinegrade.language.spellings import list_preferred_spellings

#: What a column of a roster may hold; `name` stands for both parts of it.
Column: TypeAlias = Literal[
    "student",
    "name",
    "first",
    "last",
    "email",
    "group",
    "room",
    "seat",
    "language",
    "extra-time",
    "format",
]
_ELSEWHERE: Mapping[Column, Sequence[str]] = {
    # Moodle in French, Spanish, Japanese and Dutch
    "student": ("numéro d’identification", "numéro d'identification", "número de id", "idナンバ"),
    "name": (),
    "first": ("prénom", "nombre", "voornaam"),
    "last": ("nom de famille", "nom", "apellido(s)", "apellidos", "achternaam"),
    "email": ("adresse de courriel", "dirección de correo", "メールアドレス", "e-mailadres"),
    "group": ("groupes", "groupe", "grupos", "grupo", "グループ", "groepen"),
    "room": (),
    "seat": (),
    "language": (),
    "extra-time": (),
    "format": (),
}
# What a running number or a name may be called as well
_VAGUE = frozenset(("student", "id"))
_UNIT = re.compile(r"\s*[(\[][^()\[\]]*[)\]]$")  # "extra time (min)"


@dataclass(frozen=True)
class System:
    """A system whose exports are known by columns that all stand there, and whose words mean
    something else than elsewhere.

    `not_students` are the texts below the name of lines that are no students, `turned` says that
    names are written "Last, First".
    """

    name: str
    signature: frozenset[str]
    columns: Mapping[Column, Sequence[str]]
    turned: bool = False
    not_students: re.Pattern[str] = field(default=re.compile(r"(?!)"))


_CANVAS_IDS = ("sis user id", "sis login id", "id")
_CANVAS_LINES = re.compile(r"\s*(?:|.*Points Possible.*|Muted|Manual Posting.*|Student, Test)\s*")
SYSTEMS = (
    System(
        "Canvas",
        frozenset({"student", "id", "section"}),
        {"student": _CANVAS_IDS, "name": ("student",), "group": ("section",)},
        turned=True,
        not_students=_CANVAS_LINES,
    ),
    System(
        "Canvas",
        frozenset({"lastname", "firstname", "id", "section"}),
        {"student": _CANVAS_IDS, "last": ("lastname",), "group": ("section",)},
        not_students=_CANVAS_LINES,
    ),
)


@cache
def list_column_names(column: Column) -> tuple[str, ...]:
    """The names that a column may have, in small letters, the best first: those of English, then
    those of all other languages, and last those that may mean something else.

    >>> list_column_names("name")[:2], list_column_names("student")[-2:]
    (('name', 'full name'), ('student', 'id'))
    """
    spellings = list_preferred_spellings(Message(f"roster.columns-{column}"))
    return tuple(sorted((*spellings, *_ELSEWHERE[column]), key=_VAGUE.__contains__))


@cache
def list_key_columns() -> tuple[str, ...]:
    """The names of columns that say in a sheet of answers whose they are: of ids, then of the codes
    of papers.
    """
    return (*list_column_names("student"), *list_code_columns())


@cache
def list_code_columns() -> tuple[str, ...]:
    """The names of columns of the codes of papers."""
    return list_preferred_spellings(Message("roster.columns-paper"))


@cache
def list_columns_of_people() -> tuple[str, ...]:
    """The names of columns that say in a sheet of answers whose they are, or what they are called:
    nobody takes them for answers.
    """
    return (*list_column_names("name"), *list_column_names("email"), *list_key_columns())


@cache
def list_logins() -> tuple[str, ...]:
    """The names of columns that identify a student where no column holds an id: of logins, then
    addresses.
    """
    logins = list_preferred_spellings(Message("roster.columns-login"))
    return (*logins, *list_column_names("email"))


def find_system(header: Sequence[str]) -> System | None:
    """The system whose export has this header, if it is one of those that are known.

    >>> find_system(["Student", "ID", "SIS User ID", "Section"]).name
    'Canvas'
    """
    keys = set(map(make_header_key, header))
    return next((system for system in SYSTEMS if system.signature <= keys), None)


def make_column_key(title: str) -> str:
    """The title of a column as it is compared: without a unit in brackets.

    >>> make_column_key("Extra time (min)")
    'extra time'
    """
    return _UNIT.sub("", make_header_key(title))
