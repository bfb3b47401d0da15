"""The press: papers, keys and galleries as PDF, by the embedded Typst.

A press keeps one compiler, which is what makes it fast; a compiler belongs to one thread, so keep one press
per thread or process. Same input, same bytes: the fonts come with the installation and the date is fixed.
PDF/A-2b is asked for because it refuses a character that no font can print; plain PDF prints a box silently.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from importlib.resources import files

import typst

from kinegrade.errors import TypesetError
from kinegrade.exam.document import Gallery, KeyBook, Paper, PaperSize
from kinegrade.exam.fonts import installed_fonts
from kinegrade.exam.formula import literal
from kinegrade.exam.join import joined, page_count
from kinegrade.exam.typst_source import gallery_source, key_source, paper_source

KEY_CHUNK = 25  # papers in one compilation: 234 MB at 25, 326 MB at 50, the time a paper is the same
FIXED_TIME = 946684800  # 2000-01-01 00:00 UTC, in seconds, so that the bytes do not depend on the day

_BOX = re.compile(r'the text `"(.*?)"` could not be displayed')
_ESCAPE = re.compile(r"\\u\{([0-9a-f]+)\}")


class TypstPress:
    """Prints papers, keys and galleries; `paper_size` is "a4" or "letter".

    >>> TypstPress().unprintable(["Zoë", "张喆", "😀"])
    frozenset({'😀'})
    """

    def __init__(self, paper_size: PaperSize = "a4") -> None:
        self._size: PaperSize = paper_size
        layouts = str(files("kinegrade.exam") / "layouts")  # as root: Typst reads no other folder
        self._compiler = typst.Compiler(root=layouts, font_paths=installed_fonts(), ignore_system_fonts=True)

    def paper(self, paper: Paper) -> bytes:
        """One student's paper as PDF.

        Characters of the student's name that no font has are printed as code points (`unprintable` tells
        which). Raises TypesetError with all faults of the paper's texts, other such characters among them.
        """
        try:
            return self._compile(paper_source(paper, self._size))
        except typst.TypstError:
            named = replace(paper, name=legible(paper.name, self.unprintable([paper.name])))
        try:
            return self._compile(paper_source(named, self._size))
        except typst.TypstError as error:
            problems = self._faults(named) or _explained(error, f"paper {paper.code}")
            raise TypesetError(*problems) from error

    def page_images(self, paper: Paper, ppi: int = 100) -> list[bytes]:
        """The pages of a paper as PNG, `ppi` pixels to the inch; raises TypesetError as `paper` does."""
        self.paper(paper)
        named = replace(paper, name=legible(paper.name, self.unprintable([paper.name])))
        source = paper_source(named, self._size).encode()
        images = self._compiler.compile(source, format="png", ppi=ppi, timestamp=FIXED_TIME)
        pages = images if isinstance(images, list) else [images]
        return [page for page in pages if page is not None]

    def key(self, book: KeyBook) -> bytes:
        """The instructor's key as PDF; names are printed and errors raised as by `paper`."""
        missing = self.unprintable(paper.name for paper in book.papers)
        papers = tuple(replace(paper, name=legible(paper.name, missing)) for paper in book.papers)
        return joined(self._key_parts(replace(book, papers=papers)))

    def gallery(self, gallery: Gallery, where: str = "gallery") -> bytes:
        """A contact sheet of templates as PDF. Raises TypesetError; a character that no font has is told of `where`."""
        return self._explaining(gallery_source(gallery, self._size), where)

    def unprintable(self, texts: Iterable[str]) -> frozenset[str]:
        """The characters of `texts` that no font of the press can print: one look for a whole roster."""
        characters = {character for text in texts for character in text if ord(character) > 126}
        missing: set[str] = set()
        while found := self._boxes(sorted(characters - missing)):
            missing |= found
        return frozenset(missing)

    def _key_parts(self, book: KeyBook) -> Iterator[bytes]:
        first_page = 1
        for part in book.chunks(KEY_CHUNK):
            pdf = self._explaining(key_source(part, first_page, self._size), "key")
            first_page += page_count(pdf)
            yield pdf

    def _boxes(self, characters: Iterable[str]) -> set[str]:
        """Those of `characters` that the compiler complains of; it may need several looks to find all."""
        date = "#set document(date: datetime(year: 2000, month: 1, day: 1))\n"
        try:
            self._compile(date + "".join(f"#box({literal(character)})\n" for character in characters))
        except typst.TypstError as error:
            return set("".join(_boxed(error)))
        return set()

    def _faults(self, paper: Paper) -> tuple[str, ...]:
        """What the compiler says of the frame around the questions, or else of each question alone."""
        where = f"paper {paper.code}"
        frame = self._fault(replace(paper, questions=()), where)
        if frame:
            return frame
        alone = (replace(paper, questions=(question,)) for question in paper.questions)
        return tuple(
            problem
            for part in alone
            for problem in self._fault(part, f"{where}, {part.questions[0].identifier}")
        )

    def _fault(self, paper: Paper, where: str) -> tuple[str, ...]:
        try:
            self._compile(paper_source(paper, self._size))
        except typst.TypstError as error:
            return _explained(error, where)
        return ()

    def _explaining(self, source: str, where: str) -> bytes:
        try:
            return self._compile(source)
        except typst.TypstError as error:
            raise TypesetError(*_explained(error, where)) from error

    def _compile(self, source: str) -> bytes:
        pdf = self._compiler.compile(
            source.encode(), format="pdf", pdf_standards=["a-2b"], timestamp=FIXED_TIME
        )
        return pdf if isinstance(pdf, bytes) else b"".join(pdf or ())


def legible(name: str, missing: frozenset[str]) -> str:
    """`name` with each character in `missing` written as its code point.

    >>> legible("Zoë 😀", frozenset("😀"))
    'Zoë [U+1F600]'
    """
    return "".join(f"[U+{ord(character):04X}]" if character in missing else character for character in name)


def _boxed(error: typst.TypstError) -> list[str]:
    """The texts that would print as boxes, as the compiler quotes them."""
    quoted = _BOX.findall(error.diagnostic)
    return [_ESCAPE.sub(lambda match: chr(int(match[1], 16)), text) for text in quoted]


def _explained(error: typst.TypstError, where: str) -> tuple[str, ...]:
    boxed = dict.fromkeys("".join(_boxed(error)))
    if not boxed:
        return (f"{where}: {error.message}; expected math that can be typeset; mend the formulas",)
    return tuple(
        f"{where}: no font prints {character} (U+{ord(character):04X}); expected Latin, Greek, Cyrillic or"
        " Chinese; write it otherwise"
        for character in boxed
    )
