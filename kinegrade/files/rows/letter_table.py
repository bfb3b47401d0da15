"""The letters of thousands of short texts side by side, so that all are looked at in one step."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

LONGEST = 20  # letters of a text
_BREAK = ord("\n")
_Places = NDArray[np.intp]


@dataclass(frozen=True, slots=True, eq=False)
class LetterTable:
    """A line with the letters of each text, as bytes, and zeros behind them; `lengths` says how
    many there are. Of texts that are `longer` than LONGEST, there are none.
    """

    table: NDArray[np.uint8]
    lengths: _Places
    longer: _Places

    @property
    def texts(self) -> NDArray[np.bytes_]:
        """The same as texts, which end before the zeros."""
        texts: NDArray[np.bytes_] = self.table.view(f"S{self.table.shape[1]}").ravel()
        return texts


def pad_text(text: bytes) -> bytes:
    """A text with as many zeros behind it as letters are looked at from any place on."""
    return text + bytes(LONGEST)


def gather_letters(padded: NDArray[np.uint8], begins: _Places, ends: _Places) -> LetterTable:
    """The letters between these places of a padded text."""
    lengths = ends - begins
    longer = np.flatnonzero(lengths > LONGEST)
    lengths[longer] = 0
    most = int(lengths.max(initial=1))
    table = sliding_window_view(padded, most)[begins]
    table *= np.arange(most, dtype=np.uint8) < lengths.astype(np.uint8)[:, None]
    return LetterTable(table, lengths, longer)


def tabulate_letters(texts: Sequence[str]) -> LetterTable | None:
    """The letters of texts; None where one has a line break or a zero."""
    together = "\n".join([*texts, ""]).encode("utf-8", "surrogatepass")
    letters = np.frombuffer(pad_text(together), dtype=np.uint8)
    ends = np.flatnonzero(letters == _BREAK)
    if len(ends) != len(texts) or b"\0" in together:
        return None
    begins = np.append(0, ends[:-1] + 1) if len(ends) else ends
    return gather_letters(letters, begins, ends)
