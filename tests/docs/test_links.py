"""Links and pictures of the pages lead somewhere, without the site being built, and CONTRIBUTING
names files that exist.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from docs.generator.pages import PAGES
from docs.generator.shown_sheet import write_shown_sheet
from tests.docs.pages import DOCS, ROOT, list_pages

LINK = re.compile(r"\]\((?P<target>[^)#:\s]+)(?:#[\w-]*)?\)")
TREE = re.compile(r"^```\{toctree\}\n(.*?)^```", re.MULTILINE | re.DOTALL)
FILE = re.compile(r"`(?P<path>[a-z_]+(?:/[\w.]+)*/\w+\.(?:csv|md|po|py|sty|txt|typ))`")
GENERATED = {DOCS / "reference" / f"{name}.md" for name in PAGES}


def targets(page: Path) -> Iterator[Path]:
    text = page.read_text(encoding="utf-8")
    for link in LINK.finditer(text):
        yield (page.parent / link["target"]).resolve()


def children(page: Path) -> Iterator[Path]:
    for tree in TREE.findall(page.read_text(encoding="utf-8")):
        for line in tree.splitlines():
            if line and not line.startswith(":"):
                yield (page.parent / f"{line}.md").resolve()


@pytest.mark.parametrize("page", [pytest.param(page, id=page.stem) for page in list_pages()])
def test_every_link_of_a_page_leads_to_a_file(page: Path) -> None:
    missing = [
        target for target in targets(page) if not target.exists() and target not in GENERATED
    ]
    assert missing == []


def test_every_page_is_reached_from_the_first_one() -> None:
    reached, todo = set(), [DOCS / "index.md", DOCS / "reference" / "index.md"]
    while todo:
        page = todo.pop()
        reached.add(page)
        if page not in GENERATED:
            todo += children(page)
    written = {page for page in list_pages() if page.is_relative_to(DOCS)}
    assert reached == written | GENERATED | {DOCS / "reference" / "index.md"}


def test_the_files_that_contributing_names_exist() -> None:
    named = set(FILE.findall((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")))
    real = {name for name in named if "NAME" not in name}
    assert len(real) > 20
    roots = (ROOT, ROOT / "kinegrade")
    assert {name for name in real if not any((root / name).exists() for root in roots)} == set()


FRAME = re.compile(r'<iframe src="(?P<source>[^"]+)"')


def test_a_frame_of_a_page_shows_the_sheet_that_the_site_takes_in(tmp_path: Path) -> None:
    sources = [
        (page.parent / frame["source"]).resolve()
        for page in list_pages()
        for frame in FRAME.finditer(page.read_text(encoding="utf-8"))
    ]
    sheet = write_shown_sheet(tmp_path / "new")
    assert sources == [DOCS / sheet.name]
    assert sheet.parent == tmp_path / "new"
    assert '<template id="question">' in sheet.read_text(encoding="utf-8")
