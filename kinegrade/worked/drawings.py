"""The drawings of a solution, each drawn once: a solution that is written again, with more digits,
has those of its first writing.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass, field

from kinegrade.figure.scene import Scene


@dataclass(frozen=True)
class Drawings:
    """The drawings of one instance by what they show."""

    _drawn: dict[Hashable, Scene] = field(default_factory=dict)

    def find(self, shown: Hashable, draw: Callable[[], Scene]) -> Scene:
        """The drawing of what is `shown`: its kind and all that is not the same in every drawing
        of that kind.
        """
        if shown not in self._drawn:
            self._drawn[shown] = draw()
        return self._drawn[shown]
