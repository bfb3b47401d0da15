"""What a student may take of the parts of a law of turning rates: all of them are 1 where it is
right.

`laws` writes the factors of turning rates with them.
"""

from __future__ import annotations

from dataclasses import dataclass

from kinegrade.numbers.number import Number


@dataclass(frozen=True)
class Shares:
    """What is taken of the parts of a law: 1 is right, 0 forgotten, -1 reversed.

    - meshing: the sense in which two circles turn: -1 takes inside for outside.
    - crossing: the sense in which a belt's pulleys turn: -1 takes open for crossed.
    - carried: the turning of the body that carries the other one, or the track.
    - arm: the radius of the carried wheel within the arm r1 + r2.
    - ratio: the ratio of the lengths to which two rates are related: 0 takes its inverse.
    """

    meshing: Number = 1
    crossing: Number = 1
    carried: Number = 1
    arm: Number = 1
    ratio: Number = 1

    def find_sense(self, *, inside: bool) -> Number:
        """1 where two circles touch from outside, -1 where one lies within the other."""
        return -self.meshing if inside else self.meshing

    def relate(self, first: Number, second: Number) -> tuple[Number, Number]:
        """The two lengths of a ratio, m, in each other's place where it is inverse."""
        rest = 1 - self.ratio
        return first * self.ratio + second * rest, second * self.ratio + first * rest


RIGHT = Shares()
