"""How a formula is printed next to others: what sums, products and fractions ask of their parts."""

from __future__ import annotations

from abc import abstractmethod
from typing import ClassVar, Literal, TypeAlias

from kinegrade.language.math.tree import Row
from kinegrade.worked.formulas.notation import PLAIN, Notation
from kinegrade.worked.formulas.rows import enclose

Kind: TypeAlias = Literal[
    "number", "measured", "symbol", "function", "closed", "fraction", "product", "sum"
]


class Printed:
    """What is printed as a part of a formula.

    It is no ABC: of these, `isinstance` takes ten times as long, and formulas are asked often.
    """

    is_function: ClassVar[bool] = False  # a sine, cosine ... of its argument
    is_root: ClassVar[bool] = False

    @abstractmethod
    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree, in this notation."""

    @property
    def kind(self) -> Kind:
        """How it behaves next to others."""
        return "closed"

    @property
    def begins_with_minus(self) -> bool:
        """Whether the first that is printed is a minus sign."""
        return False

    @property
    def is_decimal(self) -> bool:
        """Whether it is nothing but a decimal, which its value says again."""
        return False

    @property
    def is_operator(self) -> bool:
        """Whether it is a function, or a power of one, whose name other factors stand before."""
        return self.is_function

    @property
    def last(self) -> Printed:
        """The last that is printed of it."""
        return self

    def print_after_sign(self, notation: Notation) -> Row:
        """How it is printed after another term: in brackets where it begins with a minus sign."""
        row = self.print(notation)
        return enclose(row) if self.begins_with_minus else row

    def print_subtracted(self, notation: Notation) -> Row:
        """How it is printed after a minus sign."""
        return (
            enclose(self.print(notation)) if self.kind == "sum" else self.print_after_sign(notation)
        )

    def print_factor(self, notation: Notation, leads: bool) -> Row:
        """How it is printed in a product: a sum in brackets, and a negative factor that does not
        lead.
        """
        bracketed = self.kind == "sum" or (self.begins_with_minus and not leads)
        return enclose(self.print(notation)) if bracketed else self.print(notation)
