"""Laws of a printed solution, proved from its document alone: it is read as a student reads it,
with the givens of the statement, its figure and a pencil.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence, Set
from dataclasses import dataclass, field, replace
from itertools import islice
from typing import Literal, TypeAlias

from kinegrade.language.math.tree import Fenced, Row
from kinegrade.problem.solution import Solution
from kinegrade.worked.case import write_row
from kinegrade.worked.document import Block, Prose
from tests.worked.reader.amounts import Amount, MixedUnits, Unreadable
from tests.worked.reader.answers import find_without_way
from tests.worked.reader.between import find_misnamed
from tests.worked.reader.checks import (
    find_doubled,
    find_short_about,
    find_unlettered,
    find_unrepeatable,
    is_off,
)
from tests.worked.reader.economy import find_repeated, find_unused
from tests.worked.reader.equations import Line, Said, Side, read_page
from tests.worked.reader.forms import (
    find_angles,
    find_arguments,
    find_located_points,
    is_decimal,
    is_exact_form,
    is_long,
)
from tests.worked.reader.formula_reader import (
    find_symbols,
    name_magnitude,
    name_symbol,
    read_formula,
)
from tests.worked.reader.givens import find_introduced, find_letters, read_givens
from tests.worked.reader.inclined import find_underived
from tests.worked.reader.independence import find_told_before
from tests.worked.reader.meanings import (
    find_negative_sizes,
    find_two_senses,
    find_unmarked,
    find_unnamed,
)
from tests.worked.reader.polygons import judge_polygons
from tests.worked.reader.rounding import find_room
from tests.worked.reader.signs import find_senseless
from tests.worked.reader.solved import find_contradicted, find_unsolved
from tests.worked.reader.tables import find_early, find_without_sense
from tests.worked.reader.zeros import find_rounded_away

Law: TypeAlias = Literal[
    "equal",
    "rounded",
    "exact",
    "settled",
    "short",
    "unit",
    "symbol",
    "angle",
    "point",
    "closed",
    "label",
    "corner",
    "used",
    "once",
    "inclined",
    "between",
    "redone",
    "figure",
    "sign",
    "sense",
    "early",
    "way",
    "marked",
    "named",
    "size",
    "senses",
    "lettered",
    "doubled",
    "signed",
    "zero",
    "independent",
    "solved",
    "given",
]
LAWS: dict[Law, str] = {
    "given": "a letter of the statement keeps the value that the statement prints",
    "solved": "an equation with its unknown on the left holds with what is found of that",
    "independent": "a check says of what has been found something else than each line before it",
    "equal": "a sign of equality joins equal values, to within what rounding can do",
    "rounded": "a rounded decimal stands after an approximate sign",
    "exact": "an exact form does not stand after numbers that have been rounded",
    "settled": "what is exact stands after a sign of equality",
    "short": "an exact form has less than 30 signs, its whole numbers at most 4 digits",
    "unit": "every number has its unit",
    "symbol": "every symbol is given, named by a table, found before, or found next",
    "angle": "every angle is given, found before, or what an angle in symbols amounts to",
    "point": "every point with coordinates is one of the statement, or is introduced as where wheels roll",
    "closed": "the arrows of a polygon follow one another from the origin to one end, on two sides",
    "label": "a symbol in a polygon stands beside an arrow as long as its value says",
    "corner": "the origin of a polygon and every corner that is a point's have a letter",
    "used": "what is found is asked, or used further down, by a check at least",
    "once": "no long sentence stands twice under a title",
    "inclined": "a vector normal to a line is projected by an angle that a sentence has derived",
    "between": "the angle between two lines is that between the directions of their letters",
    "sense": "a vector in a table has a direction, not the line alone",
    "early": "the length of an arm in a table is given, or has been found before the table",
    "way": "words beside the box of an answer with a sign say where it points",
    "marked": "what the indices n and t mark is said before them, or is asked for",
    "named": "the letters of angular accelerations are told in a sentence before equations have them",
    "size": "a letter defined as a magnitude has no negative value",
    "senses": "velocities of points along one line are positive in one sense, and accelerations",
    "lettered": "a side of a check begins with letters",
    "doubled": "a side of a check has each number once",
    "signed": "the letter of a motion in a check has been given a value with its sign before",
    "zero": "a coordinate of a point of the mechanism that is 0 is not found by rounding",
    "redone": "whoever works out a check with its printed numbers gets what it prints, to one of the fourth digit",
    "figure": "the printed numbers of a line amount to the figure said of them, to one of the fourth digit of a rounded one",
    "sign": "a number of fewer digits than rounded ones have is exact, and stands after a sign of equality",
}
NATURAL = (0.0, 90.0, 180.0, 270.0, 360.0)  # degrees
NEXT = 10  # lines after which an unknown of an equation has been found
CLOSE = 1e-9
Values: TypeAlias = Sequence[tuple[Side, Amount]]


@dataclass(frozen=True)
class Fault:
    """A law that a line breaks."""

    law: Law
    line: str


@dataclass
class _Known:
    """What a reader of the page knows at a line: what symbols are worth, which others have been
    named, and angles in degrees.
    """

    amounts: dict[str, Amount]
    letters: Set[str]
    named: set[str] = field(default_factory=set)
    angles: list[float] = field(default_factory=list)
    first: dict[str, Amount] = field(default_factory=dict)  # a letter has the sense of its first

    def worth(self, symbol: str) -> Amount:
        if symbol not in self.amounts:
            raise Unreadable(symbol)
        return self.amounts[symbol]

    def worth_at_first(self, symbol: str) -> Amount:
        if symbol not in self.first:
            raise Unreadable(symbol)
        return self.first[symbol]

    def learn(self, symbol: str, amount: Amount) -> None:
        self.amounts[symbol] = amount
        self.first.setdefault(symbol, amount)
        self.angles.append(abs(math.degrees(amount.value)) if amount.is_pure else math.nan)


def find_faults(blocks: Sequence[Block], solution: Solution) -> Iterator[Fault]:
    """All that is wrong with a page, line by line, then with its polygons."""
    told = (block.text for block in blocks if isinstance(block, Prose))
    introduced = (letter for text in told for letter in find_introduced(text))
    known = _Known({}, find_letters(solution).union(introduced))
    for symbol, amount in read_givens(solution):
        known.learn(symbol, amount)
    parts = list(read_page(blocks))
    for place, part in enumerate(parts):
        match part:
            case Said(row):
                yield from _judge_angles(row, write_row(row), known.angles)
                known.named.add(name_symbol(row))
            case Line():
                after = (one for one in parts[place:] if isinstance(one, Line))
                sought = {_name_left(one) for one in islice(after, NEXT)}
                yield from _judge_line(part, sought, known)
                if is_off(part):
                    yield Fault("figure", part.text)
    equations = [one for one in parts if isinstance(one, Line)]
    unsolved = find_unsolved(equations, known.worth_at_first)
    yield from (Fault("solved", line) for line in unsolved)
    contradicted = find_contradicted(equations, dict(read_givens(solution)), known.worth)
    yield from (Fault("given", line) for line in contradicted)
    yield from (Fault("used", line) for line in find_unused(blocks))
    yield from (Fault("once", sentence) for sentence in find_repeated(blocks))
    yield from (Fault("sense", column) for column in find_without_sense(blocks))
    yield from (Fault("early", length) for length in find_early(blocks, solution))
    yield from (Fault("way", line) for line in find_without_way(blocks, solution))
    yield from (Fault("inclined", line) for line in find_underived(blocks, solution))
    yield from (Fault("marked", formula) for formula in find_unmarked(blocks, solution))
    yield from (Fault("named", formula) for formula in find_unnamed(blocks, solution))
    misnamed = find_misnamed(blocks, solution, known.worth)
    yield from (Fault("between", angle) for angle in misnamed)
    yield from (Fault("size", line) for line in find_negative_sizes(blocks, solution))
    yield from (Fault("senses", line) for line in find_two_senses(blocks))
    yield from (Fault("lettered", side) for side in find_unlettered(blocks))
    yield from (Fault("doubled", side) for side in find_doubled(blocks))
    yield from (Fault("sign", line) for line in find_short_about(blocks))
    yield from (Fault("signed", side) for side in find_senseless(blocks, solution))
    yield from (Fault("zero", line) for line in find_rounded_away(blocks, solution))
    yield from (Fault("redone", check) for check in find_unrepeatable(blocks))
    given = {symbol for symbol, _ in read_givens(solution)}
    told_before = find_told_before(blocks, known.worth, given)
    yield from (Fault("independent", check) for check in told_before)
    for wrong in judge_polygons(blocks, known.amounts):
        yield Fault(wrong.law, wrong.line)


def _name_left(line: Line) -> str:
    """What an equation is about: the symbol on its left, or the one whose magnitude stands there."""
    match line.left:
        case (Fenced("|", row, _),):
            return name_magnitude(row)
        case _:
            return name_symbol(line.left)


def _judge_line(line: Line, sought: Set[str], known: _Known) -> Iterator[Fault]:
    """The faults of one equation; what it finds is known from then on."""
    rows = (line.left, *(side.row for side in line.sides))
    known.angles += [abs(angle) for row in rows for angle in _add_angles(row, known)]
    for row in rows:
        if is_long(row):
            yield Fault("short", line.text)
        if not is_decimal(row):
            yield from _judge_angles(row, line.text, known.angles)
        for symbol in find_symbols(row):
            if not {symbol, f"|{symbol}|"} & {*known.amounts, *known.named, *sought}:
                yield Fault("symbol", f"{symbol} in {line.text}")
        for point in find_located_points(row):
            if point not in known.letters:
                yield Fault("point", f"{point} in {line.text}")
    values: list[tuple[Side, Amount]] = []
    numbers = () if any(find_symbols(line.left)) else (Side("=", line.left),)
    for side in (*numbers, *line.sides) if line.sides else ():
        try:
            values.append(
                (side, _count_rounding(side, read_formula(side.row, known.worth), values))
            )
        except MixedUnits:
            yield Fault("unit", line.text)
        except Unreadable:
            continue
    yield from _judge_values(line, values)
    yield from _judge_exact_forms(line, values)
    _learn(line, values, known)
    found = (side.row for side in line.sides if is_decimal(side.row))
    known.angles += [angle for row in found for angle in find_angles(row)]


def _learn(line: Line, values: Values, known: _Known) -> None:
    """What stands alone on the left is known by the end of its equation."""
    left = _name_left(line)
    known.named.add(left)
    if not values or values[-1][0] is not line.sides[-1]:
        return
    if any(side.relation == r"\propto" for side in line.sides):
        return
    end = values[-1][1]
    precise = next((one.precise for _, one in values if one.precise is not None), None)
    known.learn(left, Amount(end.value, end.room, precise, end.metres, end.seconds))


def _judge_values(line: Line, values: Values) -> Iterator[Fault]:
    """Whether the sides are equal, and whether their signs say what is rounded."""
    room = find_room(*values[-1]) if values else 0.0
    for side, amount in values[:-1]:
        end = values[-1][1]
        if side.relation == r"\propto":
            continue
        if not amount.has_unit_of(end):
            yield Fault("unit", line.text)
        elif abs(amount.value - end.value) > amount.room + room + CLOSE * (1 + abs(end.value)):
            yield Fault("equal", line.text)
    before = [amount.precise for _, amount in values if amount.precise is not None]
    for side, amount in values:
        if is_decimal(side.row) and before:
            rounded = any(amount.precise is None for _, amount in values)
            if rounded and side.relation == r"\approx":
                continue
            yield from _judge_decimal(side, amount, before[0], line)


def _count_rounding(side: Side, amount: Amount, before: Values) -> Amount:
    """A decimal of few digits, where it rounds what has been rounded before."""
    rounds = side.relation == r"\approx" and is_decimal(side.row) and amount.value
    if rounds and before and before[-1][1].precise is None:
        return replace(amount, precise=None, room=find_room(side, amount))
    return amount


def _judge_exact_forms(line: Line, values: Values) -> Iterator[Fault]:
    """Whether every exact form stands before the rounded numbers that are put in, which do not
    amount to it.
    """
    rounded: list[float] = []
    for side, amount in values:
        if is_exact_form(side.row) and any(abs(one - amount.value) > CLOSE for one in rounded):
            yield Fault("exact", line.text)
        numbers = not list(find_symbols(side.row)) and not is_decimal(side.row)
        if numbers and amount.precise is None:
            rounded.append(amount.value)


def _judge_decimal(side: Side, amount: Amount, precise: float, line: Line) -> Iterator[Fault]:
    """Whether the sign before a decimal says whether it is rounded."""
    same = abs(precise - amount.value) <= CLOSE * abs(amount.value) + 1e-12
    if side.relation == "=" and not same:
        yield Fault("rounded", line.text)
    if side.relation == r"\approx" and same:
        yield Fault("settled", line.text)


def _judge_angles(row: Row, text: str, angles: Iterable[float]) -> Iterator[Fault]:
    """Whether every angle is one of those known."""
    known = (*NATURAL, *angles)
    for angle in find_angles(row):
        if not any(abs(angle - one) < 0.011 for one in known):
            yield Fault("angle", f"{angle:g} in {text}")


def _add_angles(row: Row, known: _Known) -> Iterator[float]:
    """What the sums of angles in sines and cosines amount to, in degrees."""
    for argument in find_arguments(row):
        try:
            yield math.degrees(read_formula(argument, known.worth).value)
        except (Unreadable, MixedUnits):
            continue
