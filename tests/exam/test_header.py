"""What a department prints at the head of its papers stands there, in every kind of file; the logo
is kept with the exam, and a logo that is none is refused in one line.
"""

from __future__ import annotations

import re
import shutil
import zlib
from pathlib import Path
from zipfile import ZipFile

import pytest
from pypdf import PdfReader

from kinegrade.press.typst.compiler import make_compiler
from tests.exam.engines import ENGINES
from tests.small_class import generate, kinegrade, write_class, write_short_class

CREST = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 60 30">'
    '<rect width="60" height="30" fill="navy"/><script>alert(1)</script></svg>'
)
HEADER = """
[header]
institution = { en = "Institute of Levers", zh = "杠杆研究所" }
logo = "crest.svg"
duration = { en = "95 minutes", zh = "95 分钟" }
aids = { en = "one sheet of $x$", zh = "一页笔记" }
instructions = { en = "Show **all** working.", zh = "写出全部过程。" }
room = "Hall 7"
seat = true
signature = true
"""
SHOWN = {
    "en": ("InstituteofLevers", "95minutes", "onesheetof", "Showallworking.", "Hall7", "Signature"),
    "zh": ("杠杆研究所", "95分钟", "一页笔记", "写出全部过程。", "Hall7", "座位号"),
}


def write_headed_class(folder: Path, header: str = HEADER) -> Path:
    """A class of one student with a head, a logo beside its bank."""
    write_short_class(folder, header)
    (folder / "roster.csv").write_text("student,name\n007,Ann\n", encoding="utf-8")
    (folder / "crest.svg").write_text(CREST, encoding="utf-8")
    return folder


def squeeze(text: str) -> str:
    """A text without blanks, which files do not keep faithfully."""
    return "".join(text.split())


@pytest.mark.sampled(6, by="language")  # each language, and each engine
@pytest.mark.parametrize(
    ("language", "engine"),
    [
        ("en", "typst"),
        pytest.param("en", "latex", marks=pytest.mark.needs_tex),
        ("zh", "typst"),
        pytest.param("zh", "latex", marks=pytest.mark.needs_tex),
    ],
)
def test_the_head_stands_on_papers_of_every_kind(
    tmp_path: Path, language: str, engine: str
) -> None:
    write_headed_class(tmp_path)
    kinds = ("--also", "docx", "--also", "html", "--engine", engine, "--lang", language)
    result = generate(tmp_path, "EXAM", *kinds)
    assert result.exit_code == 0, result.stderr
    stem = tmp_path / "EXAM" / "papers" / "007"
    page = PdfReader(stem.with_suffix(".pdf")).pages[0]
    with ZipFile(stem.with_suffix(".docx")) as archive:
        word = archive.read("word/document.xml").decode()
        assert sum(name.startswith("word/media/") for name in archive.namelist()) == 2
    web = stem.with_suffix(".html").read_text(encoding="utf-8")
    assert web.count("data:image/svg+xml;base64") == 2
    assert "<script" not in web
    for text in (page.extract_text(), *(re.sub("<[^>]*>", "", each) for each in (word, web))):
        assert [words for words in SHOWN[language] if words not in squeeze(text)] == []


@pytest.mark.sampled(2, by="engine")
@pytest.mark.parametrize("engine", ENGINES)
def test_a_paper_is_printed_again_where_bank_and_logo_are_gone(tmp_path: Path, engine: str) -> None:
    folder = tmp_path / "class"
    folder.mkdir()
    assert generate(write_headed_class(folder), "EXAM", "--engine", engine).exit_code == 0
    exam = Path(shutil.move(folder / "EXAM", tmp_path / "elsewhere"))
    shutil.rmtree(folder)
    again = kinegrade("paper", exam, "007")
    assert again.exit_code == 0, again.stderr
    assert again.stdout_bytes == (exam / "papers" / "007.pdf").read_bytes()


def test_a_bank_without_a_head_prints_none(tmp_path: Path) -> None:
    assert generate(write_class(tmp_path)).exit_code == 0
    text = PdfReader(tmp_path / "EXAM" / "papers" / "007.pdf").pages[0].extract_text()
    assert not re.search("Duration|aids|Seat|Signature", text)
    assert not (tmp_path / "EXAM" / "logo.svg").exists()


def test_logos_of_other_kinds_are_kept_as_one_picture(tmp_path: Path) -> None:
    for kind in ("png", "pdf"):
        folder = tmp_path / kind
        folder.mkdir()
        write_headed_class(folder, f'[header]\nlogo = "crest.{kind}"\n')
        picture = make_compiler().compile(b"#set page(width: 2cm, height: 1cm)\nX", format=kind)
        assert isinstance(picture, bytes)
        (folder / f"crest.{kind}").write_bytes(picture)
        result = generate(folder)
        assert result.exit_code == 0, result.stderr
        assert (folder / "EXAM" / "logo.svg").read_text(encoding="utf-8").startswith("<svg")


def png_of(side: int) -> bytes:
    """The beginning of a PNG that says it has so many pixels a side."""
    head = b"IHDR" + side.to_bytes(4, "big") * 2 + b"\x08\x00\x00\x00\x00"
    return b"\x89PNG\r\n\x1a\n\x00\x00\x00\x0d" + head + zlib.crc32(head).to_bytes(4, "big")


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("crest.png", b"no picture", '"crest.png" - expected a sound PNG that refers to no other'),
        ("crest.png", png_of(100_000), "expected a sound PNG that .* of at most 25 megapixels"),
        ("crest.pdf", b"%PDF-1.7 cut", '"crest.pdf" - expected a sound PDF'),
        ("crest.svg", b"", '"crest.svg" - expected a sound SVG'),
        (
            "crest.svg",
            CREST.replace("<script>", '<image href="/etc/passwd" width="9" height="9"/><script>')
            .encode(),
            '"crest.svg" - expected a sound SVG that refers to no other file',
        ),
        ("crest.svg", b" " * 500_001, '"crest.svg" is larger than 500 kB'),
        ("none.svg", None, r"cannot be read \(No such file"),
        ("../crest.svg", None, '"../crest.svg" - expected a PNG, SVG or PDF file beside the bank'),
        ("crest.gif", b"GIF89a", '"crest.gif" - expected a PNG, SVG or PDF file beside the bank'),
    ],
)  # fmt: skip
def test_a_logo_that_is_none_is_refused_in_one_line(
    tmp_path: Path, name: str, content: bytes | None, said: str
) -> None:
    write_headed_class(tmp_path, f'[header]\nlogo = "{name}"\n')
    if content is not None:
        (tmp_path / name).write_bytes(content)
    result = generate(tmp_path)
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert re.search(rf"bank\.toml:\d+: header\.logo: .*{said}", line), line


def test_a_folder_is_no_logo(tmp_path: Path) -> None:
    write_headed_class(tmp_path, '[header]\nlogo = "crest.png"\n')
    (tmp_path / "crest.png").mkdir()
    (line,) = generate(tmp_path).stderr.splitlines()
    assert 'header.logo: "crest.png" - expected a PNG, SVG or PDF file beside the bank' in line


@pytest.mark.parametrize(
    ("header", "said"),
    [
        ("room = 3", "header.room: 3 - expected true for a line to write on, false, or a text"),
        ("signature = 1", "header.signature: 1 - expected true or false"),
        ('rooms = "A"', "header.rooms: unknown key"),
        ('duration = { en = "95 minutes" }', 'no text in "zh" (header.duration)'),
    ],
)
def test_a_head_at_fault_is_one_line(tmp_path: Path, header: str, said: str) -> None:
    write_headed_class(tmp_path, f"[header]\n{header}\n")
    result = generate(tmp_path, "EXAM", "--lang", "zh")
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert said in line, line


def test_a_translation_beside_the_bank_may_hold_texts_of_the_head(tmp_path: Path) -> None:
    write_headed_class(tmp_path, '[header]\nduration = { en = "95 minutes" }\n')
    (tmp_path / "bank.zh.toml").write_text('[header]\nduration = "95 分钟"\n', encoding="utf-8")
    result = generate(tmp_path, "EXAM", "--lang", "zh")
    assert result.exit_code == 0, result.stderr
    text = PdfReader(tmp_path / "EXAM" / "papers" / "007.pdf").pages[0].extract_text()
    assert "95分钟" in squeeze(text)
