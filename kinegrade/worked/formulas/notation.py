"""How formulas print in one solution: its decimal mark, and its unit of length."""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.numbers.units import read_unit

DIGITS = 4  # significant ones, that a rounded number usually has
PLACES = 2  # decimals of a rounded angle in degrees


@dataclass(frozen=True)
class Notation:
    """The decimal mark of a language, and the unit in which a solution counts lengths: formulas
    write `m` for it, whichever it is; rounded numbers have `more_digits` than usual.

    >>> Notation(length="cm").name("m/s^2"), Notation(length="cm").name("rad/s")
    ('cm/s^2', 'rad/s')
    """

    decimal_mark: str = "."
    length: str = "m"
    more_digits: int = 0

    def name(self, unit: str) -> str:
        """The name on paper of a formula's unit."""
        if self.length == "m":
            return unit
        return read_unit(unit).count_lengths("m", self.length).text


PLAIN = Notation()
