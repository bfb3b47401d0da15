"""Keeping mistakes and truth apart: in which instances a known mistake lands within tolerance of a
right answer.

Decided in doubles for many instances at once. A mistaken value is too near when it, written to the
significant figures that are carried, might be taken for right; the margin of half a unit of the
last figure also keeps rounding in doubles from deciding anything. What most instances of a question
cannot distinguish (a term that is identically zero there) is required of none of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from kinegrade.errors import KinegradeError
from kinegrade.mechanics.plan import Plan
from kinegrade.numbers.floats import Floats
from kinegrade.numbers.noting.pad import Doubles
from kinegrade.problem.holding import find_room, is_surely_unmet
from kinegrade.problem.template.template import Ask, Template
from kinegrade.students.comparison import Comparison, is_different, measure_distance
from kinegrade.students.mistaking.mistake_kinds import Mistake
from kinegrade.students.mistaking.mistake_outcomes import SAME, Outcomes, find_outcomes
from kinegrade.students.mistaking.mistakes import Values, convert_parameters
from kinegrade.students.mistaking.written_mistakes import list_answer_factors
from kinegrade.students.rounding.accuracy import WIDEST, Accuracy
from kinegrade.students.rounding.bounds import find_roundings
from kinegrade.students.rounding.rounding import Rounding

_ROOM = 1.05  # the scale is rounded to two figures where it gives room
_PLAIN = 1.5  # times the bound of rounding: no widened tolerance gives more room
_SURELY = 1 + 1e-6  # times a limit: doubles do not decide on what is nearer
_MET = -1  # the place of no condition
_NORMAL_OR_CORIOLIS = {
    "coriolis",
    "relative_normal",
    "path_normal",
    "square",
}  # shares of terms that velocities decide


@dataclass(frozen=True)
class Separation:
    """A question's mistakes and what its draws keep apart: `kept` has for every ask one flag for
    each mistake.

    All is judged by a `sample` of draws; `usable` is the share of it that meets the conditions and
    hides no mistake that is kept apart, `zero` are the asks whose answer is zero throughout.
    """

    template: Template
    asks: Mapping[str, Ask]
    accuracy: Accuracy
    plan: Plan
    mistakes: tuple[Mistake, ...]
    sample: Values
    kept: Mapping[str, Any] = field(default_factory=dict)
    usable: float = 1.0
    zero: frozenset[str] = frozenset()

    def find_confused(self, seen: Comparison) -> Any:
        """For each instance whether a mistake lands too near the truth; False for those unfit for
        other reasons.
        """
        confused = [(seen.near[name] & self.kept[name][:, None]).any(axis=0) for name in self.asks]
        return np.any(confused, axis=0) & seen.fit

    def find_confusing(self, seen: Comparison, place: int) -> tuple[str, str]:
        """The first ask of a confused instance, and the mistake that lands too near its answer."""
        return next(
            (name, label)
            for name in self.asks
            for label, near, kept in zip(
                seen.identifiers[name], seen.near[name][:, place], self.kept[name], strict=True
            )
            if near and kept
        )

    def compare(self, values: Values) -> Comparison:
        """Instances held against what mistakes lead to."""
        arrays = convert_parameters(self.template, values)
        found = find_outcomes(self.template, self.asks, self.mistakes, arrays, self.plan)
        carry = self.accuracy.carry
        roundings = find_roundings(self.template, self.asks, arrays, self.plan, carry)
        written_share = 0.5 * 10.0 ** (1 - carry)
        identifiers, near, changed, stuck, strayed = {}, {}, {}, {}, {}
        for name, ask in self.asks.items():
            written = list_answer_factors(ask)
            truth, *wrong = found.answers[name]
            wrong += [truth * float(factor) for factor in written.values()]
            identifiers[name] = (*(mistake.label for mistake in self.mistakes), *written)
            room = self.room(name, truth, roundings[name])
            with np.errstate(all="ignore"):
                near[name] = np.array(
                    [
                        measure_distance(one, truth, ask) <= room + written_share * np.abs(one)
                        for one in wrong
                    ]
                )
                changed[name] = np.array([is_different(one, truth) for one in wrong])
            stuck[name] = np.isnan(wrong)
            strayed[name] = self.find_strayed(name, truth, roundings[name])
            near[name][len(self.mistakes) :] &= truth != 0  # zero has no sense and no decimal point
        right = {name: rows[0] for name, rows in found.answers.items()}
        unmet = _find_unmet(self.template, arrays)
        fit = self.fit(found, unmet)
        return Comparison(identifiers, right, near, changed, stuck, fit, roundings, strayed, unmet)

    def find_right(self, values: Values) -> Mapping[str, Any]:
        """Every ask's right answers in some instances, in its unit; NaN where there is none."""
        arrays = convert_parameters(self.template, values)
        found = find_outcomes(self.template, self.asks, (), arrays, self.plan)
        return {name: rows[0] for name, rows in found.answers.items()}

    def inseparable(self, seen: Comparison) -> dict[str, tuple[str, ...]]:
        """For each ask the mistakes that the sample, as it was compared, cannot distinguish from
        the truth.

        They change nothing although their term is of consequence (it is zero at this instant), or
        almost nothing in most instances; draws do not keep them apart.
        """
        perturbed = find_outcomes(
            self.template,
            self.asks,
            self.mistakes,
            convert_parameters(self.template, self.sample),
            self.plan,
            perturbed=True,
        )
        found = {}
        for name in self.asks:
            right, *wrong = perturbed.answers[name]
            hidden = (seen.changed[name] & seen.fit).any(axis=1)
            for place, (mistake, one) in enumerate(zip(self.mistakes, wrong, strict=True)):
                hidden[place] |= (
                    bool(_NORMAL_OR_CORIOLIS & set(mistake.shares))
                    and is_different(one, right).any()
                )
            found[name] = tuple(
                np.array(seen.identifiers[name])[hidden & ~self.kept[name]].tolist()
            )
        return found

    def room(self, name: str, right: Any, rounding: Rounding[Doubles]) -> Any:
        """How far from the right answers one may be, in the ask's unit: a bound, for the draw
        alone.
        """
        stated, bounds = self._stated_room(name, right, rounding), rounding.bound
        widened = np.where(np.isfinite(bounds) & (bounds > stated), _PLAIN * bounds, 0.0)
        return np.maximum(stated, widened) if self.accuracy.may_widen(name) else stated

    def find_strayed(self, name: str, right: Any, rounding: Rounding[Doubles]) -> Any:
        """Where honest rounding surely leaves the tolerance of an answer, widened if it may be."""
        strayed = rounding.bound > _SURELY * self._stated_room(name, right, rounding)
        if self.accuracy.may_widen(name):
            strayed &= rounding.bound > _SURELY * float(WIDEST) * np.abs(right)
        return strayed

    def _stated_room(self, name: str, right: Any, rounding: Rounding[Doubles]) -> Any:
        """How far from the right answers one may be at most by the tolerance as it is stated."""
        tolerance = self.accuracy.find_stated(name)
        share, absolute = float(tolerance.share), float(tolerance.absolute)
        room = np.maximum(share * np.abs(right), absolute)
        next_to_zero = share * _ROOM * rounding.largest
        return np.where(np.abs(right) < next_to_zero, np.maximum(room, next_to_zero), room)

    def fit(self, found: Outcomes, unmet: Any) -> Any:
        """Which instances meet the conditions and have answers that do not vanish where they must
        not.
        """
        known = {
            name: rows[0] for name, rows in found.answers.items() if np.isfinite(rows[0]).any()
        }
        fits = [
            np.isfinite(right) & (self.asks[name].vanishes | (right != 0))
            for name, right in known.items()
        ]
        return np.all([*fits, unmet < 0], axis=0)


def _find_unmet(template: Template, arrays: Mapping[str, Any]) -> Any:
    """For each instance the place of the first condition that it surely does not meet, or -1; one
    on the bound counts as met.
    """
    floats = Floats()
    unmet = np.full(np.shape(next(iter(arrays.values()))), _MET)
    for place, condition in reversed([*enumerate(template.scheme.conditions)]):
        try:
            with floats.context():
                room = find_room(template, condition, arrays, floats)
        except KinegradeError:
            continue
        surely = is_surely_unmet(condition.relation, room, SAME)
        unmet[np.broadcast_to(surely, unmet.shape)] = place
    return unmet
