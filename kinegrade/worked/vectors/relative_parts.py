"""The relative and Coriolis parts of the motion of a point within a moving body."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import assert_never

from kinegrade.language.math.tree import Row
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.vector_equation import Level, Part, list_term_parts
from kinegrade.worked.case import Case
from kinegrade.worked.findings import Fact, Piece
from kinegrade.worked.formulas.atoms import VectorSymbol
from kinegrade.worked.vectors.relatives import find_relative, index_relative
from kinegrade.worked.vectors.vectors import name_by_role, name_coriolis


def list_relative_parts(term: Term, case: Case, level: Level) -> Iterator[Fact]:
    """The relative and Coriolis parts of a term, each by its magnitude and direction."""
    number = index_relative(find_relative(term), case)
    for part in list_term_parts(term, case.motion, tuple(case.motion.rates), level):
        name = _name_relative_part(part, level, number, case)
        fixed = part.role == "coriolis" or part.part == "n"
        sense = part.value if fixed else term.coefficient()
        yield Fact(name, part.value, False, (Piece(name, sense, part.value, term),))


def _name_relative_part(part: Part, level: Level, number: Row, case: Case) -> VectorSymbol:
    """The symbol of a relative or Coriolis part."""
    match part.role:
        case "coriolis":
            return name_coriolis(number)
        case "relative" | "absolute" | "transport" | "rotation":
            return replace(name_by_role("r", level, number), part=part.part)
        case _:
            assert_never(part.role)
