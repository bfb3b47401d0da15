"""The papers of an exam: in print order, without answers, the same bytes for the same words."""

from __future__ import annotations

import json
from pathlib import Path

import pikepdf
from pypdf import PdfReader

from tests.exam.generate.written_class import FILES
from tests.small_class import (
    STUDENTS,
    asks_of,
    contents,
    generate,
    key_lines,
)


def test_papers_are_pdf_in_print_order_and_do_not_name_the_secret(exam: Path) -> None:
    pages = []
    for name in FILES:
        data = (exam / "papers" / name).read_bytes()
        assert data.startswith(b"%PDF-")
        assert b"spring" not in data
        with pikepdf.open(exam / "papers" / name) as pdf:
            pages.append(len(pdf.pages))
            assert not pdf.attachments
            assert "spring" not in str(dict(pdf.docinfo))
    with pikepdf.open(exam / "papers.pdf") as whole:
        # Each begins on a sheet of its own
        assert len(whole.pages) == sum(count + count % 2 for count in pages)


def test_the_text_of_a_paper_does_not_hold_its_answers(exam: Path) -> None:
    answers = asks_of(exam)
    for student, name in zip(STUDENTS, FILES, strict=True):
        text = "".join(
            "".join(page.extract_text() for page in PdfReader(exam / "papers" / name).pages).split()
        )
        assert student in text
        digits = [
            ask["decimal"].lstrip("-")[:6] for (who, _), ask in answers.items() if who == student
        ]
        telling = [decimal for decimal in digits if len(decimal) == 6]
        assert telling
        assert not [decimal for decimal in telling if decimal in text]


def test_the_same_words_give_the_same_bytes_other_words_other_numbers(
    folder: Path, exam: Path
) -> None:
    assert generate(folder).exit_code == 0
    assert contents(folder / "EXAM") == contents(exam)
    assert generate(folder, "OTHER", "--reproducible", "autumn").exit_code == 0
    ours, others = key_lines(exam), key_lines(folder / "OTHER")
    assert [
        (one, other)
        for one, other in zip(ours, others, strict=True)
        if one["questions"] == other["questions"] or one["paper"] == other["paper"]
    ] == []


def test_chinese_papers_have_the_same_key(folder: Path, exam: Path) -> None:
    assert generate(folder, "EXAM", "--lang", "zh", "--paper-size", "letter").exit_code == 0
    assert (folder / "EXAM" / "key.jsonl").read_bytes() == (exam / "key.jsonl").read_bytes()
    record = json.loads((folder / "EXAM" / "exam.json").read_text(encoding="utf-8"))
    assert (record["title"], record["course"], record["language"]) == ("期中测验", "力学", "zh")
