"""The second press: papers, worked solutions and keys as PDF, by an installed LaTeX.

One run of XeTeX typesets all sheets it is given, Chinese in the installed Noto fonts; the pages of
each then become a separate PDF. Same sheet, same bytes, whatever else is in the run.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path, PurePosixPath
from types import MappingProxyType
from typing import Generic, TypeVar

from kinegrade.errors import TypesetError
from kinegrade.files.temporary import temporary_folder
from kinegrade.language import ENGLISH, Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.gathering import convert_each
from kinegrade.language.math.latex_text import is_surely_printed, write_plain
from kinegrade.language.message import Location
from kinegrade.press.latex.document import write_document
from kinegrade.press.latex.faults import find_faults
from kinegrade.press.latex.key import write_key_body
from kinegrade.press.latex.paper import name_logo, write_paper_body
from kinegrade.press.latex.solution import write_solution_body
from kinegrade.press.latex.xetex import (
    CLASS,
    FONTS,
    STYLE,
    Outcome,
    find_font_folder,
    make_pdf,
    run,
    write_style,
)
from kinegrade.press.legible import make_owner_legible, make_owners_legible
from kinegrade.press.paper_head import PaperHead
from kinegrade.press.places import ALL_PAPERS, ALL_SOLUTIONS, KEY
from kinegrade.press.protocol import Press, Printout
from kinegrade.press.sheet import KeyBook, Paper, PaperSize, SolutionSheet
from kinegrade.press.typst.logo import print_logo
from kinegrade.press.typst.press import TypstPress

# TeX writes some things only on the first page of a run (its initial colour): this page, which is
# left out
_FIRST_PAGE = f"\\input{{{CLASS}}}\\mbox{{}}\\clearpage\n"
_START_SECONDS = 60.0
_SHEET_SECONDS = 5.0  # some fifty times what a sheet takes

_Sheet = TypeVar("_Sheet", Paper, SolutionSheet)


@dataclass(frozen=True)
class _Kind(Generic[_Sheet]):
    """One of the two kinds of sheets: what it is called, and how its sources are written."""

    name: Location
    body: Callable[[_Sheet], str]
    words: Callable[[Language], Mapping[str, str]]
    pictures: Callable[[_Sheet], Mapping[str, bytes]] = lambda _: {}


def _read_paper_words(language: Language) -> Mapping[str, str]:
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


_PAPERS: _Kind[Paper] = _Kind(
    ALL_PAPERS, write_paper_body, _read_paper_words, lambda paper: _print_pictures(paper.head)
)
_SOLUTIONS: _Kind[SolutionSheet] = _Kind(ALL_SOLUTIONS, write_solution_body, _read_solution_words)


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
        return self._print_all(papers, _PAPERS, TypstPress.papers)

    def solutions(self, sheets: Mapping[str, SolutionSheet]) -> dict[str, Printout]:
        """Every student's worked solutions, as `papers` does it."""
        return self._print_all(sheets, _SOLUTIONS, TypstPress.solutions)

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
        words = _read_paper_words(language)
        with self._typeset([body], language, words, where) as (folder, _):
            pdf = make_pdf(folder)
        source = write_document([body], language, self._size, words, str(find_font_folder()))
        return _make_printout(name, pdf, source, language)

    def _print_all(
        self,
        sheets: Mapping[str, _Sheet],
        kind: _Kind[_Sheet],
        print_large: Callable[[TypstPress, Mapping[str, _Sheet]], dict[str, Printout]],
    ) -> dict[str, Printout]:
        """Every sheet by its name, those in large print by Typst."""
        large = {name: sheet for name, sheet in sheets.items() if sheet.large}
        usual = {name: sheet for name, sheet in sheets.items() if not sheet.large}
        typst = print_large(TypstPress(self._size), large) if large else {}
        return (self._print(usual, kind) if usual else {}) | typst

    def _print(self, sheets: Mapping[str, _Sheet], kind: _Kind[_Sheet]) -> dict[str, Printout]:
        owners = (text for sheet in sheets.values() for text in (sheet.name, sheet.student))
        missing = self.unprintable(owners)
        printed: dict[str, Printout] = {}
        for language in sorted({sheet.language for sheet in sheets.values()}):
            printed |= self._print_class(
                {
                    name: make_owner_legible(sheet, missing)
                    for name, sheet in sheets.items()
                    if sheet.language == language
                },
                language,
                kind,
            )
        return printed

    def _print_class(
        self, sheets: Mapping[str, _Sheet], language: Language, kind: _Kind[_Sheet]
    ) -> dict[str, Printout]:
        """All sheets of one language."""
        words, fonts = kind.words(language), str(find_font_folder())
        bodies: list[str] = convert_each(kind.body, sheets.values())
        pictures = {
            name: content
            for sheet in sheets.values()
            for name, content in kind.pictures(sheet).items()
        }
        typeset = self._typeset([_FIRST_PAGE, *bodies], language, words, kind.name, pictures)
        with typeset as (folder, outcome):
            # One page further than the sheets count, as the first page belongs to none of them
            pages = [(first + 1, first + count) for first, count in outcome.ranges]
            pdfs = [make_pdf(folder, part) for part in pages]
        return {
            name: _make_printout(
                name,
                pdf,
                write_document([body], language, self._size, words, fonts),
                language,
                pictures,
            )
            for name, body, pdf in zip(sheets, bodies, pdfs, strict=True)
        }

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


def _make_printout(
    name: str,
    pdf: bytes,
    source: str,
    language: Language,
    pictures: Mapping[str, bytes] = MappingProxyType({}),
) -> Printout:
    """The pages, and their source with the style and the pictures that it asks for beside it."""
    place = PurePosixPath(name)
    text = _write_introduction(place.name, language) + source
    files = {f"{place.name}.tex": text.encode(), STYLE: write_style().encode(), **pictures}
    return Printout(pdf, {str(place.with_name(beside)): files[beside] for beside in files})


def _find_missing(characters: Iterable[str]) -> frozenset[str]:
    """Those of the characters that XeTeX has no font for."""
    words = _read_paper_words(ENGLISH)
    source = write_document([" ".join(map(write_plain, characters))], ENGLISH, "a4", words, FONTS)
    with temporary_folder() as folder:
        return run(source, folder, _START_SECONDS).missing


def _write_introduction(name: str, language: Language) -> str:
    words = open_catalogue(language)
    return f"% {words.text('typesetting.source', file=f'{name}.tex')}\n"
