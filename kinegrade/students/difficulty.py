"""How hard a draw of a question is predicted to be, compared with other draws of the same question.

The prediction is the number of points that a student loses on the average who makes one mistake,
each of those that the question gives occasion for with the same chance: a known mistake, a slip in
reading what is given, a sense that is not thought of. A mistake costs an ask its points unless it
leads to an answer within tolerance; where it leads to no configuration at all, nobody goes on from
there to the asks that depend on it. So a draw is easier where a term vanishes, where an angle is
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
from kinegrade.students.comparison import collect_columns
from kinegrade.students.mistaking.unnamed_slips import list_unnamed_slips
from kinegrade.students.separation import Separation


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
            wrong = seen.changed[name] & ~seen.near[name] | seen.stuck[name]
            costly = np.vstack([wrong, trapped])
            lost += float(self.points[name]) * costly.mean(axis=0)
        return lost

    @cached_property
    def _wide(self) -> Separation | None:
        """The mistakes that are kept apart from the truth, and the slips in reading."""
        if self.separation is None:
            return None
        slips = tuple(list_unnamed_slips(self.separation.template))
        return replace(self.separation, mistakes=(*self.separation.mistakes, *slips))
