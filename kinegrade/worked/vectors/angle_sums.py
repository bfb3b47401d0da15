"""Sums of angles, each worked out once where a sine or a cosine first takes it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinegrade.language.message import Listing, Message
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import Number, add_terms
from kinegrade.worked.formulas.equation import Equation, approximate, equate
from kinegrade.worked.formulas.numbers import state_angle
from kinegrade.worked.vectors.slopes.cosines import Cosine

_PLACES = 6  # decimals of a degree by which angles are told apart


def explain_sums(cosines: Iterable[Cosine | None], case: Case) -> Iterator[Message]:
    """What the angles in some cosines come to where they are sums that are not read at a glance:
    those of which a summand has been rounded.
    """
    seen = (one for one in cosines if one is not None and any(map(_is_rounded, one.summands)))
    new = list(_select_new(seen, case.findings.summed))
    if new:
        sums = Listing(tuple(case.tell(_state_sum(one)) for one in new), "and")
        yield Message("solution.here", equations=sums)


def tell_sum(cosine: Cosine, case: Case) -> str | None:
    """The angle of a cosine worked out, in a sentence; None where it need not be, or has been."""
    needed = any(map(_is_rounded, cosine.summands))
    new = list(_select_new((cosine,), case.findings.summed)) if needed else []
    return case.tell(_state_sum(cosine)) if new else None


def is_told(cosine: Cosine, case: Case) -> bool:
    """Whether the angle of a cosine is no sum, or one of givens, or has been told: a sum with a
    derived angle is that of no two lines which a reader sees at once.
    """
    derived = bool(cosine.summands) and r"\psi_" in case.text(cosine.angle)
    return not derived or _round(cosine.summands) in case.findings.summed


def _round(summands: Iterable[float]) -> frozenset[float]:
    return frozenset(round(angle, _PLACES) for angle in summands)


def _select_new(cosines: Iterable[Cosine], said: set[frozenset[float]]) -> Iterator[Cosine]:
    """Those that have not been worked out."""
    for one in cosines:
        angles = _round(one.summands)
        if angles not in said:
            said.add(angles)
            yield one


def _is_rounded(angle: float) -> bool:
    number = state_angle(angle).number
    return isinstance(number, Number) and number.rounded


def _state_sum(cosine: Cosine) -> Equation:
    """The sum in symbols, in degrees, and what it comes to."""
    terms = (state_angle(abs(one)).signed(1 if one > 0 else -1) for one in cosine.summands)
    relate = approximate if any(map(_is_rounded, cosine.summands)) else equate
    links = (*equate(add_terms(terms)), *relate(state_angle(cosine.value)))
    return Equation(cosine.angle, links)
