"""Where a wheel touches a track whose motion is known."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from kinegrade.mechanics.geometry import foot
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.laws import NoSlip
from kinegrade.mechanics.relations.terms import Term
from kinegrade.mechanics.shapes import Line
from kinegrade.mechanics.vector import Vector
from kinegrade.worked.case import Case
from kinegrade.worked.formulas.atoms import ZERO
from kinegrade.worked.formulas.formula import Formula
from kinegrade.worked.formulas.measures import double, find_sign
from kinegrade.worked.vectors.known_vectors import find_positive_sense
from kinegrade.worked.vectors.stage import Stage
from kinegrade.worked.vectors.vectors import name_point_vector


@dataclass(frozen=True)
class Contact:
    """Where a wheel touches a track: how far to the left of its centre, seen along the tracks, and
    the track's motion along them, with its letters, 0 for the ground.
    """

    roll: NoSlip
    away: Any
    moved: Any
    letters: Formula


def find_contact(roll: NoSlip, track: Line, along: Vector, stage: Stage) -> Contact | None:
    """The contact with one track; None where that turns, or nothing gives its motion."""
    case, level = stage.case, stage.level
    away = along.turned().dot(foot(roll.centre, track) - roll.centre)
    if roll.of == GROUND:
        return Contact(roll, away, 0, ZERO)
    term = _find_driven(roll.of, case)
    if term is None or roll.of not in case.translating:
        return None
    positive = find_positive_sense(term, case, level)
    value = double(case.rates(level)[term.rate])
    moved = along.dot(term.coefficient() * case.rates(level)[term.rate])
    symbol = name_point_vector(term.point, level, case)
    letters = symbol.signed(find_sign(along.dot(positive))) if value else ZERO
    return Contact(roll, away, moved, letters)


def _find_driven(body: str, case: Case) -> Term | None:
    """The point of a track that slides on the ground, by which its motion has been given."""
    frames = case.motion.frames
    chain = frames.chain(body, frames.bases[body].point)
    return chain[0] if len(chain) == 1 and chain[0].kind == "sliding" else None
