"""What the check of a template found."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from math import prod

from kinegrade.draws.examining import Reason
from kinegrade.errors import Problem
from kinegrade.language.message import Message
from kinegrade.problem.needs import find_idle_givens
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.spread import Spread
from kinegrade.students.near_mistakes import NearMistakes

_HIDDEN = 3
SECRET = "check"  # the instances looked at are the same every time


@dataclass
class Report:
    """What the check of a template found; `faults` is empty when the template is sound.

    `secret` is what the instances were drawn from. `sound` are the asks that can be worked out
    at all drawn values; the others are faults. Of the published results `proved`, `rounded`
    were held to their printed figures. `near` are the mistakes that lead to right answers.
    `shares` are for each ask the relative tolerances that honest rounding takes in the
    instances, `special` counts those in which a given is zero or a multiple of a right angle.
    `causes` say why draws were refused, `demands` what solving takes. `examples` are the first
    few instances, `assemblies` says how else they close. `seconds` is the mean time of an
    instance; `remarks` are for the author to weigh.
    """

    template: Template
    secret: str = SECRET
    sound: tuple[str, ...] = ()
    proved: int = 0
    rounded: int = 0
    instances: int = 0
    refused: Counter[Reason] = field(default_factory=Counter)
    shares: dict[str, list[Fraction]] = field(default_factory=dict)
    special: Counter[str] = field(default_factory=Counter)
    spreads: dict[str, Spread] = field(default_factory=dict)
    near: NearMistakes = field(default_factory=NearMistakes)
    examples: list[Solution] = field(default_factory=list)
    assemblies: list[Message] = field(default_factory=list)
    causes: list[Message] = field(default_factory=list)
    demands: Message | None = None
    following: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    seconds: float = 0.0
    remarks: list[Message] = field(default_factory=list)
    faults: list[Problem] = field(default_factory=list)

    @property
    def distinct(self) -> int:
        """How many distinct instances there are: all that differ, less the share that the sample
        refused.
        """
        return self._different * self.instances // self.examined if self.examined else 0

    @property
    def possible(self) -> int:
        """How many distinct instances the sample leaves possible: where it has not all
        combinations, chance may have hidden three good ones (19 in 20 samples hide no more).
        """
        if self.examined == self.template.combinations:
            return self.distinct
        return self._different * (self.instances + _HIDDEN) // max(self.examined, 1)

    def count_needed(self, least: int) -> int:
        """How many draws would tell whether there are `least` distinct instances, where there seem
        to be fewer: chance may then hide no more than are lacking.
        """
        needed = _HIDDEN * self._different // (least - self.distinct) + 1
        return min(needed, self.template.combinations)

    @cached_property
    def _different(self) -> int:
        """How many combinations differ in more than givens on which nothing depends."""
        idle = find_idle_givens(self.template)
        others = (each for each in self.template.parameters.values() if each.name not in idle)
        return prod(len(each.choices) for each in others)

    @property
    def is_sound(self) -> bool:
        """Whether draws were looked at that are fit for students, and nothing is wrong."""
        return bool(self.instances) and not self.faults

    @property
    def examined(self) -> int:
        """How many draws were looked at, with those that were refused."""
        return self.instances + sum(self.refused.values())
