"""The questions of a bank that have named steps in place of a mechanism, and are drawn, printed
and marked as those of templates are.

[[questions]]
name = "car-from-rest"
statement = "A car starts from rest with the acceleration {{ a }}. How fast is it after {{ t }}?"
parameters.a = { unit = "m/s^2", draw = ["3/2", 2, "5/2"] }
parameters.t = { unit = "s", draw = [4, 5, 6] }
steps.v = "a*t"
asks.v = { unit = "m/s", points = 3, means = "its speed" }
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from msgspec.structs import replace

from kinegrade.errors import FieldError
from kinegrade.exam.bank.blueprint import BankAsk
from kinegrade.exam.bank.keys import OWN_ASK
from kinegrade.exam.bank.terms import BankTolerance, read_bank_tolerance, read_points
from kinegrade.files.fields.table import Table
from kinegrade.files.fields.toml_writing import write_toml
from kinegrade.files.fields.values import found
from kinegrade.language.message import Message, Quoted
from kinegrade.problem.statement_faults import find_statement_faults
from kinegrade.problem.template.library.library import load_kept_template
from kinegrade.problem.template.sections.stepwise_keys import STEPWISE
from kinegrade.problem.template.template import Template, TemplateFile
from kinegrade.students.mistaking.mistake_names import MISTAKE_NAMES

_NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*", re.ASCII)
_NO_FILE = TemplateFile("")


@dataclass(frozen=True)
class OwnQuestion:
    """A question as an entry states it: its template, which has steps, and what is asked of it."""

    template: Template
    asks: tuple[BankAsk, ...]


def read_own_question(
    entry: Table, wider: BankTolerance, kept: Path | None = None
) -> OwnQuestion | None:
    """The question of an entry with steps; `kept` is the folder of an exam that keeps its template.
    None after a fault.
    """
    name = entry.required("name", _read_name)
    asks = _read_asks(entry, wider)
    if kept is not None and name is not None:
        return OwnQuestion(load_kept_template(name, kept), asks)
    content = {key: _select_stated(key, entry.content[key]) for key in STEPWISE if key in entry}
    inside = Table(entry.faults.inside(entry.place), (), content, entry.excused)
    # Few banks have questions of their own
    from kinegrade.problem.template.library.stepwise import read_stepwise  # noqa: PLC0415

    template = read_stepwise(name or "", inside, _NO_FILE)
    _refuse_known_mistakes(entry)
    if name is None or template is None or entry.faults.within(entry.place):
        return None
    own = replace(template, file=TemplateFile(write_toml(content)))
    for fault in find_statement_faults(own):
        entry.faults.note((*entry.place, "statement"), fault.what)
    return OwnQuestion(own, asks)


def list_mistake_names(questions: object) -> tuple[str, ...]:
    """The identifiers of all known mistakes, and of those that entries of a bank state, sound or
    not.
    """
    entries = questions if isinstance(questions, list) else []
    tables = (entry.get("mistakes") for entry in entries if isinstance(entry, dict))
    own = (name for table in tables if isinstance(table, dict) for name in table)
    return (*MISTAKE_NAMES, *own)


def _read_name(value: object) -> str:
    """A name that can stand for a file."""
    if isinstance(value, str) and _NAME.fullmatch(value):
        return str(value)
    raise FieldError(found(value), Message("bank.own-name"))


def _select_stated(key: str, value: object) -> object:
    """What the template states under a key: of asks all but points and tolerance, which are the
    bank's.
    """
    if key != "asks" or not isinstance(value, dict):
        return value
    return {name: _drop_points(ask) for name, ask in value.items()}


def _drop_points(ask: object) -> object:
    if not isinstance(ask, dict):
        return ask
    return {key: value for key, value in ask.items() if key not in OWN_ASK}


def _read_asks(entry: Table, wider: BankTolerance) -> tuple[BankAsk, ...]:
    """What is asked, with points. What is no table is a fault that the template's reader notes."""
    if not entry.holds_table("asks"):
        return ()
    asks = entry.table("asks")
    read = (_read_ask(name, asks.table(name), wider) for name in asks if asks.holds_table(name))
    return tuple(ask for ask in read if ask is not None)


def _read_ask(name: str, table: Table, wider: BankTolerance) -> BankAsk | None:
    points = table.required("points", read_points)
    stated = read_bank_tolerance(table, wider)
    if points is None:
        return None
    return BankAsk(name, points, stated.tolerance, stated.honest)


def _refuse_known_mistakes(entry: Table) -> None:
    """A fault for each mistake that is called like one that kinegrade knows."""
    for name in entry.table("mistakes") if entry.holds_table("mistakes") else ():
        if name in MISTAKE_NAMES:
            what = Message("bank.mistake-name-taken", name=Quoted(name))
            entry.faults.note((*entry.place, "mistakes", name), what, do=Message("bank.rename"))
