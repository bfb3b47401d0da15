"""Papers for people who edit them: Word (.docx) with native equations, tables and styles, and HTML
in one file.

pandoc writes both, and is an optional extra. It receives a document of values
(`kinegrade.exam.paper_tree`) with no text to parse, and runs in its sandbox with no file but the
reference document of Word's styles. Same input, same bytes.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from html import escape
from importlib import import_module
from importlib.resources import files
from shutil import which
from string import Template
from typing import Literal, get_args

from kinegrade.errors import TypesetError, did_you_mean, write_message
from kinegrade.exam.paper_tree import write_paper_tree
from kinegrade.exam.word_reference import fill_layout, make_word_reference
from kinegrade.figure.scene import Scene
from kinegrade.figure.typst import write_typst
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.math.reading import write_formula_place
from kinegrade.press.program_run import run_program
from kinegrade.press.sheet import Paper, PaperSize
from kinegrade.press.typst.compiler import make_compiler
from kinegrade.temporary import temporary_folder

_Kind = Literal["docx", "html"]
_KINDS: tuple[_Kind, ...] = get_args(_Kind)
_Picture = Literal["png", "svg"]
_MEDIA_TYPES: Mapping[_Picture, str] = {"png": "image/png", "svg": "image/svg+xml"}
MISSING = "pandoc not found - expected the optional extra - pip install 'kinegrade[word]'"
_PIXELS = 300  # to the inch, of a figure in Word
_SECONDS = 60  # a paper takes a fraction of one
_CSS_SIZES = {"a4": "A4", "letter": "letter"}
_UNREAD = re.compile(r"Could not convert TeX math (.*?), rendering as TeX")


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
                    write_message(
                        kind,
                        "not a kind of file that papers are written in",
                        do=did_you_mean(kind, _KINDS),
                    )
                )

    def docx(self, paper: Paper) -> bytes:
        """The paper for Word. Raises TypesetError with all faults of its texts, and where there is
        no pandoc.
        """
        reference = make_word_reference(self._default_reference, paper, self._size)
        tree = write_paper_tree(paper, self._figures(paper, "png"))
        with temporary_folder() as folder:
            file = folder / "reference.docx"
            file.write_bytes(reference)
            return _run_pandoc("docx", ["--reference-doc", str(file)], tree)

    def html(self, paper: Paper) -> bytes:
        """The paper as one HTML file, in UTF-8. Raises TypesetError as `docx` does."""
        body = _run_pandoc(
            "html", ["--mathml"], write_paper_tree(paper, self._figures(paper, "svg"))
        ).decode()
        page = Template(
            (files("kinegrade.exam") / "layouts" / "paper.html").read_text(encoding="utf-8")
        )
        words = open_catalogue(paper.language)
        owner = f"{words.text('paper.owner', code=paper.code)} · {paper.student}"
        style = fill_layout("paper.css", size=_CSS_SIZES[self._size])
        return page.substitute(
            language=words.text("language.tag"),
            title=escape(f"{paper.title} {paper.code}"),
            style=style,
            body=body,
            footer=escape(owner),
        ).encode()

    @cached_property
    def _default_reference(self) -> bytes:
        return _run_program("docx", ["--print-default-data-file", "reference.docx"], b"")

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
        data = b64encode(image if isinstance(image, bytes) else b"").decode()
        return f"data:{_MEDIA_TYPES[kind]};base64,{data}"


def require_pandoc(kinds: Iterable[str]) -> None:
    """Raises TypesetError where there is no pandoc to write these kinds of files."""
    wanted = ", ".join(kinds)
    if which(_find_pandoc(wanted)) is None:
        raise TypesetError(f"{wanted}: {MISSING}")


def _run_pandoc(kind: _Kind, options: Sequence[str], tree: bytes) -> bytes:
    """What pandoc makes of a document."""
    form = ["--from", "json", "--to", kind, "--wrap", "none", "--fail-if-warnings", "--output", "-"]
    return _run_program(kind, [*form, *options], tree)


def _run_program(kind: _Kind, options: Sequence[str], given: bytes) -> bytes:
    """The output of pandoc. Raises TypesetError if there is no pandoc, and with its message if it
    fails or warns.
    """
    command = [_find_pandoc(kind), "--sandbox", *options]
    try:
        result = run_program(command, _SECONDS, given=given)
    except TimeoutError as error:
        raise TypesetError(
            write_message(
                kind, f"pandoc has not ended after {_SECONDS} s", "a fraction of one", "try again"
            )
        ) from error
    except OSError as error:
        raise TypesetError(f"{kind}: {MISSING}") from error
    if result.status:
        raise TypesetError(*_explain(result.complaint.decode(errors="replace"), kind))
    return result.output


def _explain(complaint: str, kind: _Kind) -> tuple[str, ...]:
    """What pandoc complains about, usually formulas."""
    said = " ".join(complaint.split())
    formulas = tuple(dict.fromkeys(_UNREAD.findall(said)))
    if not formulas:
        return (
            write_message(
                kind,
                f"pandoc: {said}",
                "a document that it can write",
                "try a pandoc of version 3",
            ),
        )
    return tuple(
        write_message(
            write_formula_place(latex, kind), "cannot be read", "whole LaTeX math", "fix it"
        )
        for latex in formulas
    )


def _find_pandoc(kind: str) -> str:
    """The path of pandoc: that of the optional extra, or the one installed on the system."""
    try:
        return str(import_module("pypandoc").get_pandoc_path())
    except (ImportError, OSError) as error:
        raise TypesetError(f"{kind}: {MISSING}") from error
