"""How hard a draw of a question is predicted to be, compared with other draws of the same question.

The prediction is the number of points that a student loses on the average who makes one mistake:
one of the known mistakes that the question gives occasion for, each with the same chance, or, a
quarter as likely, a slip in reading what is given, a sense that is not thought of, a value rounded
too far. A mistake costs an
ask its points unless it leads to an answer within tolerance; rounding costs the share of them that
its bound has of the tolerance. So a draw is easier where a term vanishes, where an angle is
special (sine and cosine equal, or one of them zero), where two givens are equal, and where an
answer is positive in the sense that counts as positive.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from kinegrade.sign_conventions import UNSIGNED
from kinegrade.students.mistaking.unnamed_slips import list_unnamed_slips
from kinegrade.students.separation import Comparison, Separation, collect_columns

# The chance of a slip that has no name, in that of a known mistake: students written by hand lose
# points by the known ones
_UNNAMED = 0.25


@dataclass(frozen=True)
class Difficulty:
    """What is predicted for draws of a question whose asks count these `points`.

    `separation` is None where no instance can be worked out, or nothing is asked: then all draws
    are alike.
    """

    separation: Separation | None
    points: Mapping[str, Fraction]

    def predict(self, draws: Sequence[Mapping[str, str]]) -> Any:
        """For each draw the points that one mistake costs on the average, an array of doubles."""
        if self._wide is None or not draws:
            return np.zeros(len(draws))
        seen = self._wide.compare(collect_columns(draws))
        lost = np.zeros(len(draws))
        for name, ask in self._wide.asks.items():
            trapped = (seen.right[name] < 0) & (ask.sign not in UNSIGNED)
            costly = [seen.changed[name] & ~seen.near[name], trapped, _round_too_far(seen, name)]
            chances = [1 if label else _UNNAMED for label in (*seen.identifiers[name], "", "")]
            lost += float(self.points[name]) * np.average(np.vstack(costly), 0, chances)
        return lost

    @cached_property
    def _wide(self) -> Separation | None:
        """The mistakes that are kept apart from the truth, and the slips in reading."""
        if self.separation is None:
            return None
        slips = tuple(list_unnamed_slips(self.separation.template))
        return replace(self.separation, mistakes=(*self.separation.mistakes, *slips))


def _round_too_far(seen: Comparison, name: str) -> Any:
    """For each draw the share that the bound of honest rounding has of the tolerance, in hundredths
    so that it is the same on every machine.
    """
    with np.errstate(all="ignore"):
        share = seen.bounds[name] / seen.rooms[name]
    return np.round(np.clip(np.nan_to_num(share), 0, 1), 2)
