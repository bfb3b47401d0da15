"""The second press: papers, worked solutions and keys as PDF, by an installed LaTeX.

One run of XeTeX typesets all sheets it is given, Chinese in the installed Noto fonts; the pages of
each then become a separate PDF. Same sheet, same bytes, whatever else is in the run.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, TypeVar

from kinegrade.errors import TypesetError
from kinegrade.exam.document import KeyBook, Paper, PaperSize, SolutionSheet
from kinegrade.exam.latex_faults import faults
from kinegrade.exam.latex_key import key_body
from kinegrade.exam.latex_run import FONTS, STYLE, Outcome, font_folder, pdf_of, run, style
from kinegrade.exam.latex_solution import solution_body
from kinegrade.exam.latex_source import document, paper_body
from kinegrade.exam.latex_text import is_surely_printed, plain
from kinegrade.exam.layout_call import each
from kinegrade.exam.press import Printout
from kinegrade.exam.solution_words import solution_words_of
from kinegrade.exam.typst import legible_owner, legible_owners
from kinegrade.exam.words import words_of
from kinegrade.language import Language
from kinegrade.temporary import temporary_folder

# TeX writes some things only on the first page of a run (its initial colour): this page, which is
# left out
FIRST_PAGE = "\\mbox{}\\clearpage\n"
START_SECONDS = 60.0
SHEET_SECONDS = 5.0  # some fifty times what a sheet takes

Sheet = TypeVar("Sheet", Paper, SolutionSheet)


@dataclass(frozen=True)
class Kind(Generic[Sheet]):
    """One of the two kinds of sheets: what it is called, and how its sources are written."""

    name: str
    body: Callable[[Sheet], str]
    words: Callable[[str], Any]


PAPERS: Kind[Paper] = Kind("papers", paper_body, words_of)
SOLUTIONS: Kind[SolutionSheet] = Kind("solutions", solution_body, solution_words_of)


class LatexPress:
    """Prints as `kinegrade.exam.press` says; `paper_size` is "a4" or "letter"."""

    def __init__(self, paper_size: PaperSize = "a4") -> None:
        self._size: PaperSize = paper_size
        self._looked_at: dict[str, bool] = {}  # whether a font prints a character

    def papers(self, papers: Mapping[str, Paper]) -> dict[str, Printout]:
        """Every paper by its name, all typeset in one run, and its source.

        Characters of a student's name and id that no font has are printed as code points
        (`unprintable` gives them). Raises TypesetError with all faults of the papers' texts, with
        the first fault that TeX finds, or where TeX is not installed.
        """
        return self._print(papers, PAPERS)

    def solutions(self, sheets: Mapping[str, SolutionSheet]) -> dict[str, Printout]:
        """Every student's worked solutions, as `papers` does it."""
        return self._print(sheets, SOLUTIONS)

    def key(self, book: KeyBook) -> Printout:
        """The instructor's key; names are printed and errors raised as by `papers`."""
        named = legible_owners(book, self)
        body, words = key_body(named), words_of(book.language)
        with self._typeset([body], book.language, words, "key") as (folder, _):
            pdf = pdf_of(folder)
        source = document([body], book.language, self._size, words, str(font_folder()))
        return _printout("key", pdf, source)

    def unprintable(self, texts: Iterable[str]) -> frozenset[str]:
        """The characters of `texts` that no font of the press can print; raises TypesetError where
        TeX is missing.
        """
        characters = {
            character for text in texts for character in text if not is_surely_printed(character)
        }
        unknown = sorted(characters - self._looked_at.keys())
        if unknown:
            missing = _missing(unknown)
            self._looked_at |= {character: character not in missing for character in unknown}
        return frozenset(character for character in characters if not self._looked_at[character])

    def _print(self, sheets: Mapping[str, Sheet], kind: Kind[Sheet]) -> dict[str, Printout]:
        owners = (text for sheet in sheets.values() for text in (sheet.name, sheet.student))
        missing = self.unprintable(owners)
        printed: dict[str, Printout] = {}
        for language in sorted({sheet.language for sheet in sheets.values()}):
            printed |= self._print_class(
                {
                    name: legible_owner(sheet, missing)
                    for name, sheet in sheets.items()
                    if sheet.language == language
                },
                language,
                kind,
            )
        return printed

    def _print_class(
        self, sheets: Mapping[str, Sheet], language: Language, kind: Kind[Sheet]
    ) -> dict[str, Printout]:
        """All sheets of one language."""
        words, fonts = kind.words(language), str(font_folder())
        bodies: list[str] = each(kind.body, sheets.values())
        with self._typeset([FIRST_PAGE, *bodies], language, words, kind.name) as (folder, outcome):
            # One page further than the sheets count, as the first page belongs to none of them
            pages = [(first + 1, first + count) for first, count in outcome.ranges]
            pdfs = [pdf_of(folder, part) for part in pages]
        return {
            name: _printout(name, pdf, document([body], language, self._size, words, fonts))
            for name, body, pdf in zip(sheets, bodies, pdfs, strict=True)
        }

    @contextmanager
    def _typeset(
        self, bodies: list[str], language: Language, words: Any, where: str
    ) -> Iterator[tuple[Path, Outcome]]:
        """The folder where the pages of the bodies lie, as long as the context lasts. Raises
        TypesetError.
        """
        source = document(bodies, language, self._size, words, FONTS)
        with temporary_folder() as folder:
            outcome = run(source, folder, START_SECONDS + SHEET_SECONDS * len(bodies))
            problems = faults(outcome, source, where)
            if problems:
                raise TypesetError(*problems)
            yield folder, outcome


def _printout(name: str, pdf: bytes, source: str) -> Printout:
    """The pages, and their source with the style that it asks for."""
    text = _introduction(name) + source
    return Printout(pdf, {f"{name}.tex": text.encode(), STYLE: style().encode()})


def _missing(characters: Iterable[str]) -> frozenset[str]:
    """Those of the characters that XeTeX has no font for."""
    words = words_of("en")
    source = document([" ".join(map(plain, characters))], "en", "a4", words, FONTS)
    with temporary_folder() as folder:
        return run(source, folder, START_SECONDS).missing


def _introduction(name: str) -> str:
    return f"% Change it as you like. To typeset it, here in its folder:  xelatex {name}.tex\n"
