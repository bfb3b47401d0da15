"""A formula sheet is bound behind every paper and kept with the exam; of a PDF nothing is taken but
what is printed, and a file that is none is refused in one line.
"""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import pikepdf
import pytest
from click.testing import Result
from pypdf import PdfReader

from tests.small_class import kinegrade

BANK = """title = "Midterm"
course = "Mechanics"
formula-sheet = "{file}"

[[questions]]
template = "slider-crank"
asks = {{ v_B = 3 }}
"""
TEXT = "**Velocities**\n\n- pole: $v_B = \\omega r$\n- Coriolis: $a_C = 2\\omega v_r$\n"


def make_pdf(pages: int, *, password: str = "") -> bytes:
    """Blank pages with a link and a script on each."""
    made = BytesIO()
    with pikepdf.new() as document:
        for _ in range(pages):
            document.add_blank_page(page_size=(595, 842))
            script = pikepdf.Dictionary(S=pikepdf.Name.JavaScript, JS="app.alert(1)")
            link = pikepdf.Dictionary(
                Type=pikepdf.Name.Annot, Subtype=pikepdf.Name.Link, Rect=[0, 0, 9, 9], A=script
            )
            document.pages[-1].obj.Annots = pikepdf.Array([document.make_indirect(link)])
            document.pages[-1].obj.AA = pikepdf.Dictionary(O=script)
        document.Root.OpenAction = pikepdf.Dictionary(S=pikepdf.Name.JavaScript, JS="app.alert(1)")
        locked = pikepdf.Encryption(owner=password, user=password) if password else False
        document.save(made, encryption=locked)
    return made.getvalue()


def set_exam(folder: Path, name: str, content: bytes, *options: str) -> Result:
    """What `generate` says of a bank with that formula sheet for two students."""
    (folder / name).write_bytes(content)
    (folder / "bank.toml").write_text(BANK.format(file=name), encoding="utf-8")
    roster = "student,name\n1001,Ada Byron\n1002,Sofya Kovalevskaya\n"
    (folder / "roster.csv").write_text(roster, encoding="utf-8")
    files = folder / "bank.toml", folder / "roster.csv"
    return kinegrade("generate", *files, "-o", folder / "EXAM", *options)


def read_pages(path: Path) -> list[str]:
    """The text of each page, without blanks."""
    return ["".join(page.extract_text().split()) for page in PdfReader(path).pages]


@pytest.mark.parametrize(
    ("name", "kept", "pages"),
    [("formulas.md", "formula-sheet.md", 1), ("my formulas.pdf", "formula-sheet.pdf", 3)],
)
def test_every_paper_has_it_printed_again_and_added_late(
    tmp_path: Path, name: str, kept: str, pages: int
) -> None:
    content = TEXT.encode() if name.endswith("md") else make_pdf(pages)
    made = set_exam(tmp_path, name, content)
    assert made.exit_code == 0, made.stderr
    exam = tmp_path / "EXAM"
    assert (exam / kept).is_file()
    (tmp_path / "late.csv").write_text("student,name\n1003,Lise Meitner\n", encoding="utf-8")
    files = tmp_path / "bank.toml", tmp_path / "roster.csv"
    added = kinegrade("generate", *files, "-o", exam, "--add", tmp_path / "late.csv")
    assert added.exit_code == 0, added.stderr
    for student in ("1001", "1002", "1003"):
        paper = exam / "papers" / f"{student}.pdf"
        read = read_pages(paper)
        assert len(read) == 1 + pages
        assert "page1of1" in read[0]
        assert ("Formulasheet" in read[1]) == (name == "formulas.md")
        again = tmp_path / "again.pdf"
        assert kinegrade("paper", exam, student, "-o", again, "--force").exit_code == 0
        assert again.read_bytes() == paper.read_bytes()


def test_nothing_that_readers_do_is_taken_from_a_pdf(tmp_path: Path) -> None:
    assert set_exam(tmp_path, "formulas.pdf", make_pdf(2)).exit_code == 0
    for path in ("formula-sheet.pdf", "papers/1001.pdf"):
        content = (tmp_path / "EXAM" / path).read_bytes()
        assert b"JavaScript" not in content
        with pikepdf.open(BytesIO(content)) as document:
            assert [
                page for page in document.pages if "/Annots" in page.obj or "/AA" in page.obj
            ] == []


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("formulas.pdf", b""),
        ("formulas.pdf", b"%PDF-1.7\n" + bytes(range(256)) * 40),
        ("formulas.pdf", make_pdf(11)),
        ("formulas.pdf", make_pdf(1, password="secret")),
    ],
    ids=["empty", "garbage", "long", "locked"],
)
def test_what_is_no_sound_pdf_is_refused(tmp_path: Path, name: str, content: bytes) -> None:
    made = set_exam(tmp_path, name, content)
    assert (made.exit_code, made.stderr.count("\n")) == (2, 1)
    assert made.stderr.endswith(
        f'bank.toml:3: formula-sheet: "{name}" - expected a sound PDF of 1 to 10 pages '
        "without a password\n"
    )


@pytest.mark.parametrize(
    ("name", "content", "fault"),
    [
        ("formulas.md", b"\xff\xfe\x00", "expected a text in UTF-8 that is not empty"),
        ("formulas.txt", b" \n", "expected a text in UTF-8 that is not empty"),
        ("formulas.docx", b"", "the name of a PDF, md or txt file beside the bank"),
        ("formulas.md", b"x" * 5_000_001, '"formulas.md" is larger than 5000 kB'),
        ("formulas.md", b"$\\frac{1$", "the formula sheet: "),
    ],
    ids=["not UTF-8", "blank", "another kind", "large", "no formula"],
)
def test_what_is_no_text_is_refused(tmp_path: Path, name: str, content: bytes, fault: str) -> None:
    made = set_exam(tmp_path, name, content)
    assert (made.exit_code, made.stderr.count("error: ")) == (2, 1)
    assert fault in made.stderr
    assert not (tmp_path / "EXAM").exists()


def test_a_damaged_copy_is_refused(tmp_path: Path) -> None:
    assert set_exam(tmp_path, "formulas.pdf", make_pdf(1)).exit_code == 0
    (tmp_path / "EXAM" / "formula-sheet.pdf").write_bytes(b"%PDF-1.7")
    again = kinegrade("paper", tmp_path / "EXAM", "1001", "-o", tmp_path / "again.pdf")
    assert again.exit_code == 2
    assert "expected a sound PDF of 1 to 10 pages" in again.stderr


def test_another_sheet_is_another_bank(tmp_path: Path) -> None:
    assert set_exam(tmp_path, "formulas.md", TEXT.encode()).exit_code == 0
    (tmp_path / "formulas.md").write_text("another", encoding="utf-8")
    (tmp_path / "late.csv").write_text("student,name\n1003,Lise Meitner\n", encoding="utf-8")
    files = tmp_path / "bank.toml", tmp_path / "roster.csv"
    late = tmp_path / "late.csv"
    refused = kinegrade("generate", *files, "-o", tmp_path / "EXAM", "--add", late)
    assert refused.exit_code == 2
    assert "formula-sheet.md" in refused.stderr


def test_papers_for_word_go_without_which_is_said(tmp_path: Path) -> None:
    made = set_exam(tmp_path, "formulas.md", TEXT.encode(), "--also", "docx")
    assert made.exit_code == 1
    assert made.stderr.splitlines()[-1] == (
        "complaint: docx: these papers have no formula sheet behind them - hand it out beside them"
    )
