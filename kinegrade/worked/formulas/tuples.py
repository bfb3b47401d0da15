"""Formulas side by side in brackets, as the coordinates of a point."""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from operator import add

from kinegrade.language.math.tree import Letter, Lettering, Row, Sign, Space
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.notation import PLAIN, Notation
from kinegrade.worked.formulas.rows import enclose


@dataclass(frozen=True)
class Tuple(Formula):
    """Formulas in one pair of brackets: coordinates, or the arguments of what is named before."""

    parts: tuple[Formula, ...]
    name: str = ""

    def print(self, notation: Notation = PLAIN) -> Row:
        """The math tree."""
        first, *others = (part.print(notation) for part in self.parts)
        inner = reduce(add, ((Sign(","), Space(" "), *row) for row in others), first)
        words = [Lettering("mathrm", tuple(map(Letter, word))) for word in self.name.split("_")]
        head = words[0], *(node for word in words[1:] for node in (Space(" "), word))
        return (*(head if self.name else ()), *enclose(inner))
