"""How formulas print in one solution: its decimal mark, and its unit of length."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from kinegrade.numbers.units import read_unit


@dataclass(frozen=True)
class Notation:
    """The decimal mark of a language, and the unit in which a solution counts lengths: formulas
    write `m` for it, whichever it is; `finer` are the digits that a number, as it is without
    rounding, has beyond the usual ones.

    >>> Notation(length="cm").name("m/s^2"), Notation(length="cm").name("rad/s")
    ('cm/s^2', 'rad/s')
    """

    decimal_mark: str = "."
    length: str = "m"
    finer: Mapping[str, int] = field(default_factory=dict, hash=False)

    def name(self, unit: str) -> str:
        """The name on paper of a formula's unit."""
        if self.length == "m":
            return unit
        return read_unit(unit).count_lengths("m", self.length).text


PLAIN = Notation()
