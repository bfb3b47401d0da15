"""Square roots, sines and cosines of formulas."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, TypeAlias

from kinegrade.language.math.tree import Fenced, Row, list_nodes
from kinegrade.language.math.tree import Function as FunctionMark
from kinegrade.language.math.tree import Root as Radical
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.notation import PLAIN, Notation
from kinegrade.worked.formulas.printed import Kind
from kinegrade.worked.formulas.rows import DOT, OPEN, enclose

FunctionName: TypeAlias = Literal["sin", "cos", "tan", "arcsin", "arccos", "arctan"]


@dataclass(frozen=True)
class Root(Formula):
    """A square root."""

    radicand: Formula
    is_root: ClassVar[bool] = True

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        return (Radical(self.radicand.print(notation), None),)


@dataclass(frozen=True)
class Function(Formula):
    """A sine, cosine ... of its argument."""

    name: FunctionName
    argument: Formula
    is_function: ClassVar[bool] = True

    @property
    def kind(self) -> Kind:
        """How it behaves next to others."""
        return "function" if self._is_plain else "closed"

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        argument = self.argument.print(notation)
        return (FunctionMark(self.name), *(argument if self._is_plain else enclose(argument)))

    @property
    def _is_plain(self) -> bool:
        """Whether the argument needs no brackets: a product only where nothing parts it."""
        if self.argument.kind in ("function", "closed", "sum"):
            return False
        return not self.argument.begins_with_minus and not any(
            node in (OPEN, DOT) or isinstance(node, Fenced | Radical | FunctionMark)
            for node in (
                list_nodes(self.argument.print()) if self.argument.kind == "product" else ()
            )
        )
