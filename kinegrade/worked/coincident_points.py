"""How points of several bodies are named that coincide and move apart: B and B', A(cam)."""

from __future__ import annotations

from kinegrade.errors import ExpressionError
from kinegrade.expressions.tree import Name
from kinegrade.language.math.tree import Row, Scripts, Sign
from kinegrade.mechanics.vector_equation import Part
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.template.template import Ask
from kinegrade.worked.case import Case, write_row
from kinegrade.worked.formulas.atoms import Symbol, VectorSymbol
from kinegrade.worked.formulas.symbols import prime, read_symbol


def name_place(part: Part, case: Case) -> Symbol:
    """The letter of a part's point, primed where it is the one that coincides with it."""
    return prime_letter(part.point, case) if part.coincident else case.naming.letter(part.point)


def prime_letter(point: str, case: Case) -> Symbol:
    """The letter of the point of another body that coincides with a point: B' for B."""
    return prime(case.naming.letter(point))


def add_owner(letters: Row, body: str, case: Case) -> Row:
    """The letters of a point of the body: A(cam)."""
    return (*letters, Sign("("), *case.naming.letters(body), Sign(")"))


def index_owner(letters: Row, point: str, body: str, case: Case) -> Row:
    """The letters of a point, with the body where the point belongs to several that move apart."""
    owner = _find_owner(point, case)
    alike = owner and _moves_alike(point, owner, body, case)
    return letters if alike else _index(letters, point, body, case)


def name_owned_point(point: str, body: str, vector: VectorSymbol, case: Case) -> str:
    """A point of a body in LaTeX math, for sentences: A, or A(cam) where that is another one; of a
    point that no body has alone its vector's symbol tells.
    """
    letters, owner = case.naming.letter(point).row, _find_owner(point, case)
    indexed = _index(letters, point, body, case)
    if owner is None:
        return write_row(indexed if vector.lower == indexed else letters)
    return write_row(letters if _moves_alike(point, owner, body, case) else indexed)


def _index(letters: Row, point: str, body: str, case: Case) -> Row:
    """The letters with those of the body; where the statement has another letter for the point of
    one body, B' of the wheel, this for that body and the plain one for the other.
    """
    primed = prime_letter(point, case).row
    owners = set[str]()
    for ask in case.template.asks.values():
        if _has_index(ask, primed):
            owners |= _list_owners(ask, point)
    if owners:
        return primed if body in owners else letters
    return add_owner(letters, body, case)


def _list_owners(ask: Ask, point: str) -> set[str]:
    """The bodies of which a question names a point."""
    owners = set[str]()
    for call in find_motion_calls(ask.quantity):
        match call.arguments:
            case (Name(named), Name(owner), *_) if named == point:
                owners.add(owner)
    return owners


def _has_index(ask: Ask, letters: Row) -> bool:
    """Whether the symbol of a question has the letters of a point as its index."""
    first, *_ = read_symbol(ask.symbol).row
    return isinstance(first, Scripts) and (first.lower or ())[: len(letters)] == letters


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
