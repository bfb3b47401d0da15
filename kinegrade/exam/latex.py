"""The second press: papers, worked solutions and keys as PDF, by an installed LaTeX.

One run typesets all sheets it is given; their pages are then split into files. pdflatex serves
while every text is Latin, xelatex where anything else occurs, Chinese set in the installed Noto
fonts. Same input, same bytes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, TypeVar

import pikepdf

from kinegrade.errors import TypesetError
from kinegrade.exam.document import KeyBook, Paper, PaperSize, SolutionSheet
from kinegrade.exam.latex_faults import faults
from kinegrade.exam.latex_key import key_body
from kinegrade.exam.latex_run import FONTS, STYLE, Outcome, Program, font_folder, run, style
from kinegrade.exam.latex_solution import solution_body
from kinegrade.exam.latex_source import document, paper_body
from kinegrade.exam.latex_text import is_latin, is_surely_printed, plain
from kinegrade.exam.layout_call import each
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
    """One of the two kinds of sheets: where its sources are kept, and how they are written."""

    folder: str
    body: Callable[[Sheet, int], str]
    words: Callable[[str], Any]


PAPERS: Kind[Paper] = Kind("papers", paper_body, words_of)
SOLUTIONS: Kind[SolutionSheet] = Kind("solutions", solution_body, solution_words_of)


class LatexPress:
    """Prints as `kinegrade.exam.press` says; `paper_size` is "a4" or "letter".

    Where a folder `sources` is given, the LaTeX source of everything printed is kept there to be
    edited.
    """

    def __init__(self, paper_size: PaperSize = "a4", sources: Path | None = None) -> None:
        self._size: PaperSize = paper_size
        self._sources = sources
        self._looked_at: dict[str, bool] = {}  # whether a font prints a character

    def papers(self, papers: Mapping[str, Paper], folder: Path) -> None:
        """Write `folder/NAME.pdf` for every paper, all typeset in one run.

        Characters of a student's name and id that no font has are printed as code points
        (`unprintable` tells which). Raises TypesetError with all faults of the papers' texts, with
        the first fault that TeX finds, or where TeX is not installed.
        """
        self._print(papers, PAPERS, folder)

    def solutions(self, sheets: Mapping[str, SolutionSheet], folder: Path) -> None:
        """Write `folder/NAME.pdf` for every student's worked solutions; raises TypesetError as
        `papers` does.
        """
        self._print(sheets, SOLUTIONS, folder)

    def key(self, book: KeyBook, target: Path) -> None:
        """Write the instructor's key; names are printed and errors raised as by `papers`."""
        named = legible_owners(book, self)
        body, words = key_body(named), words_of(book.language)
        with self._typeset([body], book.language, words, "key") as outcome:
            _write_pages(outcome.pdf, [(0, _page_count(outcome.pdf), target)])
        self._keep(
            "", {"key": document([body], book.language, self._size, words, str(font_folder()))}
        )

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

    def _print(self, sheets: Mapping[str, Sheet], kind: Kind[Sheet], folder: Path) -> None:
        owners = (text for sheet in sheets.values() for text in (sheet.name, sheet.student))
        missing = self.unprintable(owners)
        for language in sorted({sheet.language for sheet in sheets.values()}):
            self._print_class(
                {
                    name: legible_owner(sheet, missing)
                    for name, sheet in sheets.items()
                    if sheet.language == language
                },
                language,
                kind,
                folder,
            )

    def _print_class(
        self, sheets: Mapping[str, Sheet], language: Language, kind: Kind[Sheet], folder: Path
    ) -> None:
        """All sheets of one language."""
        words = kind.words(language)
        bodies = dict(
            zip(
                sheets,
                each(
                    lambda numbered: kind.body(numbered[1], numbered[0]), enumerate(sheets.values())
                ),
                strict=True,
            )
        )
        with self._typeset(list(bodies.values()), language, words, kind.folder) as outcome:
            _write_pages(
                outcome.pdf,
                [
                    (first, count, folder / f"{name}.pdf")
                    for name, (_, first, count) in zip(bodies, outcome.ranges, strict=True)
                ],
            )
        self._keep(
            kind.folder,
            {
                name: document([body], language, self._size, words, str(font_folder()))
                for name, body in bodies.items()
            },
        )

    @contextmanager
    def _typeset(
        self, bodies: list[str], language: Language, words: Any, where: str
    ) -> Iterator[Outcome]:
        """The pages of the bodies, as long as the context lasts. Raises TypesetError."""
        program = _program([*bodies, str(words)])
        source = document(bodies, language, self._size, words, FONTS)
        with temporary_folder() as folder:
            outcome = run(program, source, folder, START_SECONDS + SHEET_SECONDS * len(bodies))
            problems = faults(outcome, source, where)
            if problems:
                raise TypesetError(*problems)
            yield outcome

    def _keep(self, folder: str, documents: Mapping[str, str]) -> None:
        """The sources, with the style they ask for beside them."""
        if self._sources is None:
            return
        kept = self._sources / folder
        kept.mkdir(parents=True, exist_ok=True)
        (kept / STYLE).write_text(style(), encoding="utf-8")
        for name, source in documents.items():
            (kept / f"{name}.tex").write_text(
                _introduction(name, source) + source, encoding="utf-8", newline="\n"
            )


def _program(texts: Iterable[str]) -> Program:
    return "pdflatex" if all(map(is_latin, texts)) else "xelatex"


def _missing(characters: Iterable[str]) -> frozenset[str]:
    """Those of the characters that XeTeX has no font for."""
    words = words_of("en")
    source = document([" ".join(map(plain, characters))], "en", "a4", words, FONTS)
    with temporary_folder() as folder:
        return run("xelatex", source, folder, START_SECONDS).missing


def _write_pages(pdf: Path, parts: Iterable[tuple[int, int, Path]]) -> None:
    """Each part, given by its first page and the number of its pages, as a file; same input, same
    bytes.
    """
    with pikepdf.open(pdf) as whole:
        for first, count, target in parts:
            with pikepdf.new() as part:
                part.pages.extend(whole.pages[first : first + count])
                part.save(target, deterministic_id=True)


def _page_count(pdf: Path) -> int:
    with pikepdf.open(pdf) as whole:
        return len(whole.pages)


def _introduction(name: str, source: str) -> str:
    return (
        f"% Change it as you like. To typeset it, here in its folder:  {_program([source])} "
        f"{name}.tex\n"
    )
