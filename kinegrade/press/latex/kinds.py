"""The two kinds of sheets that LaTeX sets for students: what they are called, and how their sources
are written.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Generic, TypeVar

from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.message import Location
from kinegrade.press.latex.paper import name_logo, write_paper_body
from kinegrade.press.latex.solution import write_solution_body
from kinegrade.press.paper_head import PaperHead
from kinegrade.press.places import ALL_PAPERS, ALL_SOLUTIONS
from kinegrade.press.sheet import Paper, SolutionSheet
from kinegrade.press.typst.logo import print_logo

SheetT = TypeVar("SheetT", Paper, SolutionSheet)


@dataclass(frozen=True)
class Kind(Generic[SheetT]):
    """One of the kinds: its name, and of a sheet the body, the fixed words and the pictures."""

    name: Location
    body: Callable[[SheetT], str]
    words: Callable[[Language], Mapping[str, str]]
    pictures: Callable[[SheetT], Mapping[str, bytes]] = lambda _: {}


def read_paper_words(language: Language) -> Mapping[str, str]:
    """The fixed words of papers and keys."""
    return open_catalogue(language).raw("paper", "layout.")


def _read_solution_words(language: Language) -> Mapping[str, str]:
    return open_catalogue(language).raw("solution", "layout.")


def _print_pictures(head: PaperHead) -> Mapping[str, bytes]:
    """The logo of a paper."""
    return {name_logo(head): _print_logo(head.logo)} if head.logo else {}


@lru_cache(maxsize=1)
def _print_logo(logo: str) -> bytes:
    """The logo of a class."""
    return print_logo(logo, "pdf")


PAPERS: Kind[Paper] = Kind(
    ALL_PAPERS, write_paper_body, read_paper_words, lambda paper: _print_pictures(paper.head)
)
SOLUTIONS: Kind[SolutionSheet] = Kind(ALL_SOLUTIONS, write_solution_body, _read_solution_words)
