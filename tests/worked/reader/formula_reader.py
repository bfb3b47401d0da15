"""A second opinion on what a printed formula is worth: its tree is read by the rules of print
alone, without the formulas that the program builds.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace

from msgspec import structs

from kinegrade.language.math.tree import (
    DEGREE,
    Fenced,
    Function,
    Letter,
    Lettering,
    Node,
    Number,
    Quotient,
    Root,
    Row,
    Scripts,
    Sign,
    Space,
    Unit,
)
from kinegrade.worked.case import write_row
from tests.worked.reader.amounts import (
    Amount,
    Unreadable,
    add,
    apply,
    make_exact,
    multiply,
    raise_to,
)

UNITS: Mapping[str, tuple[float, float, float]] = {
    "m": (1.0, 1, 0),
    "cm": (0.01, 1, 0),
    "mm": (0.001, 1, 0),
    "km": (1000.0, 1, 0),
    "s": (1.0, 0, 1),
    "min": (60.0, 0, 1),
    "h": (3600.0, 0, 1),
    "r": (1.0, 0, 0),  # of a number of turns n; an angular velocity is 2 pi n
    "rad": (1.0, 0, 0),
    "1": (1.0, 0, 0),
}
ROUNDED = 4  # significant digits: a decimal of fewer digits is not a rounded one
Worth = Callable[[str], Amount]


def read_formula(row: Row, worth: Worth) -> Amount:
    """The amount of a formula; `worth` gives that of a symbol, or raises Unreadable."""
    reader = _Reader(join_decimals(row), worth)
    amount = reader.sum()
    if reader.nodes:
        raise Unreadable(reader.nodes[0])
    return amount


def find_symbols(row: Row) -> Iterator[str]:
    """The symbols that a formula uses, as far as it can be read."""
    found: list[str] = []

    def note(symbol: str) -> Amount:
        found.append(symbol)
        return Amount(0.7 + len(found) / 97)  # apart, so that no difference of two is zero

    with suppress(Exception):  # what has no value may still have named its symbols
        read_formula(row, note)
    return iter(found)


def name_symbol(row: Row) -> str:
    """A symbol as the key under which its amount is kept."""
    return re.sub(r"\s+", "", write_row(row))


def name_magnitude(row: Row) -> str:
    """The magnitude of a symbol as the key under which its amount is kept."""
    return f"|{name_symbol(row)}|"


def read_unit(text: str) -> Amount:
    """What a unit is worth. Raises Unreadable."""
    above, *below = text.split("/")
    amount = make_exact(1.0)
    for parts, sign in ((above, 1), *((part, -1) for part in below)):
        for part in parts.split("*"):
            name, _, exponent = part.partition("^")
            if name not in UNITS:
                raise Unreadable(text)
            factor, metres, seconds = UNITS[name]
            one = make_exact(factor, metres, seconds)
            amount = multiply(amount, raise_to(one, sign * float(exponent or 1)))
    return amount


def read_digits(digits: str, degrees: bool = False) -> Amount:
    """What printed digits are worth: exactly that where they are few, else what was rounded."""
    value = float(digits)
    significant = digits.replace(".", "").lstrip("0")
    if len(significant) < ROUNDED and not (degrees and "." in digits):
        return make_exact(value)
    places = len(digits.partition(".")[2])
    return Amount(value, 0.5 * 10.0**-places)


def join_decimals(row: Row) -> list[Node]:
    """The nodes of a row, a decimal comma as a point within its number."""
    nodes: list[Node] = []
    for node in row:
        comma = len(nodes) > 1 and nodes[-1] == Sign("{,}")
        base = node.base if isinstance(node, Scripts) else node
        if comma and isinstance(base, Number):
            nodes.pop()
            whole = nodes.pop()
            if not isinstance(whole, Number):
                raise Unreadable(whole)
            joined = Number(f"{whole.digits}.{base.digits}")
            nodes.append(
                structs.replace(node, base=joined) if isinstance(node, Scripts) else joined
            )
        else:
            nodes.append(node)
    return nodes


def _is_place(node: Node) -> bool:
    """Whether a node is the letter of a point, with its index."""
    base = node.base if isinstance(node, Scripts) else node
    return isinstance(base, Letter) and len(base.name) == 1 and base.name.isupper()


@dataclass
class _Reader:
    """Sums of products of powers; a function takes what follows it up to the next mark."""

    nodes: list[Node]
    worth: Worth

    def next(self) -> Node | None:
        return self.nodes[0] if self.nodes else None

    def take(self, *signs: str) -> str:
        node = self.next()
        if isinstance(node, Sign) and node.latex in signs:
            self.nodes.pop(0)
            return node.latex
        return ""

    def skip_spaces(self) -> None:
        while isinstance(self.next(), Space):
            self.nodes.pop(0)

    def inner(self, row: Row) -> Amount:
        return read_formula(row, self.worth)

    def sum(self) -> Amount:
        negative = self.take("-")
        total = self.product()
        if negative:
            total = multiply(make_exact(-1.0), total)
        while sign := self.take("+", "-"):
            total = add(total, self.product(), 1 if sign == "+" else -1)
        return total

    def product(self) -> Amount:
        total = self.factor()
        self.skip_spaces()
        while self.nodes and not _ends_product(self.nodes[0]):
            self.take(r"\cdot")
            total = multiply(total, self.factor())
            self.skip_spaces()
        return total

    def factor(self) -> Amount:
        self.skip_spaces()
        if not self.nodes:
            raise Unreadable
        node = self.nodes.pop(0)
        if _is_place(node):
            return self.distance(node)
        match node:
            case Scripts():
                return self.scripts(node)
            case Quotient() | Root() | Fenced():
                return self.framed(node)
            case Function(name):
                return apply(name, self.argument())
            case Number(digits):
                return read_digits(digits)
            case Unit(text):
                return read_unit(text)
            case Sign("("):
                return self.bracket()
            case Sign(r"\angle"):
                return self.angle()
            case Letter("pi"):
                return make_exact(math.pi)
            case Letter():
                return self.worth(name_symbol((node,)))
            case _:
                raise Unreadable(node)

    def scripts(self, node: Scripts) -> Amount:
        """A number of degrees, a power, or a symbol with its index."""
        match node:
            case Scripts(base=Function(name), lower=None, upper=upper) if upper:
                return raise_to(apply(name, self.argument()), self.inner(upper).value)
            case Scripts(base=Number(digits), lower=None, upper=upper) if upper == DEGREE:
                return multiply(read_digits(digits, True), make_exact(math.pi / 180))
            case Scripts(base=Letter() | Number() as base, lower=lower, upper=upper) if (
                upper and not _is_lettering(upper)
            ):
                bare = structs.replace(node, upper=None) if lower or node.primes else base
                return raise_to(self.inner((bare,)), self.inner(upper).value)
            case Scripts(base=Letter()):
                return self.worth(name_symbol((node,)))
            case Scripts(base=Fenced() as base, lower=None, upper=upper) if upper:
                return raise_to(self.framed(base), self.inner(upper).value)
            case _:
                raise Unreadable(node)

    def framed(self, node: Quotient | Root | Fenced) -> Amount:
        """A fraction, a root, or what stands between brackets or bars."""
        match node:
            case Quotient(_, above, below):
                return multiply(self.inner(above), raise_to(self.inner(below), -1.0))
            case Root(radicand, None):
                return raise_to(self.inner(radicand), 0.5)
            case Fenced("|", row, _):
                amount = self.magnitude(row)
                precise = None if amount.precise is None else abs(amount.precise)
                return replace(amount, value=abs(amount.value), precise=precise)
            case Fenced("(", row, _):
                return self.inner(row)
            case _:
                raise Unreadable(node)

    def magnitude(self, row: Row) -> Amount:
        """What stands between bars; where a symbol's magnitude alone is known, that."""
        try:
            return self.inner(row)
        except Unreadable:
            return self.worth(name_magnitude(row))

    def bracket(self) -> Amount:
        amount = self.sum()
        node = self.nodes.pop(0) if self.nodes else None
        if isinstance(node, Scripts) and node.base == Sign(")") and node.upper:
            if node.upper == DEGREE:
                return multiply(amount, make_exact(math.pi / 180))
            return raise_to(amount, self.inner(node.upper).value)
        if node != Sign(")"):
            raise Unreadable(node)
        return amount

    def distance(self, first: Node) -> Amount:
        """The letters of two points side by side."""
        places, exponent = [first], 1.0
        while places[-1:] and self.nodes and _is_place(self.nodes[0]):
            places.append(self.nodes.pop(0))
        last = places[-1]
        if isinstance(last, Scripts) and last.upper and not _is_lettering(last.upper):
            exponent = self.inner(last.upper).value
            bare = structs.replace(last, upper=None)
            places[-1] = bare if bare.lower or bare.primes else bare.base or bare
        return raise_to(self.worth(name_symbol(tuple(places))), exponent)

    def angle(self) -> Amount:
        """The angle at a corner, or between two directions."""
        taken: list[Node] = [Sign(r"\angle")]
        if self.next() == Sign("("):
            while self.nodes and taken[-1] != Sign(")"):
                taken.append(self.nodes.pop(0))
        else:
            while self.nodes and _is_place(self.nodes[0]):
                taken.append(self.nodes.pop(0))
        return self.worth(name_symbol(tuple(taken)))

    def argument(self) -> Amount:
        """What a function is of: all that stands directly after it."""
        self.skip_spaces()
        total = self.factor()
        while self.nodes and _continues(self.nodes[0]):
            total = multiply(total, self.factor())
        return total


def _ends_product(node: Node) -> bool:
    """Whether a node is the sign of the next summand, or a bracket that closes, with or without a
    power.
    """
    base = node.base if isinstance(node, Scripts) else node
    return base in (Sign("+"), Sign("-"), Sign(")"))


def _is_lettering(row: Row) -> bool:
    """Whether what stands above is the letter of a part, n or t, and no exponent."""
    return isinstance(row[0], Lettering)


def _continues(node: Node) -> bool:
    """Whether a node belongs to the argument before it."""
    base = node.base if isinstance(node, Scripts) else node
    corner = node == Sign(r"\angle")  # sin 2 angle ABC
    return corner or (isinstance(base, Letter | Number) and not _is_place(node))
