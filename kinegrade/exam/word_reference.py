"""The document from which Word papers take page, styles and footer: pandoc's, with our parts put
in.

The parts stand in `layouts/word-*.xml`. Texts are put in as XML text, whatever characters they
hold.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib.resources import files
from io import BytesIO
from string import Template
from xml.sax.saxutils import escape
from zipfile import ZipFile, ZipInfo

from kinegrade.exam.document import Paper, PaperSize
from kinegrade.exam.words import words_of

PAGES = {"a4": (11906, 16838), "letter": (12240, 15840)}  # twentieths of a point, as Word counts
MARGINS = 2 * 1134
LATIN = {"en": "en-GB", "zh": "en-US"}
FOOTER = "footer1.xml"
RELATION = (
    f'<Relationship Id="rIdFooter" Target="{FOOTER}" '
    'Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/footer"/>'
)
KIND = (
    f'<Override PartName="/word/{FOOTER}" '
    'ContentType="application/vnd.openxmlformats-officedocument.wordprocessingml.footer+xml"/>'
)


def word_reference(default: bytes, paper: Paper, size: PaperSize) -> bytes:
    """The reference document of a paper, made of pandoc's `default` one."""
    width, height = PAGES[size]
    before, between, after = words_of(paper.language).page.split("{}")
    owner = f"{words_of(paper.language).paper} {paper.code}    {paper.student}"
    parts = {
        "word/styles.xml": layout(
            "word-styles.xml", latin=LATIN[paper.language], measure=str(width - MARGINS)
        ),
        "word/document.xml": layout("word-page.xml", width=str(width), height=str(height)),
        f"word/{FOOTER}": layout(
            "word-footer.xml", owner=owner, before=before, between=between, after=after
        ),
    }
    return _with_parts(default, parts)


def layout(name: str, **texts: str) -> str:
    """A file of `layouts/` with texts in place of its `$name`s, escaped for XML; control characters
    become spaces.
    """
    clean = {
        key: "".join(letter if letter.isprintable() else " " for letter in text)
        for key, text in texts.items()
    }
    template = (files("kinegrade.exam") / "layouts" / name).read_text(encoding="utf-8")
    return Template(template).substitute({key: escape(text) for key, text in clean.items()})


def _with_parts(default: bytes, parts: Mapping[str, str]) -> bytes:
    """A copy of the archive with these parts in place of its own, and the footer registered."""
    target = BytesIO()
    with ZipFile(BytesIO(default)) as source, ZipFile(target, "w") as archive:
        for name in source.namelist():
            if name not in parts:
                archive.writestr(ZipInfo(name), _with_footer(name, source.read(name)))
        for name, text in parts.items():
            archive.writestr(ZipInfo(name), text)
    return target.getvalue()


def _with_footer(name: str, part: bytes) -> bytes:
    match name:
        case "word/_rels/document.xml.rels":
            return part.replace(b"</Relationships>", f"{RELATION}</Relationships>".encode())
        case "[Content_Types].xml":
            return part.replace(b"</Types>", f"{KIND}</Types>".encode())
        case _:
            return part
