"""What the grade files of a learning management system look like: one frozen table for each system,
no code.

The tables are in `systems`; `fill_in` reads and `from_scratch` writes by them.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from os import PathLike
from typing import Literal

from kinegrade.language.message import Message, Text

Field = Literal["id", "login", "email"]
Role = Literal[
    "id",
    "login",
    "email",
    "name",
    "name and id",
    "grade",
    "letter",
    "feedback",
    "feedback format",
    "fixed",
]
FIELDS: tuple[Field, ...] = ("id", "login", "email")
ItemKind = Literal["points", "percentage", "feedback", "text", "open"]
ItemWords = Mapping[ItemKind, tuple[str, ...]]  # the words after a title, by what the column holds


@dataclass(frozen=True, slots=True)
class Key:
    """A column by which the system identifies students: under any of these headers, or always at
    one position.

    `prefix` precedes the value in the file and is not part of it.
    """

    field: Field
    headers: tuple[str, ...] = ()
    position: int | None = None
    ignores_case: bool = False
    prefix: str = ""


@dataclass(frozen=True, slots=True)
class Channel:
    """The columns of a comment for the student: headers with {title}, and one for its format."""

    headers: tuple[str, ...]
    html: bool = False
    format_header: str = ""
    format_text: str = ""


@dataclass(frozen=True, slots=True)
class Download:
    """A file that is downloaded from the system, filled in and uploaded again.

    `item` matches the header of a grade column (groups title and, optionally, maximum), from
    position `first_item` on. `any_item` allows another column to be named, where the instructor
    maps columns in the system anyway. `required` are the headers that identify this kind of file.
    With `item_words` headers may be in any language: columns are then found by their content, and
    these words only confirm. Patterns of rows match the first cell. `closed` gives the cells into
    which no grade is written, and why; `locked`, a header and a text, the rows. `beginning` is what
    the header, joined by commas, must begin with; `broken_beginning` is a beginning of the text
    that the system cannot read; `misread` is a cell that it takes for another number. `test_person`
    matches the beginning of the row, its cells joined by ", ", of a test student of the system.
    """

    keys: tuple[Key, ...]
    item: re.Pattern[str]
    first_item: int = 0
    any_item: bool = False
    not_item: re.Pattern[str] | None = None
    required: tuple[str, ...] = ()
    maximum_row: re.Pattern[str] | None = None
    maximum_column: str = ""
    item_words: ItemWords | None = None
    read_only: re.Pattern[str] | None = None
    skipped_row: re.Pattern[str] | None = None
    closed: Mapping[str, Message] = field(default_factory=dict)
    locked: tuple[str, str] = ("", "")
    channel: Channel | None = None
    encodings: tuple[str, ...] = ()
    beginning: re.Pattern[str] | None = None
    broken_beginning: re.Pattern[str] | None = None
    misread: re.Pattern[str] | None = None
    test_person: re.Pattern[str] | None = None
    decimal_comma_with_semicolon: bool = False
    most_bytes: int | None = None


@dataclass(frozen=True, slots=True)
class Column:
    """A column of a new file: its header with {title} and {maximum}, or an entry of the catalogues,
    and `text`, a prefix or a fixed content.

    A "grade" is the points, a "letter" what a scale gives for the total.
    A feedback column is `html` where the system shows feedback as a web page. A column of keys may
    `also` hold those of other fields.
    """

    header: Text
    role: Role
    text: str = ""
    also: tuple[Field, ...] = ()
    html: bool = False

    def holds(self, key: Field) -> bool:
        """Whether this is the column of such keys."""
        return key == self.role or key in self.also


@dataclass(frozen=True, slots=True)
class NewFile:
    """A file written from scratch; `title` is the item's default title, empty where one must be
    given.

    A key column that is not chosen is left out, or left empty with `keeps_keys`. `header_needed` is
    set where a grade column is identified by a number that only the system assigns, so that its
    header must be given. Titles that match a pattern in `unfit` are refused for the reason beside
    it.
    """

    columns: tuple[Column, ...]
    key: Field
    title: Text = ""
    keeps_keys: bool = False
    quotes_all: bool = False
    mark: bool = False
    header_needed: bool = False
    unfit: tuple[tuple[re.Pattern[str], Message], ...] = ()


@dataclass(frozen=True, slots=True)
class Dialect:
    """One system: the downloads that it takes back, the new file that it takes, and how many
    decimals of a grade it keeps.
    """

    name: Text
    places: int
    downloads: tuple[Download, ...] = ()
    new_file: NewFile | None = None

    @property
    def speaks(self) -> bool:
        """Whether a new file has headers in the language of the exam."""
        columns = () if self.new_file is None else self.new_file.columns
        return any(isinstance(column.header, Message) for column in columns)


@dataclass(frozen=True, slots=True)
class ExportOptions:
    """What the instructor asks for.

    `into` is a downloaded file to be filled in, in place of a new one; with `overwrite`, cells of a
    workbook that hold something else are filled, too; `id_column` is the header or letter of its
    column of ids, empty for the one that is called so. `by` are the fields to match or to write,
    empty for the system's default; `columns` the headers by item, the total's under
    ""; `feedback` None where the system decides; `maximum` the item's maximum in the system, to
    which grades are scaled; `scale` scales to the maximum that the file states; `language` that of
    translated headers, None for the exam's; with `of_scale` a workbook gets the grades of the scale
    in place of points.
    """

    by: tuple[Field, ...] = ()
    columns: Mapping[str, str] = field(default_factory=dict)
    title: str = ""
    per_question: bool = False
    feedback: bool | None = None
    ungraded: bool = False
    scale: bool = False
    maximum: Fraction | int | None = None
    language: str | None = None
    into: str | PathLike[str] | None = None
    overwrite: bool = False
    id_column: str = ""
    of_scale: bool = False
