"""The keys of many papers as arrays, and the keys of one of these papers.

`reading` makes them of key.npz, `writing` of papers; `gathering` gives judges the arrays of many
papers at once.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import msgspec
import numpy as np
from numpy.typing import NDArray

from kinegrade.exam.folder.key.stated_keys import Terms, UsualKeys
from kinegrade.exam.folder.keys import StatedKey


@dataclass(frozen=True, slots=True)
class KeyPart:
    """The keys of some papers: `centres`, `values` and `exact` have a row for each paper and a
    column for each ask, `terms` one for each paper.

    `centres` are the right answers rightly rounded to doubles, NaN where a number of turns is right
    too; `values` are those of all asks, nearly rounded; `exact` are their digits or fractions.
    Mistakes stand one after the other: those of the ask with the number n, counted through all
    papers, end at `ends[n + 1]` and begin at `ends[n]`; `names`, numbers of those that are `known`,
    and `wrong` say which they are and what they lead to.
    """

    centres: NDArray[np.float64]
    values: NDArray[np.float64]
    exact: NDArray[np.bytes_]
    terms: Sequence[Terms]
    ends: NDArray[np.int64]
    names: NDArray[np.uint16]
    known: Sequence[str]
    wrong: NDArray[np.float64]

    def key(self, row: int, ask: int) -> StatedKey:
        """The key of an ask on the paper of that row."""
        terms, place = self.terms[row], row * self.centres.shape[1] + ask
        mistakes = slice(self.ends[place], self.ends[place + 1])
        names = [self.known[number] for number in self.names[mistakes].tolist()]
        led_to = zip(names, self.wrong[mistakes].tolist(), strict=True)
        return StatedKey(
            self.exact[row, ask].decode(), terms.rules[ask], dict(led_to), terms.periods[ask]
        )


class PartKeys(UsualKeys, msgspec.Struct, frozen=True, gc=False):
    """The keys of the paper in one row of a part, in the order of the asks."""

    part: KeyPart
    row: int

    def __getitem__(self, ask: int) -> StatedKey:
        """The key of an ask."""
        return self.part.key(self.row, ask)

    def __len__(self) -> int:
        return int(self.part.centres.shape[1])

    def __iter__(self) -> Iterator[StatedKey]:
        return map(self.__getitem__, range(len(self)))

    @property
    def terms(self) -> Terms:
        """The rule and the period of each ask."""
        return self.part.terms[self.row]

    def state(self, ask: int, /) -> str:
        """The right answer to an ask, as a decimal or a fraction."""
        return bytes(self.part.exact[self.row, ask]).decode()

    def list_centres(self) -> Sequence[float]:
        """The right answers rightly rounded, NaN where a number of turns is right too."""
        centres: list[float] = self.part.centres[self.row].tolist()
        return centres

    def list_values(self) -> Sequence[float]:
        """The right answers in double precision, those of cyclic angles too."""
        values: list[float] = self.part.values[self.row].tolist()
        return values
