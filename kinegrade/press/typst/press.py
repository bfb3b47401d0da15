"""The press that needs no installation: papers, solutions, keys and galleries as PDF, by the
embedded Typst.

A press keeps one compiler, which is what makes it fast; a compiler belongs to one thread, so keep
one press per thread or process. Same input, same bytes: the fonts come with the installation and
the date is fixed. PDF/UA-1 also refuses a character that no font has; names are checked before.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Literal, TypeVar

import typst

from kinegrade.errors import Problem, TypesetError
from kinegrade.language.gathering import convert_each
from kinegrade.language.message import Location, Message
from kinegrade.language.typst_text import write_literal
from kinegrade.press.binding.part import count_pages
from kinegrade.press.gallery_sheet import Gallery
from kinegrade.press.join import join_pages
from kinegrade.press.legible import make_legible, make_owner_legible, make_owners_legible
from kinegrade.press.places import GALLERY, KEY, locate_paper, locate_question, locate_solutions
from kinegrade.press.protocol import Press, Printout
from kinegrade.press.sheet import KeyBook, Paper, PaperSize, SolutionSheet
from kinegrade.press.typst.alike import AlikePapers
from kinegrade.press.typst.compiler import make_compiler
from kinegrade.press.typst.faults import explain, find_boxed
from kinegrade.press.typst.paper import write_paper_source

if TYPE_CHECKING:
    from kinegrade.press.archive_page import ArchivePage
    from kinegrade.press.cycle_page import CyclePage

# Papers in one compilation: Typst keeps the layouts of its last ten, 3 MB for the key of each paper
KEY_CHUNK = 10
# 2000-01-01 00:00 UTC, in seconds, so that the bytes do not depend on the day
_FIXED_TIME = 946684800

_DATE = "#set document(date: datetime(year: 2000, month: 1, day: 1))\n"

# No font has a control character, but the compiler says so of some texts only; breaks are layout
_CONTROL = frozenset(map(chr, range(32))) - frozenset("\n\t")

_Sheet = TypeVar("_Sheet", Paper, SolutionSheet)


class TypstPress(Press):
    """Prints as `kinegrade.press.protocol` says, and galleries; `paper_size` is "a4" or "letter".

    >>> TypstPress().unprintable(["Zoë", "张喆", "😀"])
    frozenset({'😀'})
    """

    def __init__(self, paper_size: PaperSize = "a4") -> None:
        self._size: PaperSize = paper_size
        self._compiler = make_compiler()
        self._looked_at: dict[str, bool] = {}  # whether a font prints a character

    def papers(self, papers: Mapping[str, Paper]) -> dict[str, Printout]:
        """Every paper, by its name. Raises TypesetError with all faults of all of them."""
        return _print_each(papers, self.paper)

    def alike(
        self, papers: Mapping[str, Paper], pages: int | None, longest: int = 0
    ) -> tuple[dict[str, Printout], dict[str, int]]:
        """Every paper and how many pages it has, as `Press` says. Raises TypesetError as `papers`
        does.
        """
        filling = AlikePapers(pages, longest, self.paper)
        printed = _print_each(papers, filling)
        short = filling.find_short(papers)
        counts = dict(zip(papers, filling.counts, strict=True))
        return printed | self.papers(short), counts | {
            name: paper.pages for name, paper in short.items()
        }

    def solutions(self, sheets: Mapping[str, SolutionSheet]) -> dict[str, Printout]:
        """Every student's worked solutions, by name. Raises TypesetError as `papers` does."""
        return _print_each(sheets, self.solution)

    def paper(self, paper: Paper) -> bytes:
        """One student's paper as PDF.

        Characters of the student's name and id that no font has are printed as code points
        (`unprintable` gives them). Raises TypesetError with all faults of the paper's texts, other
        such characters among them.
        """
        named = self._legible(paper)
        try:
            return self._compile(write_paper_source(named, self._size))
        except typst.TypstError as error:
            problems = self._faults(named) or explain(error, locate_paper(paper.code))
            raise TypesetError(*problems) from error

    def page_images(self, paper: Paper, ppi: int = 100) -> list[bytes]:
        """The pages of a paper as PNG, `ppi` pixels to the inch; raises TypesetError as `paper`
        does.
        """
        self.paper(paper)
        named = self._legible(paper)
        source = write_paper_source(named, self._size).encode()
        images = self._compiler.compile(source, format="png", ppi=ppi, timestamp=_FIXED_TIME)
        pages = images if isinstance(images, list) else [images]
        return [page for page in pages if page is not None]

    def solution(self, sheet: SolutionSheet) -> bytes:
        """One student's worked solutions as PDF, as short as `set_short` makes them; names are
        printed and errors raised as by `paper`.
        """
        from kinegrade.press.typst.solution_pages import set_short

        where = locate_solutions(sheet.code)
        return set_short(
            self._legible(sheet), self._size, lambda source: self._explaining(source, where)
        )

    def key(self, book: KeyBook) -> Printout:
        """The instructor's key; names are printed and errors raised as by `paper`."""
        return Printout(join_pages(self._key_parts(book)))

    def gallery(self, gallery: Gallery, where: Location = GALLERY) -> bytes:
        """A contact sheet of templates as PDF. Raises TypesetError; a character that no font has is
        reported at `where`.
        """
        from kinegrade.press.typst.gallery import write_gallery_source

        return self._explaining(write_gallery_source(gallery, self._size), where)

    def cycle(self, page: CyclePage) -> bytes:
        """The page of a cycle as PDF. Raises TypesetError."""
        from kinegrade.press.typst.cycle_page import write_cycle_page_source

        return self._explaining(write_cycle_page_source(page, self._size), Message("motion.page"))

    def archive_page(self, page: ArchivePage) -> bytes:
        """The page that is kept with an archive, as PDF. Raises TypesetError; characters of ids
        that no font has are printed as code points.
        """
        from kinegrade.press.typst.archive_page import write_archive_page_source

        texts = (page.title, *(part for line in (*page.facts, *page.codes) for part in line))
        missing = self.unprintable(texts)
        codes = tuple((make_legible(student, missing), code) for student, code in page.codes)
        source = write_archive_page_source(replace(page, codes=codes), self._size)
        return self._explaining(source, Message("archive.page"))

    def require_printable(self, source: str, where: Location) -> None:
        """Raises TypesetError, naming `where`, for Typst code that cannot be typeset."""
        try:
            self._pdf(f"{_DATE}{source}", "a-2b")
        except typst.TypstError as error:
            raise TypesetError(*explain(error, where)) from error

    def unprintable(self, texts: Iterable[str]) -> frozenset[str]:
        """The characters of `texts` that no font of the press can print: one check for a whole
        roster.
        """
        used = {character for text in texts for character in text}
        characters = {character for character in used if ord(character) > 126}
        unknown = characters - self._looked_at.keys()
        missing: set[str] = set()
        while found := self._boxes(sorted(unknown - missing)):
            missing |= found
        self._looked_at |= {character: character not in missing for character in unknown}
        without = {character for character in characters if not self._looked_at[character]}
        return frozenset(used & _CONTROL | without)

    def _key_parts(self, book: KeyBook) -> Iterator[bytes]:
        from kinegrade.press.typst.key import write_key_source

        first_page = 1
        for part in book.chunks(KEY_CHUNK):
            pdf = self._explaining(
                write_key_source(make_owners_legible(part, self), first_page, self._size), KEY
            )
            first_page += count_pages(pdf)
            yield pdf

    def _legible(self, sheet: _Sheet) -> _Sheet:
        return make_owner_legible(sheet, self.unprintable([sheet.name, sheet.student]))

    def _boxes(self, characters: Sequence[str]) -> set[str]:
        """Those of `characters` that the compiler complains about; it may take several runs to find
        all.
        """
        if not characters:
            return set()
        try:
            self._pdf(
                _DATE + "".join(f"#box({write_literal(character)})\n" for character in characters),
                "a-2b",
            )
        except typst.TypstError as error:
            return set("".join(find_boxed(error)))
        return set()

    def _faults(self, paper: Paper) -> tuple[Problem, ...]:
        """What the compiler says of the frame around the questions, or else of each question
        alone.
        """
        where = locate_paper(paper.code)
        frame = self._fault(replace(paper, questions=()), where)
        if frame:
            return frame
        alone = (replace(paper, questions=(question,)) for question in paper.questions)
        return tuple(
            problem
            for part in alone
            for problem in self._fault(part, locate_question(where, part.questions[0].identifier))
        )

    def _fault(self, paper: Paper, where: Location) -> tuple[Problem, ...]:
        try:
            self._compile(write_paper_source(paper, self._size))
        except typst.TypstError as error:
            return explain(error, where)
        return ()

    def _explaining(self, source: str, where: Location) -> bytes:
        try:
            return self._compile(source)
        except typst.TypstError as error:
            raise TypesetError(*explain(error, where)) from error

    def _compile(self, source: str) -> bytes:
        """The PDF of a layout. Raises TypstError, also for a character that no font prints."""
        return self._pdf(source, "ua-1")

    def _pdf(self, source: str, standard: Literal["a-2b", "ua-1"]) -> bytes:
        pdf = self._compiler.compile(
            source.encode(), format="pdf", pdf_standards=standard, timestamp=_FIXED_TIME
        )
        return pdf if isinstance(pdf, bytes) else b"".join(pdf or ())


def _print_each(
    sheets: Mapping[str, _Sheet], pdf: Callable[[_Sheet], bytes]
) -> dict[str, Printout]:
    """Every sheet by its name, one at a time; one error with the faults of all, each reported
    once.
    """
    try:
        pages = convert_each(pdf, sheets.values())
    except TypesetError as error:
        raise TypesetError(*dict.fromkeys(error.faults)) from error
    return dict(zip(sheets, map(Printout, pages), strict=True))
