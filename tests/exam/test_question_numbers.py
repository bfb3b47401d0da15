"""People know a question by the number printed on their paper; the names q1, q2 of files stand on
no page.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from kinegrade.language import Language
from kinegrade.question_numbers import find_bank_number, find_other_number
from tests.printed_text import read_pages
from tests.small_class import asks_of, generate, key_lines, kinegrade, table, write_class

INTERNAL = re.compile(r"(?<![A-Za-z0-9])q[0-9]")
ELSEWHERE = {"en": "(no.{}intheanswersheet)", "zh": "登分表第{}题"}


def words(file: Path) -> str:
    """The text of a page or a PDF without blanks."""
    if file.suffix == ".pdf":
        text = "".join(read_pages(file))
    else:
        text = re.sub(
            r"<style.*?</style>|<[^>]*>", "", file.read_text(encoding="utf-8"), flags=re.S
        )
    return text


def squeezed(file: Path) -> str:
    return "".join(words(file).split())


def shuffled_class(folder: Path, *options: str) -> Path:
    """An exam of two students whose papers have their own orders."""
    write_class(folder)
    bank = (folder / "bank.toml").read_text(encoding="utf-8")
    (folder / "bank.toml").write_text(f"shuffle = true\n{bank}", encoding="utf-8")
    (folder / "roster.csv").write_text("student,name\n007,Ann\n0012,Bob\n", encoding="utf-8")
    result = generate(folder, "EXAM", *options)
    assert result.exit_code == 0, result.stderr
    return folder / "EXAM"


def mark(exam: Path) -> None:
    """Mark the class; every other answer is wrong."""
    folder, asks = exam.parent, asks_of(exam)
    columns = list(dict.fromkeys(column for _, column in asks))
    rows = [
        [line["student"], *(f"{asks[line['student'], column]['value'] + place % 2:.6g}"
                            for place, column in enumerate(columns))]
        for line in key_lines(exam)
    ]  # fmt: skip
    table = [["student", *columns], *rows]
    (folder / "typed.csv").write_text("\n".join(map(",".join, table)), encoding="utf-8")
    assert kinegrade("grade", exam, folder / "typed.csv", "-o", folder / "MARKS").exit_code == 0


def hand_back(exam: Path, language: Language) -> Iterator[Path]:
    """The feedback of the class that was marked in all formats, and its report."""
    folder = exam.parent
    for form in ("pdf", "html", "md"):
        target = folder / f"FEEDBACK-{form}"
        result = kinegrade(
            *("feedback", exam, folder / "MARKS", "-o", target, "--format", form),
            *("--lang", language),
        )
        assert result.exit_code == 0, result.stderr
        yield from (target / "sheets").iterdir()
    report = folder / "report.html"
    arguments = ("report", exam, folder / "MARKS", "-o", report, "--lang", language)
    assert kinegrade(*arguments).exit_code == 0
    yield report


def require_numbers(exam: Path, language: Language) -> None:
    """Papers say where the number of a question in the answer sheet is another."""
    for line in key_lines(exam):
        text = squeezed(exam / "papers" / f"{line['student']}.pdf")
        printed = line["printed"]
        for number, name in enumerate(printed, start=1):
            told = ELSEWHERE[language].format(name[1:]) in text
            assert told == (name != f"q{number}")
    assert len({tuple(line["printed"]) for line in key_lines(exam)}) == 2


@pytest.mark.sampled(2, by="language")
@pytest.mark.parametrize("language", ["en", "zh"])
def test_no_page_names_a_question_by_the_name_of_its_column(
    language: Language, tmp_path: Path
) -> None:
    exam = shuffled_class(tmp_path, "--lang", language, "--solutions")
    require_numbers(exam, language)
    mark(exam)
    pages = [*exam.rglob("*.pdf"), *hand_back(exam, language)]
    assert len(pages) >= 12
    assert [file.name for file in pages if INTERNAL.search(words(file))] == []
    assert {"en": "Question3", "zh": "第3题"}[language] in squeezed(tmp_path / "report.html")


@pytest.mark.left(beside="test_no_page_names_a_question_by_the_name_of_its_column")
@pytest.mark.needs_tex
def test_no_page_that_latex_sets_does_either(tmp_path: Path) -> None:
    exam = shuffled_class(tmp_path, "--engine", "latex", "--solutions")
    require_numbers(exam, "en")
    assert [file.name for file in exam.rglob("*.pdf") if INTERNAL.search(words(file))] == []


def test_a_number_is_told_apart_only_where_it_is_another() -> None:
    assert (find_bank_number("q12"), find_bank_number("bonus"), find_bank_number("q")) == (
        "12",
        "bonus",
        "q",
    )
    assert (find_other_number("q12", 12), find_other_number("q12", 1)) == (None, "12")


def test_a_student_reads_the_numbers_of_the_own_paper_in_the_grade_file(tmp_path: Path) -> None:
    """With "q1: 0/5" beside the grade, students of shuffled papers complained about another
    question.
    """
    exam = shuffled_class(tmp_path, "--no-papers")
    mark(exam)
    marks = tmp_path / "MARKS"
    again = tmp_path / "again.csv"
    assert kinegrade("export", marks, "--to", "moodle", "-o", again).exit_code == 0
    grades = {row["student"]: row for row in table(marks / "grades.csv")}
    worth = {"q1": "5.5", "q2": "3", "q3": "7"}
    for file in (marks / "moodle.csv", again):
        told = {row["ID number"]: row["Feedback"] for row in table(file)}
        for line in key_lines(exam):
            student = line["student"]
            assert told[student] == "; ".join(
                f"{number}: {grades[student][name]}/{worth[name]}"
                for number, name in enumerate(line["printed"], start=1)
            )


def test_a_damaged_order_of_questions_is_one_line(tmp_path: Path) -> None:
    exam = shuffled_class(tmp_path, "--no-papers")
    mark(exam)
    marks = tmp_path / "MARKS"
    (marks / "printed.csv").write_text("student,questions\n007,q1 q2 q9\n", encoding="utf-8")
    refused = kinegrade("export", marks, "--to", "moodle", "-o", tmp_path / "again.csv")
    assert refused.exit_code == 2
    assert refused.stderr.strip() == (
        f'error: {marks}/printed.csv:2: questions is "q1 q2 q9" - expected the questions of '
        "grades.csv in the order of the paper - grade again"
    )
    key = exam / "key.jsonl"
    key.write_text(key.read_text(encoding="utf-8").replace('"printed": ["q', '"printed": ["r'))
    refused = kinegrade("grade", exam, tmp_path / "typed.csv", "-o", tmp_path / "MARKS2")
    assert refused.exit_code == 2
    assert refused.stderr.strip() == (
        f'error: {key}: line 1: "printed" is not an order of the questions - expected it as '
        "kinegrade generate wrote it - restore the exam folder as it was generated"
    )
