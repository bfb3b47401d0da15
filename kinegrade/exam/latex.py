"""The second press: papers, worked solutions and keys as PDF, by an installed LaTeX.

One run typesets all sheets it is given; their pages are then split into files. pdflatex serves
while every text is Latin, xelatex where anything else occurs, Chinese set in the installed Noto
fonts. Same input, same bytes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from io import BytesIO
from typing import Any, Generic, TypeVar

import pikepdf

from kinegrade.errors import TypesetError
from kinegrade.exam.document import KeyBook, Paper, PaperSize, SolutionSheet
from kinegrade.exam.join import page_count
from kinegrade.exam.latex_faults import faults
from kinegrade.exam.latex_key import key_body
from kinegrade.exam.latex_run import FONTS, STYLE, Outcome, Program, font_folder, run, style
from kinegrade.exam.latex_solution import solution_body
from kinegrade.exam.latex_source import document, paper_body
from kinegrade.exam.latex_text import is_latin, is_surely_printed, plain
from kinegrade.exam.layout_call import each
from kinegrade.exam.press import Printout
from kinegrade.exam.solution_words import solution_words_of
from kinegrade.exam.typst import legible_owner, legible_owners
from kinegrade.exam.words import words_of
from kinegrade.language import Language
from kinegrade.temporary import temporary_folder

START_SECONDS = 60.0
SHEET_SECONDS = 5.0  # some fifty times what a sheet takes

Sheet = TypeVar("Sheet", Paper, SolutionSheet)


@dataclass(frozen=True)
class Kind(Generic[Sheet]):
    """One of the two kinds of sheets: what it is called, and how its sources are written."""

    name: str
    body: Callable[[Sheet, int], str]
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
        (`unprintable` tells which). Raises TypesetError with all faults of the papers' texts, with
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
        outcome = self._typeset([body], book.language, words, "key")
        [pdf] = _parts(outcome.pdf, [(0, page_count(outcome.pdf))])
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
        bodies = each(
            lambda numbered: kind.body(numbered[1], numbered[0]), enumerate(sheets.values())
        )
        outcome = self._typeset(bodies, language, words, kind.name)
        pdfs = _parts(outcome.pdf, [(first, count) for _, first, count in outcome.ranges])
        return {
            name: _printout(name, pdf, document([body], language, self._size, words, fonts))
            for name, body, pdf in zip(sheets, bodies, pdfs, strict=True)
        }

    def _typeset(self, bodies: list[str], language: Language, words: Any, where: str) -> Outcome:
        """The pages of the bodies. Raises TypesetError."""
        program = _program([*bodies, str(words)])
        source = document(bodies, language, self._size, words, FONTS)
        with temporary_folder() as folder:
            outcome = run(program, source, folder, START_SECONDS + SHEET_SECONDS * len(bodies))
        problems = faults(outcome, source, where)
        if problems:
            raise TypesetError(*problems)
        return outcome


def _printout(name: str, pdf: bytes, source: str) -> Printout:
    """The pages, and their source with the style that it asks for."""
    text = _introduction(name, source) + source
    return Printout(pdf, {f"{name}.tex": text.encode(), STYLE: style().encode()})


def _program(texts: Iterable[str]) -> Program:
    return "pdflatex" if all(map(is_latin, texts)) else "xelatex"


def _missing(characters: Iterable[str]) -> frozenset[str]:
    """Those of the characters that XeTeX has no font for."""
    words = words_of("en")
    source = document([" ".join(map(plain, characters))], "en", "a4", words, FONTS)
    with temporary_folder() as folder:
        return run("xelatex", source, folder, START_SECONDS).missing


def _parts(pdf: bytes, parts: Iterable[tuple[int, int]]) -> Iterator[bytes]:
    """Each part, given by its first page and the number of its pages; same input, same bytes."""
    with pikepdf.open(BytesIO(pdf)) as whole:
        for first, count in parts:
            stream = BytesIO()
            with pikepdf.new() as part:
                part.pages.extend(whole.pages[first : first + count])
                part.save(stream, deterministic_id=True)
            yield stream.getvalue()


def _introduction(name: str, source: str) -> str:
    return (
        f"% Change it as you like. To typeset it, here in its folder:  {_program([source])} "
        f"{name}.tex\n"
    )
