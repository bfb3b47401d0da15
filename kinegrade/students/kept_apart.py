"""What the draws of a question keep apart, judged by a sample of them.

What most instances cannot distinguish from the truth is required of none of them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from kinegrade.mechanics.plan import Plan
from kinegrade.problem.template.template import Ask, Template
from kinegrade.students.mistaking.mistake_kinds import Mistake, find_candidates
from kinegrade.students.mistaking.mistakes import Values
from kinegrade.students.rounding.accuracy import Accuracy
from kinegrade.students.separation import Separation

_HALF = 0.5  # share of instances above which a mistake is inseparable from the truth
# The same for one given misread: there are many of these, and a mirrored figure hides some
_TENTH = 0.1
# Nor are mistakes kept apart any more when fewer instances than this share would be left
_SCARCE = 0.05


def find_separation(
    template: Template,
    asks: Mapping[str, Ask],
    accuracy: Accuracy,
    plan: Plan,
    sample: Values,
) -> Separation:
    """What draws of a question keep apart, judged by a sample of them."""
    mistakes = tuple(find_candidates(template, asks))
    whole = Separation(template, asks, accuracy, plan, mistakes, sample)
    seen = whole.compare(sample)
    share = {
        name: seen.near[name][:, seen.fit].mean(axis=1)
        if seen.fit.any()
        else np.ones(len(seen.near[name]))
        for name in asks
    }
    bounds = {name: _list_bounds(mistakes, len(share[name])) for name in asks}
    zero = frozenset(name for name, right in seen.right.items() if not right[seen.fit].any())
    bound = _HALF
    while True:
        kept = {name: share[name] < np.minimum(bounds[name], bound) for name in asks}
        confused = np.any(
            [(seen.near[name] & kept[name][:, None]).any(axis=0) for name in asks], axis=0
        )
        usable = float((seen.fit & ~confused).mean())
        if usable >= _SCARCE * seen.fit.mean() or not any(flags.any() for flags in kept.values()):
            return replace(whole, kept=kept, usable=usable, zero=zero)
        bound = max(float(share[name][kept[name]].max(initial=0.0)) for name in asks)


def _list_bounds(mistakes: Sequence[Mistake], rows: int) -> Any:
    """For each row of a comparison the share of instances that may be refused for it; those of
    writing an answer down come last.
    """
    bounds = np.full(rows, _HALF)
    bounds[: len(mistakes)] = [_TENTH if mistake.given else _HALF for mistake in mistakes]
    return bounds
