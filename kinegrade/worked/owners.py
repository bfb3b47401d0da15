"""Points of several bodies that coincide and move apart: which one is meant."""

from __future__ import annotations

from kinegrade.errors import ExpressionError
from kinegrade.language.math.tree import Row, Sign
from kinegrade.worked.case import Case, write_row
from kinegrade.worked.formulas.atoms import VectorSymbol


def index_owner(letters: Row, point: str, body: str, case: Case) -> Row:
    """The letters of a point, with the body where the point belongs to several that move apart."""
    owner = _find_owner(point, case)
    return (
        letters if owner and _moves_alike(point, owner, body, case) else _index(letters, body, case)
    )


def name_owned_point(point: str, body: str, vector: VectorSymbol, case: Case) -> str:
    """A point of a body in LaTeX math, for sentences: A, or A(cam) where that is another one; of a
    point that no body has alone its vector's symbol tells.
    """
    letters, owner = case.naming.letter(point).row, _find_owner(point, case)
    indexed = _index(letters, body, case)
    if owner is None:
        return write_row(indexed if vector.lower == indexed else letters)
    return write_row(letters if _moves_alike(point, owner, body, case) else indexed)


def _index(letters: Row, body: str, case: Case) -> Row:
    return (*letters, Sign("("), *case.naming.letters(body), Sign(")"))


def _find_owner(point: str, case: Case) -> str | None:
    """The body that is meant unless another is named; None where one has to be named."""
    try:
        return case.reader.owner(point, None)
    except ExpressionError:
        return None


def _moves_alike(point: str, body: str, other: str, case: Case) -> bool:
    """Whether a point of two bodies is one: they are pinned there, or it is carried by the same."""
    frames = case.motion.frames
    pins = (pin for pin in frames.mechanism.shared_points if pin.point == point)
    pinned = any({body, other} <= {*pin.bodies} for pin in pins)
    return body == other or pinned or frames.chain(body, point) == frames.chain(other, point)
