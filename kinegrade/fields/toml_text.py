"""TOML as people write it: the tables of a text, or the mistake and its line where it is not TOML.

Numbers with a point keep their digits, so that nothing is rounded on reading. `document` adds the
name of the file.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable
from typing import Any
from unicodedata import normalize

from kinegrade.errors import TomlError
from kinegrade.fields.digits import TOO_DEEP, TOO_LARGE, Digits, Unbounded, require_bounded
from kinegrade.language.lines import show_in_one_line

_STRING = re.compile(r'"(?:\\.|[^"\\])*"|' + r"'[^']*'")
_PLACE = re.compile(r" \(at line (\d+), column \d+\)")
_LONGEST_SHOWN = 40
_MOST_DOTS = 200  # in one line, not counting those inside numbers
_DECIMAL = re.compile(r"[0-9]+\.[0-9]+")
_TWICE = "Cannot overwrite a value"  # the parser's words for a duplicate key
_FULL_WIDTH = "，．：；＝（）［］｛｝＃％／０１２３４５６７８９"
_PLAIN_VALUE = re.compile(r"[-+]?\d[\d_.eE+-]*|true|false", re.ASCII)
_Advice = Callable[[re.Match[str]], str]


def read_toml(text: str) -> dict[str, Any]:
    """The tables of a TOML text; numbers with a point are Digits. Raises TomlError with the mistake
    and its line.
    """
    _require_few_dots(text)
    try:
        tables = tomllib.loads(text, parse_float=Digits)
        require_bounded(tables)
    except tomllib.TOMLDecodeError as error:
        raise _named(text, str(error)) from error
    except Unbounded as error:
        raise TomlError(str(error)) from error
    except RecursionError as error:
        raise TomlError(TOO_DEEP) from error
    except ValueError as error:  # Python reads no integer of more than 4,300 digits
        raise TomlError(TOO_LARGE) from error
    return tables


def _require_few_dots(text: str) -> None:
    """Raises TomlError for keys of hundreds of parts, which would occupy the parser for minutes."""
    for number, line in enumerate(text.split("\n"), 1):
        if line.count(".") > _MOST_DOTS and _DECIMAL.sub("", line).count(".") > _MOST_DOTS:
            raise TomlError(TOO_DEEP, number)


def _named(text: str, fault: str) -> TomlError:
    """The parser's fault, or the mistake behind it, with its line."""
    place = _PLACE.search(fault)
    if place is None:
        return TomlError(show_in_one_line(fault))
    number = int(place[1])
    line = text.split("\n")[number - 1]
    slip = _slip_in(line)
    if not slip and fault.startswith(_TWICE):
        key = line.partition("=")[0].strip()
        slip = (
            f"{show_in_one_line(key[:_LONGEST_SHOWN])}: stands "
            "in this table before: leave one of the "
            "two out"
        )
    return TomlError(slip or show_in_one_line(_PLACE.sub("", fault)), number)


def _slip_in(line: str) -> str:
    """What someone wrote on a line that TOML does not allow, and what to write instead; "" where it
    is none of the usual mistakes.

    >>> _slip_in("draw = [30°, 60°]")
    '30°: a number without its unit is expected: write 30, and unit = "deg"'
    >>> _slip_in("date = 3.12.2026")
    '3.12.2026: write a date as 2026-12-03, or as a text in quotation marks, "3.12.2026"'
    """
    outside = _STRING.sub('""', line).partition("#")[0]
    for pattern, advice in _SLIPS:
        found = pattern.search(outside)
        if found is not None:
            return show_in_one_line(advice(found))
    return "" if outside.lstrip().startswith("[") else _unquoted(outside)


def _dotted_date(found: re.Match[str]) -> str:
    """A date as much of Europe writes it: day, month, year."""
    day, month, year = (part.zfill(2) for part in found.groups())
    text = "".join(found[0].split())
    return (
        f"{text}: write a date as {year}-{month}-{day}, "
        f'or as a text in quotation marks, "{found[0]}"'
    )


def _other_date(found: re.Match[str]) -> str:
    """A date whose day and month cannot be distinguished, or that lacks a zero."""
    return (
        f"{found[0]}: write a date as year-month-day, like 2026-05-01, "
        f'or as a text in quotation marks, "{found[0]}"'
    )


_SLIPS: tuple[tuple[re.Pattern[str], _Advice], ...] = (
    (
        re.compile("[“”„‟«»‘’‚‛＂＇]"),
        lambda found: f'{found[0]}: a curly quotation mark: write straight ones, "..."',
    ),
    (
        re.compile(r"""(?<!["'])["'](?!["']).*"""),  # outside the texts that are closed
        lambda found: (
            f"{found[0][:_LONGEST_SHOWN]}: a quotation mark without its partner: close it"
        ),
    ),
    (
        re.compile(r"(-?\d+(?:\.\d+)?)\s*[°º˚]"),
        lambda found: (
            f'{found[0]}: a number without its unit is expected: write {found[1]}, and unit = "deg"'
        ),
    ),
    (
        re.compile(f"[{_FULL_WIDTH}]"),
        lambda found: f'{found[0]}: a full-width character: write "{normalize("NFKC", found[0])}"',
    ),
    (re.compile(r"(?<![\d.])(\d{1,2})\.\s?(\d{1,2})\.\s?(\d{4})(?!\d)"), _dotted_date),
    (re.compile(r"\d{1,2}/\d{1,2}/\d{4}|\d{4}[-./]\d{1,2}[-./]\d{1,2}"), _other_date),
    (
        re.compile(r"[\d\"'\]}]\s*;"),
        lambda _: ";: write a comma between entries, not a semicolon",
    ),
    (
        re.compile(r"^[^{}]*\{[^{}]*$"),
        lambda _: "{ is not closed: write } at the end of the table, in the same line",
    ),
    (
        re.compile(r"=\s*(-?\d+),(\d+)\s*(?:$|[,}])"),
        lambda found: (
            f"{found[1]},{found[2]}: a decimal comma: write a point, {found[1]}.{found[2]}"
        ),
    ),
    (
        re.compile(r"\d+(?:\.\d+)?\s*%"),
        lambda found: f'{found[0]}: write a percentage in quotation marks, "{found[0]}"',
    ),
    (
        re.compile(r"^\s*([\w-]+)\s*:"),
        lambda found: f"{found[1]}: write = between a name and its value, not a colon",
    ),
)
_TRUE, _FALSE = ("true", "yes", "on"), ("false", "no", "off")
_BOOLEANS = {**dict.fromkeys(_TRUE, "true"), **dict.fromkeys(_FALSE, "false")}
_VALUE = re.compile(r"(?:=|\[|,)\s*([^\s\"'\[\]{},=#][^\"'\[\]{},=#]*)")


def _unquoted(outside: str) -> str:
    """The first value that is a text without quotation marks; "" where there is none."""
    for found in _VALUE.finditer(outside):
        value = found[1].strip()
        plain = _BOOLEANS.get(value.lower(), value)
        if plain != value:
            return f"{value}: write {plain}"
        if outside[found.end() :].lstrip().startswith("="):
            continue  # a key, after a comma in an inline table
        if not _PLAIN_VALUE.fullmatch(value) and len(value) <= _LONGEST_SHOWN:
            return f'{value}: a text or an expression needs quotation marks: write "{value}"'
    return ""
