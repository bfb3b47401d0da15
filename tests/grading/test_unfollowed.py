"""A template that an exam keeps and this version cannot read is told where a class is marked."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.small_class import generate, kinegrade, table, write_class


@pytest.fixture
def exam(tmp_path: Path) -> Path:
    folder = write_class(tmp_path)
    assert generate(folder, "EXAM", "--no-papers").exit_code == 0
    return folder / "EXAM"


def grade(exam: Path) -> tuple[int, str]:
    sheet, marks = exam.with_name("typed.csv"), exam.with_name("MARKS")
    sheet.write_text("student,q1.v_B\n0012,1\n", encoding="utf-8")
    done = kinegrade("grade", exam, sheet, "-o", marks, "--force")
    return done.exit_code, done.stderr


def test_nothing_follows_in_a_question_whose_template_cannot_be_read_and_that_is_told(
    exam: Path,
) -> None:
    (_, before), template = grade(exam), exam / "templates" / "slider-crank.toml"
    said = "a template of the exam cannot be read"
    assert said not in before
    text = template.read_text(encoding="utf-8")
    template.write_text(f"{text}\n[gears]\n", encoding="utf-8")
    code, told = grade(exam)
    assert (code, said in told) == (1, True), told
    assert "what follows from wrong answers is not marked in q1" in told
    rows = table(exam.with_name("MARKS") / "complaints.csv")
    assert [row for row in rows if said in row["problem"]]


def test_axes_of_a_template_of_an_earlier_version_are_read(exam: Path) -> None:
    """Version 0.2.0 said `axes = true`."""
    template = exam / "templates" / "slider-crank.toml"
    text = template.read_text(encoding="utf-8")
    template.write_text(text.replace("[figure]", "[figure]\naxes = true"), encoding="utf-8")
    assert "cannot be read" not in grade(exam)[1]
    printed = kinegrade("paper", exam, "0012", "-o", exam.with_name("paper.pdf"))
    assert printed.exit_code == 0, printed.stderr
