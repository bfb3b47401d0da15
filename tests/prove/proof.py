"""What a proof is: a claim that any seed may try to refute."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Proof:
    """A claim and how often it is tried.

    `hold` tries it once, at a seed and in a folder of its own process, and raises AssertionError,
    or whatever else breaks it, where it does not hold; it gives how many things it compared, or
    nothing where no number of them is promised. `make prove` runs `cases` seeds in full,
    `batch` of them in one process, and gives the proof so many shares of its time; `make test` runs
    `sample` fixed ones.
    """

    name: str
    hold: Callable[[int, Path], int | None]
    cases: int
    batch: int
    sample: int
    weight: int = 1

    @property
    def address(self) -> str:
        """Where another process finds what holds the claim."""
        return f"{self.hold.__module__}:{self.hold.__qualname__}"
