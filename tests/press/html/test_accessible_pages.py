"""The pages of reports, feedback, cycles and papers at WCAG 2.2 AA: axe-core in a real browser, and
nothing is lost at a zoom of 400 %, which is a window of 320 pixels.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.browsers.page import Page, open_page
from tests.press.tables import find_table_faults, read_html_tables
from tests.small_class import kinegrade

LANGUAGES = ("en", "de", "zh")
WIDE = "document.documentElement.scrollWidth"
NAMES = ("report", "feedback", "cycle", "paper")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A marked exam with its pages in each language."""
    folder = tmp_path_factory.mktemp("pages")
    (folder / "roster.csv").write_text("student,name\n1001,Ada\n1002,Emilie\n", encoding="utf-8")
    exam = folder / "PAPERS-en"
    for language in LANGUAGES:
        _set_exam(folder, language)
    header, row = (exam / "answers.csv").read_text(encoding="utf-8").splitlines()[:2]
    blanks = row.split(",")
    answers = [header, ",".join([*blanks[:2], *("1.5" for _ in blanks[2:])])]
    (folder / "typed.csv").write_text("\n".join(answers) + "\n", encoding="utf-8")
    marked = kinegrade("grade", exam, folder / "typed.csv", "-o", folder / "MARKS")
    assert marked.exit_code in (0, 1), marked.stderr
    for language in LANGUAGES:
        for done in _write_pages(folder, language):
            assert done == 0
    return folder


def _set_exam(folder: Path, language: str) -> None:
    """The demonstration's papers, of the same numbers in each language."""
    named = ("demo", folder / "roster.csv", "-o", folder / f"PAPERS-{language}")
    wishes = ("--also", "html", "--lang", language, "--reproducible", "pages")
    assert kinegrade("generate", *named, *wishes).exit_code == 0


def _write_pages(folder: Path, language: str) -> Iterator[int]:
    exam, marks = folder / "PAPERS-en", folder / "MARKS"
    report, sheets = folder / f"report-{language}.html", folder / f"feedback-{language}"
    cycle = folder / f"cycle-{language}.html"
    spoken = ("--lang", language)
    yield kinegrade("report", exam, marks, "-o", report, *spoken).exit_code
    yield kinegrade("feedback", exam, marks, "-o", sheets, "--format", "html", *spoken).exit_code
    yield kinegrade("cycle", "slider-crank", "-o", cycle, *spoken).exit_code


def find_page(folder: Path, name: str, language: str) -> Path:
    """A page of that name."""
    match name:
        case "feedback":
            return min((folder / f"feedback-{language}").rglob("*.html"))
        case "paper":
            return min((folder / f"PAPERS-{language}" / "papers").glob("*.html"))
        case _:
            return folder / f"{name}-{language}.html"


@pytest.fixture(
    params=[(name, language) for name in NAMES for language in LANGUAGES],
    ids="-".join,
    scope="module",
)
def page(request: pytest.FixtureRequest, folder: Path) -> Iterator[Page]:
    with open_page() as page:
        page.open(find_page(folder, *request.param).as_uri())
        yield page


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", NAMES)
def test_every_cell_of_a_table_has_a_header(name: str, language: str, folder: Path) -> None:
    tables = read_html_tables(find_page(folder, name, language).read_text(encoding="utf-8"))
    assert list(find_table_faults(tables)) == []
    assert bool(tables) == (name != "cycle")


def test_axe_finds_nothing(page: Page) -> None:
    page.size(1280, 900)
    assert page.faults() == []


def test_a_small_window_needs_no_scrolling_across(page: Page) -> None:
    """Success criterion 1.4.10; tables of data may be scrolled by themselves."""
    page.size(320, 900)
    assert page.run(WIDE) <= 320
    scrolled = (
        "[...document.querySelectorAll('.scrolled')]"
        ".every((each) => each.tabIndex === 0 && each.getAttribute('role') === 'region')"
    )
    assert page.run(scrolled)


def test_what_takes_the_focus_shows_it(page: Page) -> None:
    """Success criterion 2.4.7."""
    hidden = (
        "[...document.querySelectorAll('a[href], button, input, summary, [tabindex]')]"
        ".filter((each) => { each.focus({ focusVisible: true });"
        " const style = getComputedStyle(each);"
        " return document.activeElement === each && style.outlineStyle === 'none'; })"
        ".map((each) => each.outerHTML)"
    )
    assert page.run(hidden) == []
