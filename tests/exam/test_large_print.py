"""Papers, worked solutions and feedback in large print, by a column of the roster or one by one;
through the command line.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from pypdf import PdfReader

from kinegrade.press.binding.part import count_pages
from kinegrade.press.latex.press import LatexPress
from tests.press.accessible import list_failed_rules
from tests.press.papers import ENGLISH
from tests.press.solutions import ENGLISH_SOLUTION
from tests.small_class import generate, key_lines, kinegrade, write_class
from tests.spellings import type_answers

ROSTER = """student,name,format
007,Ann Lee,
0012,Ben Ho,large print
0013,Cy Ow,standard
"""
POINTS = 18.0
# Of the font that text is set in; indices are in the font of formulas
TEXT = "LibertinusSerif"
# Letters of formulas and figures: those of text and headings, their indices, and indices of indices
FORMULA = "Math"
FORMULA_SIZES = {round(size * part, 2) for size in (18, 20, 24) for part in (1, 0.7, 0.5)}


def list_letters(pdf: Path, face: str = TEXT) -> Iterator[tuple[str, float]]:
    """Each piece of text in a font with the size of its letters as printed, in points."""
    found: list[tuple[str, float]] = []

    def note(text: str, cm: list[float], tm: list[float], font: dict | None, size: float) -> None:
        if text.strip() and font and face in font["/BaseFont"]:
            found.append((text.strip(), size * abs(tm[3] * cm[3])))

    for page in PdfReader(pdf).pages:
        page.extract_text(visitor_text=note)
    return iter(found)


def find_small(pdf: Path) -> list[tuple[str, float]]:
    """Those that are smaller than large print."""
    return [(text, size) for text, size in list_letters(pdf) if size < POINTS - 0.01]


@pytest.fixture(scope="module")
def exam(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An exam of the small class in which one student has large print."""
    folder = write_class(tmp_path_factory.mktemp("large"))
    (folder / "roster.csv").write_text(ROSTER, encoding="utf-8")
    result = generate(folder, "EXAM", "--solutions")
    assert result.exit_code == 0, result.stderr
    return folder / "EXAM"


def test_no_letter_is_smaller_than_18_points_and_each_question_has_its_own_pages(
    exam: Path,
) -> None:
    large = exam / "papers" / "0012.pdf"
    assert find_small(large) == []
    assert find_small(exam / "papers" / "007.pdf") != []
    (line,) = (each for each in key_lines(exam) if each["student"] == "0012")
    pages = [page.extract_text() for page in PdfReader(large).pages]
    working = [place for place, text in enumerate(pages) if "Space for working" in text]
    assert len(working) == len(line["questions"])
    assert working[-1] == len(pages) - 1


def test_large_print_can_be_heard(exam: Path) -> None:
    assert list_failed_rules((exam / "papers" / "0012.pdf").read_bytes()) == []


def test_usual_papers_are_as_long_as_without_large_print(exam: Path, tmp_path: Path) -> None:
    usual = [(exam / "papers" / f"{each}.pdf").read_bytes() for each in ("007", "0013")]
    plain = write_class(tmp_path)
    assert generate(plain, "EXAM").exit_code == 0
    expected = count_pages((plain / "EXAM" / "papers" / "007.pdf").read_bytes())
    assert [count_pages(pdf) for pdf in usual] == [expected, expected]
    assert count_pages((exam / "papers" / "0012.pdf").read_bytes()) > expected


def test_it_is_printed_again_as_it_was_and_for_anybody_on_demand(
    exam: Path, tmp_path: Path
) -> None:
    again = kinegrade("paper", exam, "0012")
    assert again.stdout_bytes == (exam / "papers" / "0012.pdf").read_bytes()
    target = tmp_path / "large.pdf"
    assert kinegrade("paper", exam, "007", "--large-print", "-o", target).exit_code == 0
    assert find_small(target) == []


def test_worked_solutions_are_large_for_who_needs_it_and_for_anybody_on_demand(
    exam: Path, tmp_path: Path
) -> None:
    large = exam / "solutions" / "0012.pdf"
    assert find_small(large) == []
    assert list_failed_rules(large.read_bytes()) == []
    assert find_small(exam / "solutions" / "007.pdf") != []
    again = kinegrade("paper", exam, "0012", "--solution")
    assert again.stdout_bytes == large.read_bytes()
    target = tmp_path / "large.pdf"
    printed = kinegrade("paper", exam, "007", "--large-print", "--solution", "-o", target)
    assert printed.exit_code == 0, printed.stderr
    assert find_small(target) == []


@pytest.mark.left(
    beside="test_worked_solutions_are_large_for_who_needs_it_and_for_anybody_on_demand"
)
def test_feedback_is_large_for_who_needs_it(exam: Path, tmp_path: Path) -> None:
    answers, marks, sheets = tmp_path / "answers.csv", tmp_path / "MARKS", tmp_path / "SHEETS"
    type_answers(exam, answers, lambda student, name: "1.5" if student == "0012" else "")
    assert kinegrade("grade", exam, answers, "-o", marks).exit_code < 2
    made = kinegrade("feedback", exam, marks, "--solutions", "-o", sheets)
    assert made.exit_code == 0, made.stderr
    large = sheets / "sheets" / "0012.pdf"
    assert find_small(large) == []
    assert list_failed_rules(large.read_bytes()) == []
    text = "".join(page.extract_text() for page in PdfReader(large).pages)
    for said in ("Feedback", "Your answer", "Right answer", "Verdict", "Worked solutions"):
        assert said in text
    assert find_small(sheets / "sheets" / "007.pdf") != []


@pytest.mark.parametrize("language", ["en", "de", "zh"])
def test_a_template_is_solved_in_large_print(language: str, tmp_path: Path) -> None:
    target = tmp_path / "solution.pdf"
    made = kinegrade("solve", "slider-crank", "--large-print", "--lang", language, "-o", target)
    assert made.exit_code == 0, made.stderr
    assert find_small(target) == []
    assert list_failed_rules(target.read_bytes()) == []


@pytest.mark.sampled(2, by="name")
@pytest.mark.parametrize(
    ("name", "language"),
    [("pin-in-two-rings", "zh"), ("planetary-gear-external-rim-velocities", "de")],
)
def test_no_formula_or_figure_is_made_smaller(name: str, language: str, tmp_path: Path) -> None:
    target = tmp_path / "solution.pdf"
    made = kinegrade("solve", name, "--large-print", "--lang", language, "-o", target)
    assert made.exit_code == 0, made.stderr
    sizes = {round(size, 2) for _, size in list_letters(target, FORMULA)}
    assert sizes
    assert sizes <= FORMULA_SIZES


def test_figures_on_large_papers_have_large_letters(exam: Path) -> None:
    letters = list_letters(exam / "papers" / "0012.pdf", FORMULA)
    sizes = {round(size, 2) for _, size in letters}
    assert sizes
    assert sizes <= FORMULA_SIZES


def test_late_students_have_it_too(exam: Path, tmp_path: Path) -> None:
    grown, late = tmp_path / "EXAM", tmp_path / "late.csv"
    shutil.copytree(exam, grown)
    late.write_text("student,name,format\n0014,Di Po,18 pt\n", encoding="utf-8")
    files = exam.parent / "bank.toml", exam.parent / "roster.csv"
    result = kinegrade("generate", *files, "-o", grown, "--add", late, "--allow-odd-ids")
    assert result.exit_code < 2, result.stderr
    assert find_small(grown / "papers" / "0014.pdf") == []


def test_latex_leaves_it_to_the_press_that_has_a_layout_of_it() -> None:
    press = LatexPress()
    paper = press.papers({"a": replace(ENGLISH, large=True)})["a"]
    solution = press.solutions({"a": replace(ENGLISH_SOLUTION, large=True)})["a"]
    for large in (paper, solution):
        assert large.pdf.startswith(b"%PDF")
        assert large.sources == {}


def test_what_the_column_says_is_told_or_must_be_known(tmp_path: Path) -> None:
    roster = tmp_path / "roster.csv"
    roster.write_text("id,name,Druckformat\n1,Ann,Großdruck\n2,Ben,大字\n3,Cy,nein\n", "utf-8")
    assert "format: large-print (2)" in kinegrade("roster", roster).stdout
    roster.write_text("id,name,format\n1,Ann,Sepia\n", encoding="utf-8")
    (line,) = kinegrade("roster", roster).stderr.splitlines()
    assert line == (
        'error: roster.csv:2: the format "Sepia" is not known - expected large print, tactile, or '
        "nothing - correct it, or do without the column: --column format="
    )
