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
from kinegrade.files.fields.digits import TOO_DEEP, TOO_LARGE, Digits, Unbounded, require_bounded
from kinegrade.language.lines import show_in_one_line
from kinegrade.language.message import Message, Quoted

_STRING = re.compile(r'"(?:\\.|[^"\\])*"|' + r"'[^']*'")
_PLACE = re.compile(r" \(at line (\d+), column \d+\)")
_LONGEST_SHOWN = 40
_MOST_DOTS = 200  # in one line, not counting those inside numbers
_DECIMAL = re.compile(r"[0-9]+\.[0-9]+")
_TWICE = "Cannot overwrite a value"  # the parser's words for a duplicate key
_FULL_WIDTH = "，．：；＝（）［］｛｝＃％／０１２３４５６７８９"
_PLAIN_VALUE = re.compile(r"[-+]?\d[\d_.eE+-]*|true|false", re.ASCII)
_Advice = Callable[[re.Match[str]], Message]


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
        raise TomlError(error.reason) from error
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
    if slip is None and fault.startswith(_TWICE):
        key = line.partition("=")[0].strip()
        slip = Message("fields.twice-in-table", key=show_in_one_line(key[:_LONGEST_SHOWN]))
    return TomlError(slip or show_in_one_line(_PLACE.sub("", fault)), number)


def _slip_in(line: str) -> Message | None:
    """What someone wrote on a line that TOML does not allow, and what to write instead; None where
    it is none of the usual mistakes.

    >>> _slip_in("draw = [30°, 60°]")
    Message('fields.slip-degrees', found='30°', number='30')
    >>> _slip_in("date = 3.12.2026")
    Message('fields.slip-dotted-date', found='3.12.2026', date='2026-12-03')
    """
    outside = _STRING.sub('""', line).partition("#")[0]
    for pattern, advice in _SLIPS:
        found = pattern.search(outside)
        if found is not None:
            return advice(found)
    return None if outside.lstrip().startswith("[") else _unquoted(outside)


def _dotted_date(found: re.Match[str]) -> Message:
    """A date as much of Europe writes it: day, month, year."""
    day, month, year = (part.zfill(2) for part in found.groups())
    text = "".join(found[0].split())
    return Message("fields.slip-dotted-date", found=text, date=f"{year}-{month}-{day}")


_SLIPS: tuple[tuple[re.Pattern[str], _Advice], ...] = (
    (
        re.compile("[“”„‟«»‘’‚‛＂＇]"),
        lambda found: Message("fields.slip-curly-mark", found=found[0]),
    ),
    (
        re.compile(r"""(?<!["'])["'](?!["']).*"""),  # outside the texts that are closed
        lambda found: Message("fields.slip-open-mark", found=found[0][:_LONGEST_SHOWN]),
    ),
    (
        re.compile(r"(-?\d+(?:\.\d+)?)\s*[°º˚]"),
        lambda found: Message("fields.slip-degrees", found=found[0], number=found[1]),
    ),
    (
        re.compile(f"[{_FULL_WIDTH}]"),
        lambda found: Message(
            "fields.slip-full-width", found=found[0], plain=normalize("NFKC", found[0])
        ),
    ),
    (re.compile(r"(?<![\d.])(\d{1,2})\.\s?(\d{1,2})\.\s?(\d{4})(?!\d)"), _dotted_date),
    (  # a date whose day and month cannot be distinguished, or that lacks a zero
        re.compile(r"\d{1,2}/\d{1,2}/\d{4}|\d{4}[-./]\d{1,2}[-./]\d{1,2}"),
        lambda found: Message("fields.slip-other-date", found=found[0]),
    ),
    (re.compile(r"[\d\"'\]}]\s*;"), lambda _: Message("fields.slip-semicolon")),
    (re.compile(r"^[^{}]*\{[^{}]*$"), lambda _: Message("fields.slip-open-table")),
    (
        re.compile(r"=\s*(-?\d+),(\d+)\s*(?:$|[,}])"),
        lambda found: Message("fields.slip-decimal-comma", whole=found[1], decimals=found[2]),
    ),
    (
        re.compile(r"\d+(?:\.\d+)?\s*%"),
        lambda found: Message("fields.slip-percentage", found=found[0]),
    ),
    (
        re.compile(r"^\s*([\w-]*[^\W\x00-\x7f][\w-]*)\s*="),
        lambda found: Message("fields.slip-other-letters", name=Quoted(found[1])),
    ),
    (
        re.compile(r"^\s*([\w-]+)\s*:"),
        lambda found: Message("fields.slip-colon", name=found[1]),
    ),
)
_TRUE, _FALSE = ("true", "yes", "on"), ("false", "no", "off")
_BOOLEANS = {**dict.fromkeys(_TRUE, "true"), **dict.fromkeys(_FALSE, "false")}
_VALUE = re.compile(r"(?:=|\[|,)\s*([^\s\"'\[\]{},=#][^\"'\[\]{},=#]*)")


def _unquoted(outside: str) -> Message | None:
    """The first value that is a text without quotation marks; None where there is none."""
    for found in _VALUE.finditer(outside):
        value = found[1].strip()
        plain = _BOOLEANS.get(value.lower(), value)
        if plain != value:
            return Message("fields.slip-word", found=value, plain=plain)
        if outside[found.end() :].lstrip().startswith("="):
            continue  # a key, after a comma in an inline table
        if not _PLAIN_VALUE.fullmatch(value) and len(value) <= _LONGEST_SHOWN:
            return Message("fields.slip-unquoted", found=value)
    return None
