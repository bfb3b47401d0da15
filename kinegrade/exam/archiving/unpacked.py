"""Faults of an archive's files, which name them as they are in the archive: the folder in which it
was unpacked is gone when they are read.
"""

from __future__ import annotations

from dataclasses import replace
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import assert_never

from kinegrade.errors import Problem
from kinegrade.language.message import (
    ByLanguage,
    Fault,
    Listing,
    Message,
    Noun,
    Part,
    Quoted,
    Text,
)


def name_inside(problem: Problem, folder: Path) -> Problem:
    """The same problem with paths from that folder on.

    >>> name_inside(Fault("unpacked/MARKS/grades.csv", "is empty"), Path("unpacked"))
    Fault(where='MARKS/grades.csv', what='is empty', expected='', do='')
    """
    match problem:
        case Fault():
            return _name_fault(problem, folder)
        case str() | Message():
            return _name_text(problem, folder)
        case _:
            assert_never(problem)


def _name_fault(fault: Fault, folder: Path) -> Fault:
    return replace(
        fault,
        where=_name_text(fault.where, folder),
        what=name_inside(fault.what, folder),
        expected=_name_text(fault.expected, folder),
        do=_name_text(fault.do, folder),
    )


def _name_text(text: Text, folder: Path) -> Text:
    match text:
        case str():
            return text.replace(f"{folder}/", "")
        case Message(key=key, parts=parts):
            return Message(key, **{name: _name_part(part, folder) for name, part in parts.items()})
        case _:
            assert_never(text)


def _name_part(part: Part, folder: Path) -> Part:
    match part:
        case str() | Message():
            return _name_text(part, folder)
        case Fault():
            return _name_fault(part, folder)
        case Quoted(text=text):
            return Quoted(text.replace(f"{folder}/", ""))
        case Listing(items=items):
            return replace(part, items=tuple(_name_part(each, folder) for each in items))
        case int() | Decimal() | Fraction() | Noun() | ByLanguage():
            return part
        case _:
            assert_never(part)
