"""The second press: papers, worked solutions and keys as PDF, by an installed LaTeX.

One run of XeTeX typesets all sheets it is given, Chinese in the installed Noto fonts; the pages of
each then become a separate PDF. Same sheet, same bytes, whatever else is in the run.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import Generic

from kinegrade.errors import TypesetError
from kinegrade.files.temporary import temporary_folder
from kinegrade.language import ENGLISH, Language
from kinegrade.language.gathering import convert_each
from kinegrade.language.math.latex_text import is_surely_printed, write_plain
from kinegrade.language.message import Location
from kinegrade.press.latex.document import write_document
from kinegrade.press.latex.faults import find_faults
from kinegrade.press.latex.key import write_key_body
from kinegrade.press.latex.kinds import PAPERS, SOLUTIONS, Kind, SheetT, read_paper_words
from kinegrade.press.latex.paper import write_paper_body
from kinegrade.press.latex.printout import make_printout
from kinegrade.press.latex.xetex import (
    CLASS,
    FONTS,
    Outcome,
    find_font_folder,
    make_pdf,
    run,
)
from kinegrade.press.legible import make_owner_legible, make_owners_legible
from kinegrade.press.places import KEY
from kinegrade.press.protocol import Press, Printout
from kinegrade.press.sheet import KeyBook, Paper, PaperSize, SolutionSheet
from kinegrade.press.typst.press import TypstPress

# TeX writes some things only on the first page of a run (its initial colour): this page, which is
# left out
_FIRST_PAGE = f"\\input{{{CLASS}}}\\mbox{{}}\\clearpage\n"
_START_SECONDS = 60.0
_SHEET_SECONDS = 5.0  # some fifty times what a sheet takes


@dataclass(frozen=True)
class _Set(Generic[SheetT]):
    """A sheet with its owner made legible, its source, and the pages that TeX has made of it: how
    many there are, and of its own, before it was filled up.
    """

    sheet: SheetT
    body: str
    pdf: bytes
    pages: int
    own: int


class LatexPress(Press):
    """Prints as `kinegrade.press.protocol` says; `paper_size` is "a4" or "letter"."""

    def __init__(self, paper_size: PaperSize = "a4") -> None:
        self._size: PaperSize = paper_size
        self._looked_at: dict[str, bool] = {}  # whether a font prints a character

    def papers(self, papers: Mapping[str, Paper]) -> dict[str, Printout]:
        """Every paper by its name, all typeset in one run, and its source.

        Characters of a student's name and id that no font has are printed as code points
        (`unprintable` gives them). Raises TypesetError with all faults of the papers' texts, with
        the first fault that TeX finds, or where TeX is not installed. Large print, which has no
        layout here, is set by Typst, whose pages can be heard as well.
        """
        return self._print_all(papers, PAPERS, TypstPress.papers)

    def alike(
        self, papers: Mapping[str, Paper], pages: int | None, longest: int = 0
    ) -> tuple[dict[str, Printout], dict[str, int]]:
        """Every paper and how many pages it has, as `Press` says; errors are raised as by `papers`.

        The run that finds how many pages the papers have fills up all after the longest.
        """
        large = {name: paper for name, paper in papers.items() if paper.large}
        typst, counts = TypstPress(self._size).alike(large, None) if large else ({}, {})
        usual = {name: paper for name, paper in papers.items() if not paper.large}
        ready = self._set_alike(usual, pages, longest)
        printed = {name: self._make_printout(name, each, PAPERS) for name, each in ready.items()}
        return printed | typst, counts | {name: each.pages for name, each in ready.items()}

    def solutions(self, sheets: Mapping[str, SolutionSheet]) -> dict[str, Printout]:
        """Every student's worked solutions, as `papers` does it."""
        return self._print_all(sheets, SOLUTIONS, TypstPress.solutions)

    def key(self, book: KeyBook) -> Printout:
        """The instructor's key; names are printed and errors raised as by `papers`."""
        body = write_key_body(make_owners_legible(book, self))
        return self._print_one(book.name, body, book.language, KEY)

    def unprintable(self, texts: Iterable[str]) -> frozenset[str]:
        """The characters of `texts` that no font of the press can print; raises TypesetError where
        TeX is missing.
        """
        characters = {
            character for text in texts for character in text if not is_surely_printed(character)
        }
        unknown = sorted(characters - self._looked_at.keys())
        if unknown:
            missing = _find_missing(unknown)
            self._looked_at |= {character: character not in missing for character in unknown}
        return frozenset(character for character in characters if not self._looked_at[character])

    def _print_one(self, name: str, body: str, language: Language, where: Location) -> Printout:
        """One sheet for the instructor, with the fixed words of papers."""
        words = read_paper_words(language)
        with self._typeset([body], language, words, where) as (folder, _):
            pdf = make_pdf(folder)
        source = write_document([body], language, self._size, words, str(find_font_folder()))
        return make_printout(name, pdf, source, language)

    def _print_all(
        self,
        sheets: Mapping[str, SheetT],
        kind: Kind[SheetT],
        print_large: Callable[[TypstPress, Mapping[str, SheetT]], dict[str, Printout]],
    ) -> dict[str, Printout]:
        """Every sheet by its name, those in large print by Typst."""
        large = {name: sheet for name, sheet in sheets.items() if sheet.large}
        usual = {name: sheet for name, sheet in sheets.items() if not sheet.large}
        typst = print_large(TypstPress(self._size), large) if large else {}
        return (self._print(usual, kind) if usual else {}) | typst

    def _print(self, sheets: Mapping[str, SheetT], kind: Kind[SheetT]) -> dict[str, Printout]:
        return {
            name: self._make_printout(name, each, kind)
            for name, each in self._set(sheets, kind).items()
        }

    def _make_printout(self, name: str, ready: _Set[SheetT], kind: Kind[SheetT]) -> Printout:
        language, fonts = ready.sheet.language, str(find_font_folder())
        words, pictures = kind.words(language), kind.pictures(ready.sheet)
        source = write_document([ready.body], language, self._size, words, fonts)
        return make_printout(name, ready.pdf, source, language, pictures)

    def _set(
        self, sheets: Mapping[str, SheetT], kind: Kind[SheetT], least: int | None = None
    ) -> dict[str, _Set[SheetT]]:
        """The pages of every sheet, by its name; all `alike`, where a least number is given, but
        for those before the longest.
        """
        owners = (text for sheet in sheets.values() for text in (sheet.name, sheet.student))
        missing = self.unprintable(owners)
        ready: dict[str, _Set[SheetT]] = {}
        for language in sorted({sheet.language for sheet in sheets.values()}):
            ready |= self._set_class(
                {
                    name: make_owner_legible(sheet, missing)
                    for name, sheet in sheets.items()
                    if sheet.language == language
                },
                language,
                kind,
                least,
            )
        return ready

    def _set_alike(
        self, papers: Mapping[str, Paper], pages: int | None, longest: int
    ) -> dict[str, _Set[Paper]]:
        """The pages of every paper, as many as `alike` says; those before the longest need another
        run.
        """
        first = self._set(papers, PAPERS, longest if pages is None else pages)
        wanted = max([longest, *(each.own for each in first.values())]) if pages is None else pages
        short = {name: each for name, each in first.items() if each.own < wanted}
        unlike = {
            name: replace(papers[name], pages=wanted if name in short else 0)
            for name, each in first.items()
            if each.pages != max(each.own, wanted)
        }
        filled = {
            name: replace(each, body=write_paper_body(replace(each.sheet, pages=wanted)))
            for name, each in short.items()
            if name not in unlike
        }
        return first | filled | self._set(unlike, PAPERS)

    def _set_class(
        self,
        sheets: Mapping[str, SheetT],
        language: Language,
        kind: Kind[SheetT],
        least: int | None,
    ) -> dict[str, _Set[SheetT]]:
        """All sheets of one language, in one run."""
        bodies: list[str] = convert_each(kind.body, sheets.values())
        pictures = {
            name: content
            for sheet in sheets.values()
            for name, content in kind.pictures(sheet).items()
        }
        begun = _FIRST_PAGE if least is None else f"{_FIRST_PAGE}\\alikesheets{{{least}}}\n"
        words = kind.words(language)
        typeset = self._typeset([begun, *bodies], language, words, kind.name, pictures)
        with typeset as (folder, outcome):
            # One page further than the sheets count, as the first page belongs to none of them
            pages = [(first + 1, first + count) for first, count in outcome.ranges]
            pdfs = [make_pdf(folder, part) for part in pages]
        counts = [count for _, count in outcome.ranges]
        own = counts if least is None else outcome.own
        ready = zip(sheets.values(), bodies, pdfs, counts, own, strict=True)
        return {name: _Set(*each) for name, each in zip(sheets, ready, strict=True)}

    @contextmanager
    def _typeset(
        self,
        bodies: list[str],
        language: Language,
        words: Mapping[str, str],
        where: Location,
        pictures: Mapping[str, bytes] = MappingProxyType({}),
    ) -> Iterator[tuple[Path, Outcome]]:
        """The folder where the pages of the bodies lie, as long as the context lasts. Raises
        TypesetError.
        """
        source = write_document(bodies, language, self._size, words, FONTS)
        with temporary_folder() as folder:
            seconds = _START_SECONDS + _SHEET_SECONDS * len(bodies)
            outcome = run(source, folder, seconds, pictures)
            problems = find_faults(outcome, source, where)
            if problems:
                raise TypesetError(*problems)
            yield folder, outcome


def _find_missing(characters: Iterable[str]) -> frozenset[str]:
    """Those of the characters that XeTeX has no font for."""
    words = read_paper_words(ENGLISH)
    source = write_document([" ".join(map(write_plain, characters))], ENGLISH, "a4", words, FONTS)
    with temporary_folder() as folder:
        return run(source, folder, _START_SECONDS).missing
