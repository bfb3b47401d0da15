"""What every typesetter offers: papers, worked solutions and keys as PDF files.

`kinegrade.exam.typst` and `kinegrade.exam.latex` are the two presses; `kinegrade.exam.generate`
uses either.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Literal, Protocol

from kinegrade.exam.document import KeyBook, Paper, SolutionSheet

Engine = Literal["typst", "latex"]
ENGINES: tuple[Engine, ...] = ("typst", "latex")


class Press(Protocol):
    """Prints; every method raises TypesetError with all faults of the texts it is given."""

    def papers(self, papers: Mapping[str, Paper], folder: Path) -> None:
        """Write `folder/NAME.pdf` for every paper by its name."""

    def solutions(self, sheets: Mapping[str, SolutionSheet], folder: Path) -> None:
        """Write `folder/NAME.pdf` for every student's worked solutions by name."""

    def key(self, book: KeyBook, target: Path) -> None:
        """Write the instructor's key."""

    def unprintable(self, texts: Iterable[str]) -> frozenset[str]:
        """The characters of `texts` that no font of the press can print."""
