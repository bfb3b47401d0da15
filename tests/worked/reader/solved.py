"""Equations against what the page says elsewhere: those that hold their unknowns, such as v_B cos
psi = v_A sin phi, and those of letters whose value the statement prints.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace

from tests.worked.reader.amounts import Amount, MixedUnits, Unreadable
from tests.worked.reader.equations import Line, Side
from tests.worked.reader.formula_reader import find_symbols, name_symbol, read_formula
from tests.worked.reader.rounding import find_room

CLOSE = 1e-9


def find_unsolved(lines: Iterable[Line], worth: Callable[[str], Amount]) -> Iterator[str]:
    """The equations with more on their left than a symbol or numbers that do not hold with the
    values that the page has told by its end.
    """
    for line in lines:
        symbols = {*find_symbols(line.left)}
        if not symbols or symbols == {name_symbol(line.left)}:
            continue
        sides = (Side("=", line.left), *line.sides)
        try:
            first, *others = (_read_side(side, worth) for side in sides)
        except Unreadable:
            continue
        except MixedUnits:
            yield line.text
            continue
        if not all(_agree(first, one) for one in others):
            yield line.text


def find_contradicted(
    lines: Iterable[Line], givens: Mapping[str, Amount], worth: Callable[[str], Amount]
) -> Iterator[str]:
    """The equations that end with another value of a given than the statement has."""
    for line in lines:
        given = givens.get(name_symbol(line.left))
        if given is None or not line.sides:
            continue
        try:
            end = read_formula(line.sides[-1].row, worth)
        except (Unreadable, MixedUnits):
            continue
        if not _agree(given, end):
            yield line.text


def _read_side(side: Side, worth: Callable[[str], Amount]) -> Amount:
    """What a side is worth, and how far rounding may have moved it."""
    amount = read_formula(side.row, worth)
    return replace(amount, room=find_room(side, amount))


def _agree(first: Amount, other: Amount) -> bool:
    """Whether two amounts are the same, to within what rounding can do."""
    room = first.room + other.room + CLOSE * (1 + abs(first.value))
    return first.has_unit_of(other) and abs(first.value - other.value) <= room
