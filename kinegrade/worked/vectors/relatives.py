"""Relative motions and what tells their symbols apart: v_r, v_r1, v_rK.

One symbol stands for one motion: where a problem has several, the one that an ask calls v_r has no
index, nor has the first of those that no ask names so; the others have the letter of their point.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from kinegrade.expressions.tree import Name
from kinegrade.language.math.tree import Letter, Lettering, Row, Scripts, Sign
from kinegrade.mechanics.relations.terms import Term
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.quantities.motion_functions import MOTION_FUNCTIONS
from kinegrade.problem.template.template import Ask
from kinegrade.worked.case import Case
from kinegrade.worked.coincident_points import add_owner
from kinegrade.worked.formulas.symbols import read_symbol

# What stands below the letters of relative motions, r and Cor
_LETTERS = ((Letter("r"),), tuple(map(Letter, "Cor")))


class Relative(NamedTuple):
    """The motion of a point of a body relative to another body, the frame."""

    point: str
    body: str
    frame: str

    @property
    def names(self) -> tuple[Name, Name, Name]:
        """The arguments that functions of relative motions take."""
        return Name(self.point), Name(self.body), Name(self.frame)


def find_relative(term: Term) -> Relative:
    """The relative motion of a term."""
    return Relative(term.rate.point, term.rate.body, term.frame)


def index_relative(motion: Relative, case: Case) -> Row:
    """What follows the letters e, r and Cor of a relative motion, the same each time."""
    indices = case.findings.relatives
    if motion not in indices:
        taken = set(indices.values())
        indices[motion] = next(one for one in _list_indices(motion, case) if one not in taken)
    return indices[motion]


def _list_indices(motion: Relative, case: Case) -> Iterator[Row]:
    """Indices that a motion may have, the shortest first."""
    point = case.naming.letter(motion.point).row
    yield ()
    yield point
    yield add_owner(point, motion.body, case)


def claim_plain_symbols(asked: Iterable[Ask], case: Case) -> None:
    """Keep v_r, a_r and a_Cor for the motion that asks call so."""
    for ask in asked:
        for call in find_motion_calls(ask.quantity):
            if MOTION_FUNCTIONS[call.function].derivation in ("relative", "coriolis"):
                names = [argument.name for argument in call.arguments if isinstance(argument, Name)]
                if _is_plain(ask.symbol) and () not in case.findings.relatives.values():
                    case.findings.relatives[Relative(*names)] = ()


def _is_plain(symbol: str) -> bool:
    """Whether a symbol is v_r, a_r or a_Cor, or a component of these."""
    match read_symbol(symbol).row:
        case (Scripts(_, (Lettering("mathrm", letters), *rest)),) if letters in _LETTERS:
            return not rest or (rest[0] == Sign(",") and rest[1] in (Letter("x"), Letter("y")))
        case _:
            return False
