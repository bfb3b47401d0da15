r"""Formulas as values: what is said, before it is decided how signs, brackets and dots are printed.

A formula is built from numbers and symbols (`kinegrade.worked.formulas.atoms`) by the operations
of this module, `-a`, `a + b`, `a * b`, `a / b`, `a**2`, `abs(a)`; it is compared as a value and
printed last, by its method `print`, as the math tree that every press writes, and on which the
width of a line is measured.

So a chapter can hold one formula in symbols and again in numbers, leave out what repeats, and take
the two apart: an `Equation` keeps its left side and its links in order, symbols first, then
numbers, then the value, each link one formula. A solution that tells its idea first, or checks a
value, chooses among these links; it never looks into what is printed.

Two ways of multiplying differ on purpose: `a * b` sets factors side by side as textbooks set
letters, `a.dot(b)` sets a dot between them, as where lengths of two letters or numbers stand.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar

from kinegrade.language.math.tree import Fenced, Row, Scripts
from kinegrade.language.math.tree import Quotient as Fraction
from kinegrade.worked.formulas.notation import PLAIN, Notation
from kinegrade.worked.formulas.printed import Kind, Printed
from kinegrade.worked.formulas.rows import (
    DOT,
    MINUS,
    PLUS,
    enclose,
    ends_raised,
    is_segment,
    raise_last,
)
from kinegrade.worked.formulas.separators import choose_separator


class Formula(Printed):
    """A formula; where a sign, a bracket or a dot stands is decided when it is printed."""

    @property
    def sign(self) -> int:
        """-1 for the opposite of something, or a negative number; else 1."""
        return 1

    @property
    def size(self) -> Formula:
        """The formula without its sign."""
        return self

    def __neg__(self) -> Formula:
        return Negative(self)

    def __abs__(self) -> Formula:
        return Absolute(self)

    def __add__(self, other: Formula) -> Sum:
        return Sum((self, other))

    def __sub__(self, other: Formula) -> Sum:
        return Sum((self, -other))

    def __mul__(self, other: Formula) -> Product:
        return Product((self, other))

    def signed(self, sign: int) -> Formula:
        """The formula, or its opposite where the sign is negative."""
        return -self if sign < 0 else self

    def looks_like(self, other: Formula) -> bool:
        """Whether it is printed with the same letters and signs."""
        return self.print() == other.print()

    def dot(self, other: Formula) -> Product:
        """The product with a dot."""
        return Product((self, other), dotted=True)

    def __truediv__(self, other: Formula) -> Quotient:
        return Quotient(self, other)

    def __pow__(self, exponent: Formula) -> Power:
        return Power(self, exponent)


@dataclass(frozen=True)
class Negative(Formula):
    """The opposite of a formula."""

    inner: Formula
    begins_with_minus: ClassVar[bool] = True

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        return (MINUS, *self.inner.print_subtracted(notation))

    @property
    def kind(self) -> Kind:
        """How it behaves next to others."""
        return self.inner.kind

    @property
    def is_decimal(self) -> bool:
        """Whether it is nothing but a decimal."""
        return self.inner.is_decimal and not self.inner.begins_with_minus

    @property
    def sign(self) -> int:
        """-1 or 1."""
        return -self.inner.sign

    @property
    def size(self) -> Formula:
        """The formula without its sign."""
        return self.inner.size

    def __neg__(self) -> Formula:
        return self.inner


@dataclass(frozen=True)
class Sum(Formula):
    """Terms; a `Negative` one is subtracted, a negative number stands in brackets."""

    terms: tuple[Formula, ...]
    kind: ClassVar[Kind] = "sum"

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        first, *others = self.terms
        row = first.print(notation)
        for term in others:
            if isinstance(term, Negative):
                row += term.print(notation)
            else:
                row += (PLUS, *term.print_after_sign(notation))
        return row

    @property
    def begins_with_minus(self) -> bool:
        """Whether the first that is printed is a minus sign."""
        return self.terms[0].begins_with_minus


@dataclass(frozen=True)
class Product(Formula):
    """Factors side by side, or `dotted`."""

    factors: tuple[Formula, ...]
    dotted: bool = False
    kind: ClassVar[Kind] = "product"

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        return self._print(notation, leads=True)

    def _print(self, notation: Notation, leads: bool) -> Row:
        row = self.factors[0].print_factor(notation, leads)
        for before, factor in pairwise(self.factors):
            separator = (DOT,) if self.dotted else choose_separator(before, factor)
            row += (*separator, *factor.print_factor(notation, leads=False))
        return row

    def print_after_sign(self, notation: Notation) -> Row:
        """How it is printed after another term."""
        return self._print(notation, leads=False)

    @property
    def last(self) -> Printed:
        """The last factor."""
        return self.factors[-1].last

    @property
    def begins_with_minus(self) -> bool:
        """Whether the first that is printed is a minus sign."""
        first = self.factors[0]
        return first.begins_with_minus and first.kind != "sum"


@dataclass(frozen=True)
class Quotient(Formula):
    """One formula above another."""

    above: Formula
    below: Formula
    kind: ClassVar[Kind] = "fraction"

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        return (Fraction("frac", self.above.print(notation), self.below.print(notation)),)


@dataclass(frozen=True)
class Power(Formula):
    """A formula raised to another; the exponent of a sine stands directly after its name."""

    base: Formula
    exponent: Formula

    @property
    def kind(self) -> Kind:
        """How it behaves next to others."""
        return self.base.kind if self._is_plain or self.base.is_function else "closed"

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        exponent, row = self.exponent.print(notation), self.base.print(notation)
        if self.base.is_function and not self.exponent.begins_with_minus:
            return (Scripts(row[0], None, 0, exponent), *row[1:])
        return raise_last(row if self._is_plain else enclose(row), exponent)

    @property
    def is_operator(self) -> bool:
        """Whether it is a power of a sine, cosine ..."""
        return self.base.is_function

    @property
    def _is_plain(self) -> bool:
        """Whether the base needs no brackets."""
        row = self.base.print()
        if self.base.kind == "symbol" and len(row) > 1 and not is_segment(row):
            return False
        letter = self.base.kind in ("number", "symbol") and not self.base.begins_with_minus
        return letter and DOT not in row and not ends_raised(row)


@dataclass(frozen=True)
class Absolute(Formula):
    """An absolute value."""

    inner: Formula

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        return (Fenced("|", self.inner.print(notation), "|"),)
