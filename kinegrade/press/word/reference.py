"""The document from which Word papers take page, styles and footer: pandoc's, with our parts put
in.

The parts stand in `layouts`. Texts are put in as XML text, whatever characters they
hold.
"""

from __future__ import annotations

from collections.abc import Mapping
from io import BytesIO
from zipfile import ZipFile, ZipInfo

from kinegrade.language.catalogue import PLACE, open_catalogue
from kinegrade.press.filled_layout import fill_layout
from kinegrade.press.sheet import Paper, PaperSize

_PAGES = {"a4": (11906, 16838), "letter": (12240, 15840)}  # twentieths of a point, as Word counts
_MARGINS = 2 * 1134
_FIELDS = {"page": "PAGE", "pages": "NUMPAGES"}  # as Word calls these numbers
_FOOTER = "footer1.xml"
_RELATION = (
    f'<Relationship Id="rIdFooter" Target="{_FOOTER}" '
    'Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/footer"/>'
)
_KIND = (
    f'<Override PartName="/word/{_FOOTER}" '
    'ContentType="application/vnd.openxmlformats-officedocument.wordprocessingml.footer+xml"/>'
)


def make_word_reference(default: bytes, paper: Paper, size: PaperSize) -> bytes:
    """The reference document of a paper, made of pandoc's `default` one."""
    width, height = _PAGES[size]
    words = open_catalogue(paper.language)
    page = words.raw("paper", "layout.")["page"]
    before, first, _, between, second, _, after = PLACE.split(page)
    owner = words.text("paper.owner", code=paper.code)
    parts = {
        "word/styles.xml": fill_layout(
            "word",
            "styles.xml",
            latin=words.text("language.word-latin"),
            measure=str(width - _MARGINS),
        ),
        "word/document.xml": fill_layout("word", "page.xml", width=str(width), height=str(height)),
        f"word/{_FOOTER}": fill_layout(
            "word",
            "footer.xml",
            owner=f"{owner}    {paper.student}",
            before=before,
            first=_FIELDS[first],
            between=between,
            second=_FIELDS[second],
            after=after,
        ),
    }
    return _replace_parts(default, parts)


def _replace_parts(default: bytes, parts: Mapping[str, str]) -> bytes:
    """A copy of the archive with these parts in place of its own, and the footer registered."""
    target = BytesIO()
    with ZipFile(BytesIO(default)) as source, ZipFile(target, "w") as archive:
        for name in source.namelist():
            if name not in parts:
                archive.writestr(ZipInfo(name), _add_footer(name, source.read(name)))
        for name, text in parts.items():
            archive.writestr(ZipInfo(name), text)
    return target.getvalue()


def _add_footer(name: str, part: bytes) -> bytes:
    match name:
        case "word/_rels/document.xml.rels":
            return part.replace(b"</Relationships>", f"{_RELATION}</Relationships>".encode())
        case "[Content_Types].xml":
            return part.replace(b"</Types>", f"{_KIND}</Types>".encode())
        case _:
            return part
