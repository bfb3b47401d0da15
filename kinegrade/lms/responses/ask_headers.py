"""Which question of a download is which ask: by the ask's name in the question's title, or by
order where titles name none.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Mapping, Sequence

from kinegrade.errors import TableError
from kinegrade.exam.folder.records import ExamHead
from kinegrade.files.cell_text import make_header_key
from kinegrade.files.tables import Table
from kinegrade.language.message import Fault, Listing, Message, Quoted, list_plainly

_NAME_ASKS = Message("responses.name-asks")
_DERIVED = re.compile(r"\S.{0,60} [-–] ", re.DOTALL)
_MOST_DERIVED = 2


def asks_by_name(
    header: Sequence[str], places: Sequence[int], head: ExamHead
) -> Mapping[str, tuple[int, ...]]:
    """The columns whose titles hold an ask's name, alone or in brackets: q1.v_B, or v_B where only
    one ask has it.
    """
    names = _names(head)
    found: dict[str, list[int]] = defaultdict(list)
    for place in places:
        named = _named(header[place], names)
        if len(named) == 1:
            found[named.pop()].append(place)
    return {column: tuple(found[column]) for column in head.columns if column in found}


def _names(head: ExamHead) -> Mapping[str, str]:
    """The asks by their full names and, where it is unique, by their short name in brackets."""
    short: dict[str, list[str]] = defaultdict(list)
    for column in head.columns:
        short[f"[{column.partition('.')[2]}]"].append(column)
    return {column: column for column in head.columns} | {
        name: columns[0] for name, columns in short.items() if len(columns) == 1
    }


def _named(title: str, names: Mapping[str, str]) -> set[str]:
    """The asks that a title names: spelt exactly, else regardless of case where that leaves one."""
    exact = {column for name, column in names.items() if _holds(title, name)}
    if exact:
        return exact
    key = make_header_key(title)
    return {column for name, column in names.items() if _holds(key, make_header_key(name))}


def _holds(title: str, name: str) -> bool:
    """Whether a title contains a name, not as part of a longer one."""
    edge = "" if name.startswith("[") else r"[\w.]"
    before, after = (f"(?<!{edge})", r"(?![\w'′])") if edge else ("", "")
    return name in title and re.search(f"{before}{re.escape(name)}{after}", title) is not None


def expect_exam(head: ExamHead, advice: Message) -> Message:
    """What the exam has, and what to do where a download does not agree with it."""
    return Message(
        "responses.exam",
        asks=Message("responses.asks", count=len(head.columns)),
        questions=Message("responses.questions", count=len(head.questions)),
        counts=list_plainly(f"{each.question}: {len(each.asks)}" for each in head.questions),
        advice=advice,
    )


def columns_of_asks(table: Table, places: Sequence[int], head: ExamHead) -> Mapping[str, int]:
    """The column of each ask among those that hold answers; asks without one are left out where
    others are named.

    Raises TableError where titles name no ask and there are not as many columns as asks, or an ask
    has two.
    """
    named = asks_by_name(table.header, places, head)
    twice = [
        Fault(
            table.file,
            Message("responses.named-twice", ask=column, columns=_shown(table, found)),
            Message("responses.one-column"),
            _NAME_ASKS,
        )
        for column, found in named.items()
        if len(found) > 1
    ]
    if twice:
        raise TableError(*twice)
    if named:
        return {column: places[0] for column, places in named.items()}
    if len(places) != len(head.columns):
        problem = (
            Message("responses.columns", count=len(places), columns=_shown(table, places[:6]))
            if places
            else Message("responses.no-columns")
        )
        raise TableError(Fault(table.file, problem, do=expect_exam(head, _NAME_ASKS)))
    return dict(zip(head.columns, places, strict=True))


def _shown(table: Table, places: Sequence[int]) -> Listing:
    return list_plainly(Quoted(" ".join(table.header[place].split())[:60]) for place in places)


def without_derived(header: Sequence[str], places: Sequence[int]) -> tuple[int, ...]:
    """The columns that are questions, not the points or the feedback of one before: "Points - Q",
    "Q [Score]".
    """
    return tuple(
        place
        for place in places
        if not any(
            _is_derived(header[place], header[before])
            for before in range(max(place - _MOST_DERIVED, 0), place)
        )
    )


def _is_derived(title: str, question: str) -> bool:
    title, question = title.strip(), question.strip()
    if not question or len(title) <= len(question):
        return False
    if title.endswith(question):
        return _DERIVED.fullmatch(title[: -len(question)]) is not None
    return title.startswith(f"{question} [") and title.endswith("]")
