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

import typst

from kinegrade.errors import TypesetError, did_you_mean, message
from kinegrade.exam.document import Paper, PaperSize
from kinegrade.exam.fonts import installed_fonts
from kinegrade.exam.formula import formula_place
from kinegrade.exam.paper_tree import paper_tree
from kinegrade.exam.program_run import run_program
from kinegrade.exam.word_reference import layout, word_reference
from kinegrade.exam.words import words_of
from kinegrade.figure.scene import Scene
from kinegrade.figure.typst import to_typst
from kinegrade.language import Language
from kinegrade.temporary import temporary_folder

Kind = Literal["docx", "html"]
KINDS: tuple[Kind, ...] = get_args(Kind)
Picture = Literal["png", "svg"]
MEDIA_TYPES: Mapping[Picture, str] = {"png": "image/png", "svg": "image/svg+xml"}
MISSING = "pandoc not found - expected the optional extra - pip install 'kinegrade[word]'"
PIXELS = 300  # to the inch, of a figure in Word
SECONDS = 60  # a paper takes a fraction of one
TAGS: Mapping[Language, str] = {"en": "en", "zh": "zh-CN"}
CSS_SIZES = {"a4": "A4", "letter": "letter"}
_UNREAD = re.compile(r"Could not convert TeX math (.*?), rendering as TeX")


class PandocPress:
    """Writes papers as Word or HTML; keep one for many papers, and one for each thread or
    process.
    """

    def __init__(self, paper_size: PaperSize = "a4") -> None:
        self._size: PaperSize = paper_size
        layouts = str(files("kinegrade.exam") / "layouts")
        self._compiler = typst.Compiler(
            root=layouts, font_paths=installed_fonts(), ignore_system_fonts=True
        )

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
                    message(
                        kind,
                        "not a kind of file that papers are written in",
                        do=did_you_mean(kind, KINDS),
                    )
                )

    def docx(self, paper: Paper) -> bytes:
        """The paper for Word. Raises TypesetError with all faults of its texts, and where there is
        no pandoc.
        """
        reference = word_reference(self._default_reference, paper, self._size)
        tree = paper_tree(paper, self._figures(paper, "png"))
        with temporary_folder() as folder:
            file = folder / "reference.docx"
            file.write_bytes(reference)
            return _pandoc("docx", ["--reference-doc", str(file)], tree)

    def html(self, paper: Paper) -> bytes:
        """The paper as one HTML file, in UTF-8. Raises TypesetError as `docx` does."""
        body = _pandoc(
            "html", ["--mathml"], paper_tree(paper, self._figures(paper, "svg"))
        ).decode()
        page = Template(
            (files("kinegrade.exam") / "layouts" / "paper.html").read_text(encoding="utf-8")
        )
        owner = f"{words_of(paper.language).paper} {paper.code} · {paper.student}"
        style = layout("paper.css", size=CSS_SIZES[self._size])
        return page.substitute(
            language=TAGS[paper.language],
            title=escape(f"{paper.title} {paper.code}"),
            style=style,
            body=body,
            footer=escape(owner),
        ).encode()

    @cached_property
    def _default_reference(self) -> bytes:
        return _run("docx", ["--print-default-data-file", "reference.docx"], b"")

    def _figures(self, paper: Paper, kind: Picture) -> dict[int, str]:
        """The figure of each question as a data URI."""
        return {
            question.number: self._picture(question.figure, kind)
            for question in paper.questions
            if question.figure
        }

    def _picture(self, scene: Scene, kind: Picture) -> str:
        source = f'#import "/figure.typ": figure-alone\n#show: figure-alone\n{to_typst(scene)}\n'
        image = self._compiler.compile(source.encode(), format=kind, ppi=PIXELS)
        data = b64encode(image if isinstance(image, bytes) else b"").decode()
        return f"data:{MEDIA_TYPES[kind]};base64,{data}"


def require_pandoc(kinds: Iterable[str]) -> None:
    """Raises TypesetError where there is no pandoc to write these kinds of files."""
    wanted = ", ".join(kinds)
    if which(_pandoc_path(wanted)) is None:
        raise TypesetError(f"{wanted}: {MISSING}")


def _pandoc(kind: Kind, options: Sequence[str], tree: bytes) -> bytes:
    """What pandoc makes of a document."""
    form = ["--from", "json", "--to", kind, "--wrap", "none", "--fail-if-warnings", "--output", "-"]
    return _run(kind, [*form, *options], tree)


def _run(kind: Kind, options: Sequence[str], given: bytes) -> bytes:
    """The output of pandoc. Raises TypesetError if there is no pandoc, and with its message if it
    fails or warns.
    """
    command = [_pandoc_path(kind), "--sandbox", *options]
    try:
        result = run_program(command, SECONDS, given=given)
    except TimeoutError as error:
        raise TypesetError(
            message(
                kind, f"pandoc has not ended after {SECONDS} s", "a fraction of one", "try again"
            )
        ) from error
    except OSError as error:
        raise TypesetError(f"{kind}: {MISSING}") from error
    if result.status:
        raise TypesetError(*_explained(result.complaint.decode(errors="replace"), kind))
    return result.output


def _explained(complaint: str, kind: Kind) -> tuple[str, ...]:
    """What pandoc complains about, usually formulas."""
    said = " ".join(complaint.split())
    formulas = tuple(dict.fromkeys(_UNREAD.findall(said)))
    if not formulas:
        return (
            message(
                kind,
                f"pandoc: {said}",
                "a document that it can write",
                "try a pandoc of version 3",
            ),
        )
    return tuple(
        message(formula_place(latex, kind), "cannot be read", "whole LaTeX math", "fix it")
        for latex in formulas
    )


def _pandoc_path(kind: str) -> str:
    """The path of pandoc: that of the optional extra, or the one installed on the system."""
    try:
        return str(import_module("pypandoc").get_pandoc_path())
    except (ImportError, OSError) as error:
        raise TypesetError(f"{kind}: {MISSING}") from error
