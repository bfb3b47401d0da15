"""What stands between two factors."""

from __future__ import annotations

from kinegrade.language.math.tree import Fenced, Row, Space
from kinegrade.language.math.tree import Number as Digits
from kinegrade.worked.formulas.notation import PLAIN
from kinegrade.worked.formulas.printed import Printed
from kinegrade.worked.formulas.rows import DOT, OPEN

_THIN, _ONE = Space(","), (Digits("1"),)


def choose_separator(before: Printed, factor: Printed) -> Row:
    """What stands between two factors: a dot where they would run into one another, else a thin
    space or nothing.
    """
    first, second = before.kind, factor.kind
    if "measured" in (before.last.kind, second):
        return (DOT,)
    one = first == "number" and before.print() == _ONE
    if second == "number" or one or (first == "function" and not factor.is_operator):
        return (DOT,)
    if first in ("number", "fraction") and second == "fraction":
        return (DOT,)
    if factor.is_operator or (first == "number" and (second == "symbol" or factor.is_root)):
        return ()
    if before.last.kind in ("number", "symbol") and _is_enclosed(factor):
        return ()
    return (_THIN,)


def _is_enclosed(factor: Printed) -> bool:
    """Whether a factor that does not lead is printed between brackets or bars."""
    row = factor.print_factor(PLAIN, leads=False)
    return isinstance(row[0], Fenced) or row[0] == OPEN
