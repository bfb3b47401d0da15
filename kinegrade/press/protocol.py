"""What every typesetter offers: papers, worked solutions and keys as PDF.

There are two presses, `press.typst` and `press.latex`. A press that lacks a kind of sheet cannot be
made.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

from kinegrade.language.message import Fault, Location, Message
from kinegrade.press.binding.part import count_pages
from kinegrade.press.sheet import KeyBook, Paper, SolutionSheet

Engine = Literal["typst", "latex"]
ENGINES: tuple[Engine, ...] = ("typst", "latex")


@dataclass(frozen=True)
class Printout:
    """Pages as PDF; and by file name the sources that a person may edit and typeset again, where
    the press has some.
    """

    pdf: bytes
    sources: Mapping[str, bytes] = field(default_factory=dict)


def unprintable_character(where: Location, character: str) -> Fault:
    """The message for a character that no font of a press has."""
    code = f"U+{ord(character):04X}"
    return Fault(where, Message("typesetting.no-font", character=character, code=code))


class Press(ABC):
    """Prints; every method raises TypesetError with all faults of the texts it is given."""

    @abstractmethod
    def papers(self, papers: Mapping[str, Paper]) -> dict[str, Printout]:
        """Every paper, by its name."""

    def alike(
        self, papers: Mapping[str, Paper], pages: int | None, longest: int = 0
    ) -> tuple[dict[str, Printout], dict[str, int]]:
        """Every paper, by its name, and how many pages it has: at least so many; for None, as many
        as the `longest` of others and of them. Large print takes as many as it takes.

        Those that have fewer are printed once more; a press may do better, to the same bytes.
        """
        printed = self.papers(papers)
        counts = {name: count_pages(each.pdf) for name, each in printed.items()}
        usual = [name for name, paper in papers.items() if not paper.large]
        wanted = max([longest, *map(counts.__getitem__, usual)]) if pages is None else pages
        short = {
            name: replace(papers[name], pages=wanted) for name in usual if counts[name] < wanted
        }
        return printed | self.papers(short), counts | dict.fromkeys(short, wanted)

    @abstractmethod
    def solutions(self, sheets: Mapping[str, SolutionSheet]) -> dict[str, Printout]:
        """Every student's worked solutions, by name."""

    @abstractmethod
    def key(self, book: KeyBook) -> Printout:
        """The instructor's key."""

    @abstractmethod
    def unprintable(self, texts: Iterable[str]) -> frozenset[str]:
        """The characters of `texts` that no font of the press can print."""
