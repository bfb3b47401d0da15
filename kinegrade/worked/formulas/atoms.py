"""What formulas are made of: numbers, symbols, and numbers with their units."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from decimal import Decimal
from typing import ClassVar, Literal

from kinegrade.language.math.tree import DEGREE, Letter, Lettering, Row, Scripts, Sign, Space, Unit
from kinegrade.mechanics.vector import AxisName
from kinegrade.worked.formulas.formula import Formula, Negative, Product, Sum
from kinegrade.worked.formulas.functions import Root
from kinegrade.worked.formulas.notation import DIGITS, PLAIN, Notation
from kinegrade.worked.formulas.printed import Kind
from kinegrade.worked.formulas.rows import enclose, print_decimal, raise_last

OTHER: Mapping[AxisName, AxisName] = {"x": "y", "y": "x"}
AXES: tuple[AxisName, AxisName] = ("x", "y")


@dataclass(frozen=True)
class Number(Formula):
    """A decimal as it is printed; a negative one keeps its minus sign wherever it stands. `rounded`
    where it has more digits than it shows; `long` has more of these, where they may be shown.

    >>> Number("-2").sign, abs(Number("-2"))
    (-1, Number(digits='2'))
    """

    digits: str
    rounded: bool = field(default=False, compare=False, repr=False)
    long: str = field(default="", compare=False, repr=False)
    kind: ClassVar[Kind] = "number"
    is_decimal: ClassVar[bool] = True

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        return print_decimal(self.show(notation), notation.decimal_mark)

    def show(self, notation: Notation) -> str:
        """The digits that are printed.

        >>> Number("-0.4989", True, "-0.498934567").show(Notation(more_digits=2))
        '-0.498935'
        """
        if not (self.rounded and self.long and notation.more_digits):
            return self.digits
        digits, mark, power = self.digits.partition("e")
        last = -len(digits.partition(".")[2]) or max(len(digits.strip("-")) - DIGITS, 0)
        finer = Decimal(self.long).scaleb(-int(power or 0))
        return f"{round(finer, notation.more_digits - last):f}{mark}{power}"

    @property
    def begins_with_minus(self) -> bool:
        """Whether the first that is printed is a minus sign."""
        return self.digits.startswith("-")

    @property
    def sign(self) -> int:
        """-1 or 1."""
        return -1 if self.begins_with_minus else 1

    @property
    def size(self) -> Formula:
        """The formula without its sign."""
        digits, long = (one.removeprefix("-") for one in (self.digits, self.long))
        return replace(self, digits=digits, long=long)

    def __abs__(self) -> Formula:
        return self.size


@dataclass(frozen=True)
class Exact(Formula):
    """An exact number in place of a symbol, with its roots and fractions; it keeps its sign."""

    form: Formula

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        return self.form.print(notation)

    @property
    def kind(self) -> Kind:
        """How it behaves next to others."""
        return (
            self.form.size.factors[0].kind
            if isinstance(self.form.size, Product)
            else self.form.kind
        )

    @property
    def begins_with_minus(self) -> bool:
        """Whether the first that is printed is a minus sign."""
        return self.form.begins_with_minus

    @property
    def sign(self) -> int:
        """-1 or 1."""
        return self.form.sign

    @property
    def size(self) -> Formula:
        """The formula without its sign."""
        return Exact(self.form.size)


@dataclass(frozen=True)
class Symbol(Formula):
    """Letters that stand for a quantity; `closed` where they would read as a product with what
    follows them.
    """

    row: Row
    closed: bool = False

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        return self.row

    @property
    def kind(self) -> Kind:
        """How it behaves next to others."""
        return "closed" if self.closed else "symbol"


@dataclass(frozen=True)
class VectorSymbol(Formula):
    """A velocity or acceleration: its magnitude, with `axis` a component, in `bold` the vector
    itself; `part` is n or t for a normal or tangential part.
    """

    letter: Literal["v", "a"]
    lower: Row
    part: Literal["", "n", "t"] = ""
    axis: AxisName | Literal[""] = ""
    bold: bool = False
    kind: ClassVar[Kind] = "symbol"

    @property
    def unit(self) -> str:
        """The unit of its magnitude."""
        return {"v": "m/s", "a": "m/s^2"}[self.letter]

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        letter = Letter(self.letter)
        axis = (Sign(","), Letter(self.axis)) if self.axis else ()
        upper = (Lettering("mathrm", (Letter(self.part),)),) if self.part else None
        base = Lettering("boldsymbol", (letter,)) if self.bold else letter
        lower = (*self.lower, *axis)
        return (Scripts(base, lower or None, 0, upper),) if lower or upper else (base,)


@dataclass(frozen=True)
class Measured(Formula):
    """A number with its unit, "m/s^2"; "deg" is the degree sign, "1" nothing."""

    number: Formula
    unit: str

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        row = self.number.print(notation)
        if self.unit == "1":
            return row
        row = enclose(row) if self.number.kind == "sum" else row
        return (
            raise_last(row, DEGREE)
            if self.unit == "deg"
            else (*row, Space(","), Unit(notation.name(self.unit)))
        )

    @property
    def kind(self) -> Kind:
        """How it behaves next to others; a degree sign parts a number from what follows."""
        return self.number.kind if self.unit in ("deg", "1") else "measured"

    @property
    def is_decimal(self) -> bool:
        """Whether it is nothing but a decimal."""
        return self.number.is_decimal

    @property
    def begins_with_minus(self) -> bool:
        """Whether the first that is printed is a minus sign."""
        bracketed = self.number.kind == "sum" and self.unit != "1"
        return self.number.begins_with_minus and not bracketed

    @property
    def sign(self) -> int:
        """-1 or 1."""
        return self.number.sign

    @property
    def size(self) -> Formula:
        """The formula without its sign."""
        return Measured(self.number.size, self.unit)

    def __abs__(self) -> Formula:
        return self.size


ZERO, ONE, TWO = Number("0"), Number("1"), Number("2")


def add_terms(terms: Iterable[Formula]) -> Formula:
    """The sum of any number of terms: of none 0, of one itself."""
    listed = tuple(terms)
    return Sum(listed) if len(listed) > 1 else next(iter(listed), ZERO)


def multiply_factors(factors: Iterable[Formula]) -> Formula:
    """The product of one or more factors, side by side."""
    first, *others = factors
    return Product((first, *others)) if others else first


def add_squares(sides: Iterable[Formula]) -> Root:
    """The root of the sum of squares; the opposite of a formula has the square of that.

    >>> add_squares((-Symbol((Letter("x"),)), TWO)).radicand.terms[0].base
    Symbol(row=(Letter(name='x'),), closed=False)
    """
    plain = (side.inner if isinstance(side, Negative) else side for side in sides)
    return Root(add_terms(side**TWO for side in plain))


def list_summands(formula: Formula) -> tuple[Formula, ...]:
    """The terms of a sum, each with its sign; else the formula itself."""
    if not isinstance(formula.size, Sum):
        return (formula,)
    return tuple(one.signed(formula.sign) for one in formula.size.terms)
