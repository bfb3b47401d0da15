"""Papers for people who edit them: Word (.docx) with native equations, tables and styles, and HTML
in one file.

pandoc writes both of one tree (`kinegrade.press.word.paper`), with no file but the reference
document of Word's styles. Same input, same bytes.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping
from functools import cached_property
from typing import Literal, get_args

from kinegrade.errors import TypesetError, suggest
from kinegrade.figure.back_ends.typst import write_typst
from kinegrade.figure.scene import Scene
from kinegrade.files.temporary import temporary_folder
from kinegrade.language.message import Fault, Message
from kinegrade.press.html.page import write_page
from kinegrade.press.sheet import Paper, PaperSize
from kinegrade.press.typst.compiler import make_compiler
from kinegrade.press.typst.logo import print_logo
from kinegrade.press.word.pandoc import Kind, run_bare_pandoc, run_pandoc
from kinegrade.press.word.paper import write_paper_tree
from kinegrade.press.word.reference import make_word_reference

_KINDS: tuple[Kind, ...] = get_args(Kind)
_Picture = Literal["png", "svg"]
_MEDIA_TYPES: Mapping[_Picture, str] = {"png": "image/png", "svg": "image/svg+xml"}
_PIXELS = 300  # to the inch, of a figure in Word


class PandocPress:
    """Writes papers as Word or HTML; keep one for many papers, and one for each thread or
    process.
    """

    def __init__(self, paper_size: PaperSize = "a4") -> None:
        self._size: PaperSize = paper_size
        self._compiler = make_compiler()

    def also(self, paper: Paper, kind: str) -> bytes:
        """The paper as "docx" or "html". Raises TypesetError as `docx` and `html` do, and for
        another kind.
        """
        match kind:
            case "docx":
                return self.docx(paper)
            case "html":
                return self.html(paper)
            case _:
                raise TypesetError(
                    Fault(kind, Message("typesetting.no-kind"), do=suggest(kind, _KINDS))
                )

    def docx(self, paper: Paper) -> bytes:
        """The paper for Word. Raises TypesetError with all faults of its texts, and where there is
        no pandoc.
        """
        reference = make_word_reference(self._default_reference, paper, self._size)
        logo = _write_address("png", print_logo(paper.head.logo, "png")) if paper.head.logo else ""
        tree = write_paper_tree(paper, self._figures(paper, "png"), logo)
        with temporary_folder() as folder:
            file = folder / "reference.docx"
            file.write_bytes(reference)
            return run_pandoc("docx", ["--reference-doc", str(file)], tree)

    def html(self, paper: Paper) -> bytes:
        """The paper as one HTML file, in UTF-8. Raises TypesetError as `docx` does."""
        logo = _write_address("svg", paper.head.logo.encode()) if paper.head.logo else ""
        tree = write_paper_tree(paper, self._figures(paper, "svg"), logo)
        body = run_pandoc("html", ["--mathml"], tree).decode()
        return write_page(paper, body, self._size)

    @cached_property
    def _default_reference(self) -> bytes:
        return run_bare_pandoc("docx", ["--print-default-data-file", "reference.docx"], b"")

    def _figures(self, paper: Paper, kind: _Picture) -> dict[int, str]:
        """The figure of each question as a data URI."""
        return {
            question.number: self._picture(question.figure, kind)
            for question in paper.questions
            if question.figure
        }

    def _picture(self, scene: Scene, kind: _Picture) -> str:
        source = f'#import "/figure.typ": figure-alone\n#show: figure-alone\n{write_typst(scene)}\n'
        image = self._compiler.compile(source.encode(), format=kind, ppi=_PIXELS)
        return _write_address(kind, image if isinstance(image, bytes) else b"")


def _write_address(kind: _Picture, image: bytes) -> str:
    return f"data:{_MEDIA_TYPES[kind]};base64,{b64encode(image).decode()}"
