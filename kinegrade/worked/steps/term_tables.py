"""A vector equation term by term, with the magnitude and direction of each."""

from __future__ import annotations

from dataclasses import replace

from kinegrade.language.message import Message
from kinegrade.mechanics.vector_equation import Part, VectorEquation
from kinegrade.worked.case import Case
from kinegrade.worked.document import Term, TermTable
from kinegrade.worked.formulas.atoms import ZERO
from kinegrade.worked.steps.polygons import order_vectors
from kinegrade.worked.vectors.by_components import find_components
from kinegrade.worked.vectors.table.directions import describe_direction
from kinegrade.worked.vectors.table.magnitudes import describe_magnitude
from kinegrade.worked.vectors.vectors import name_part, vanishes


def make_term_table(equation: VectorEquation, case: Case) -> TermTable:
    """The equation term by term with magnitudes and directions; terms that vanish at this instant
    are left out, the others stand as in its polygon.
    """
    ordered = order_vectors(equation, case)
    left, right = (
        [_make_term(equation, part, case) for part in side if not vanishes(part)]
        for side in (ordered.left, ordered.right)
    )
    nothing = Term("", ZERO.print(), "", "")
    first, *added = left or [nothing]
    second, *others = right or [nothing]
    return TermTable(
        (
            first,
            *(replace(term, sign="+") for term in added),
            replace(second, sign="="),
            *(replace(term, sign="+") for term in others),
        )
    )


def _make_term(equation: VectorEquation, part: Part, case: Case) -> Term:
    """A column of the table; a vector found by its components has these in place of a magnitude."""
    symbol = name_part(equation, part, case, bold=True).print()
    pieces = find_components(part, equation.level, case)
    if pieces:
        first, second = (case.text(piece.symbol) for piece in pieces)
        known = case.write(Message("solution.found-by-components"))
        return Term("", symbol, rf"${first},\;{second}$", known)
    magnitude = describe_magnitude(equation, part, case)
    return Term("", symbol, magnitude, describe_direction(equation, part, case))
