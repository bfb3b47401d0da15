"""What a printed formula looks like: decimals, exact forms, angles, the letters of points."""

from __future__ import annotations

from collections.abc import Iterator

from kinegrade.language.math.tree import (
    DEGREE,
    Fenced,
    Function,
    Letter,
    Number,
    Quotient,
    Root,
    Row,
    Scripts,
    Sign,
    list_nodes,
    list_parts,
)
from tests.worked.reader.formula_reader import join_decimals, name_symbol

LONGEST = 30
LONGEST_WHOLE = 4


def is_decimal(row: Row) -> bool:
    """Whether a side is a decimal with its unit, and nothing else."""
    forms = (Quotient, Root, Function, Letter, Fenced)
    numbers = [node for node in join_decimals(row) if isinstance(node, Number) or _is_angle(node)]
    apart = any(isinstance(node, forms) or node == Sign("(") for node in list_nodes(row))
    return len(numbers) == 1 and not apart


def is_long(row: Row) -> bool:
    """Whether an exact form, of roots and fractions of whole numbers, is too long to be read."""
    nodes = list(list_nodes(row))
    if not is_exact_form(row):
        return False
    digits = [node.digits for node in nodes if isinstance(node, Number)]
    signs = sum(isinstance(node, Sign) for node in nodes)
    roots = sum(2 for node in nodes if isinstance(node, Root | Function))
    turned = any(isinstance(node, Function) for node in nodes) and Letter("pi") in nodes
    longest = max(map(len, digits), default=0)
    return turned or longest > LONGEST_WHOLE or sum(map(len, digits)) + signs + roots >= LONGEST


def is_exact_form(row: Row) -> bool:
    """Whether a formula is made of whole numbers, with a root or a fraction among them."""
    nodes = list(list_nodes(row))
    formed = any(isinstance(node, Root | Quotient | Function) for node in nodes)
    lettered = any(isinstance(node, Letter) and node.name != "pi" for node in nodes)
    decimal = any(
        (isinstance(node, Number) and "." in node.digits) or node == Sign("{,}") or _is_angle(node)
        for node in nodes
    )
    return formed and not lettered and not decimal


def _is_angle(node: object) -> bool:
    """Whether a node is a number of degrees."""
    return isinstance(node, Scripts) and node.upper == DEGREE and isinstance(node.base, Number)


def find_angles(row: Row) -> Iterator[float]:
    """All numbers of degrees that a formula holds."""
    for node in join_decimals(row):
        if isinstance(node, Scripts) and isinstance(node.base, Number) and _is_angle(node):
            yield float(node.base.digits)
        for part in list_parts(node):
            yield from find_angles(part)


def find_arguments(row: Row) -> Iterator[Row]:
    """What functions of a formula are of, where that stands in brackets or is a multiple or a
    part.
    """
    for place, node in enumerate(row):
        function = node.base if isinstance(node, Scripts) else node
        rest = row[place + 1 :]
        if isinstance(function, Function) and rest[:1] == (Sign("("),):
            yield rest[1 : _find_end(rest)]
        elif isinstance(function, Function) and rest and isinstance(rest[0], Number):
            corner = rest[1:2] == (Sign(r"\angle"),)
            yield rest[: 2 + _count_letters(rest[2:])] if corner else rest[:2]
        elif isinstance(function, Function) and rest and isinstance(rest[0], Quotient):
            yield rest[:1]
        for part in list_parts(node):
            yield from find_arguments(part)


def _count_letters(row: Row) -> int:
    """How many letters, with or without an index, a formula begins with."""
    others = (place for place, node in enumerate(row) if not isinstance(node, Letter | Scripts))
    return next(others, len(row))


def _find_end(row: Row) -> int:
    """Where the bracket ends with which a row begins."""
    depth = 0
    for place, node in enumerate(row):
        sign = node.base if isinstance(node, Scripts) else node
        depth += (sign == Sign("(")) - (sign == Sign(")"))
        if not depth:
            return place
    return len(row)


def find_located_points(row: Row) -> Iterator[str]:
    """The points of which a formula has coordinates."""
    for node in list_nodes(row):
        if isinstance(node, Scripts) and node.base in (Letter("x"), Letter("y")) and node.lower:
            yield name_symbol(node.lower)


def measure_last_digit(row: Row, value: float) -> float:
    """One of the last digit of a decimal that is worth so much; zeros at the end of a whole number
    only hold its place.
    """
    digits = ".".join(node.digits for node in list_nodes(row) if isinstance(node, Number))
    places = len(digits.partition(".")[2])
    zeros = 0 if places else len(digits) - len(digits.rstrip("0"))
    return float(abs(value / float(digits)) * 10.0 ** (zeros - places))


def measure_usual_digit(row: Row, value: float) -> float:
    """One of the fourth digit of a decimal that is worth so much, of the second decimal of an
    angle; of the last digit where it has fewer.
    """
    digits = ".".join(node.digits for node in list_nodes(row) if isinstance(node, Number))
    places = len(digits.partition(".")[2])
    count = len(digits.replace(".", "").lstrip("0"))
    more = places - 2 if any(find_angles(row)) else count - 4
    return measure_last_digit(row, value) * 10.0 ** max(more, 0)
