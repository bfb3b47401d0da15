"""What the check of a template found."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from math import prod, sqrt

from kinegrade.draws.examining import Reason
from kinegrade.errors import Problem
from kinegrade.language.message import Message
from kinegrade.problem.needs import find_idle_givens
from kinegrade.problem.solution import Solution
from kinegrade.problem.template.template import Template
from kinegrade.proof.spread import Spread
from kinegrade.students.near_mistakes import NearMistakes

_STEP = 8  # by what part of themselves draws that would tell are added to
_CERTAIN = 3.29  # standard deviations: one sample in a thousand lies farther off
SECRET = "check"  # the instances looked at are the same every time


@dataclass
class Report:
    """What the check of a template found; `faults` is empty when the template is sound.

    `secret` is what the instances were drawn from. `sound` are the asks that can be worked out
    at all drawn values; the others are faults. Of the published results `proved`, `rounded`
    were held to their printed figures. `near` are the mistakes that lead to right answers.
    `shares` are for each ask the relative tolerances that honest rounding takes in the
    instances, `special` counts those in which a given is zero or a multiple of a right angle.
    `further` are draws that were only counted, accepted or not. `causes` say why draws were
    refused, `demands` what solving takes. `examples` are the first few instances, `assemblies` says
    how else they close. `seconds` is the mean time of an instance; `remarks` are for the author to
    weigh.
    """

    template: Template
    secret: str = SECRET
    sound: tuple[str, ...] = ()
    proved: int = 0
    rounded: int = 0
    instances: int = 0
    refused: Counter[Reason] = field(default_factory=Counter)
    further: Counter[bool] = field(default_factory=Counter)
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
        """How many distinct instances there are: all that differ, less the share that the draws
        counted refused.
        """
        return self._different * self.accepted // self.counted if self.counted else 0

    @property
    def bounds(self) -> tuple[int, int]:
        """Between what numbers that of the distinct instances is, but for one sample in a
        thousand (Wilson's interval); exact where all combinations were counted.
        """
        return self._bound(self.accepted, self.counted)

    def count_needed(self, least: int) -> int:
        """How many draws would tell whether there are `least` distinct instances, if they are
        accepted as often as those that were counted.
        """
        needed, share = self.counted + 1, self.accepted / max(self.counted, 1)
        while needed < self.template.combinations:
            fewest, most = self._bound(share * needed, needed)
            if fewest >= least or most < least:
                return needed
            needed += needed // _STEP + 1
        return self.template.combinations

    def _bound(self, accepted: float, counted: int) -> tuple[int, int]:
        """The bounds if so many of the draws counted are accepted."""
        if counted in {self.template.combinations, 0}:
            return self.distinct, self.distinct
        spread = _CERTAIN**2
        middle = accepted + spread / 2
        half = _CERTAIN * sqrt(accepted * (counted - accepted) / counted + spread / 4)
        scale = self._different / (counted + spread)
        return int(scale * max(middle - half, 0)), int(scale * (middle + half))

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

    @property
    def accepted(self) -> int:
        """How many draws are fit for students, with those that were only counted."""
        return self.instances + self.further[True]

    @property
    def counted(self) -> int:
        """How many draws were looked at, with those that were only counted."""
        return self.examined + self.further.total()
