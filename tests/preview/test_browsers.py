"""The preview in a browser: it follows the file, keeps what was typed, and can be used without
seeing or pointing.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from tests.browsers.page import BrowserName, Page, open_page
from tests.preview.test_application import FAULTY, entitle
from tests.preview.visitor import visiting
from tests.problem.crank import crank_text

FIREFOX = pytest.mark.xdist_group("firefox")  # one process starts it
TITLE = "document.querySelector('#problem h2')?.textContent"
VERDICT = "document.querySelector('#problem .verdict').textContent"
DONE = "document.querySelector('#state').textContent === document.querySelector('#state').dataset"


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A template of one's own, which tests change while its preview is open."""
    path = tmp_path_factory.mktemp("preview") / "crank.toml"
    path.write_text(crank_text(), encoding="utf-8")
    return path


@contextmanager
def opening(file: Path, browser: BrowserName) -> Iterator[Page]:
    """The preview of a file in a browser, with all parts shown."""
    with visiting(file) as visitor, open_page(browser) as page:
        try:
            page.open(f"http://127.0.0.1:{visitor.port}/")
            page.wait(f"{DONE}.current")
            yield page
        finally:
            page.open("about:blank")  # else the server waits for a page that waits for news


@pytest.fixture(scope="module", params=["chromium", pytest.param("firefox", marks=FIREFOX)])
def page(request: pytest.FixtureRequest, file: Path) -> Iterator[Page]:
    """Its preview, which goes on from one test to the next."""
    file.write_text(crank_text(), encoding="utf-8")
    with opening(file, request.param) as page:
        yield page


def list_names(node: dict[str, Any]) -> Iterator[tuple[str, str]]:
    """The role and name of each node of an accessibility tree."""
    yield node["role"], node.get("name", "")
    for child in node.get("children", ()):
        yield from list_names(child)


def test_the_page_follows_the_file_and_keeps_what_was_typed(page: Page, file: Path) -> None:
    page.run("document.querySelector('#problem input').focus()")
    page.type("abc")
    page.press("Tab")
    page.wait(f"{VERDICT}.includes('unreadable')")
    entitle(file, "Crank on a wall")
    page.wait(f"{TITLE} === 'Crank on a wall'")
    page.wait(f"{VERDICT}.includes('unreadable')")
    assert page.run("document.querySelector('#problem input').value") == "abc"


def test_faults_stand_over_what_was_sound(page: Page, file: Path) -> None:
    before = page.run(TITLE)
    file.write_text(FAULTY, encoding="utf-8")
    page.wait("document.querySelector('#problem .faults')")
    assert "famly" in page.run("document.querySelector('#problem .faults').textContent")
    assert page.run(TITLE) == before
    file.write_text(crank_text(), encoding="utf-8")
    page.wait(f"!document.querySelector('.faults') && {DONE}.current")


def test_the_mechanism_moves_by_a_key(page: Page) -> None:
    inside = "document.querySelector('#motion').contentDocument"
    page.wait(f"{inside}?.querySelector('input')")
    before = page.run(f"{inside}.querySelector('output').textContent")
    page.run(f"{inside}.querySelector('input').focus()")
    page.press("ArrowRight")
    assert page.run(f"{inside}.querySelector('output').textContent") != before


def test_nothing_is_asked_of_anybody_else_or_said_on_the_console(page: Page) -> None:
    here = f"request: {page.run('location.origin')}"
    assert [said for said in page.messages() if not said.startswith(here)] == []


def test_nothing_stands_in_the_way_of_anybody(tmp_path: Path) -> None:
    file = tmp_path / "crank.toml"
    file.write_text(crank_text(), encoding="utf-8")
    with opening(file, "chromium") as page:
        assert page.faults() == []
        named = set(list_names(page.tree()))
    assert ("heading", "crank.toml") in named
    assert any(role == "textbox" and "v_x" in name for role, name in named), named
    assert [
        (role, name)
        for role, name in named
        if role in ("textbox", "combobox", "button") and not name
    ] == []
