"""The page says of an answer what `kinegrade grade` says."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import pytest

from tests.browsers.page import BrowserName, open_page
from tests.practice.graded import Marked, Pair, mark_answers
from tests.practice.node import judge_in_node
from tests.practice.typed_sheet import judge_in_page

BANKS = Path(__file__).parent.parent.parent / "banks"
GROUP = pytest.mark.xdist_group("firefox")  # one process starts it, and marks these answers


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> Marked:
    return mark_answers(BANKS / "demo.toml", tmp_path_factory.mktemp("marked"), draws=8, seed=1)


KINDS = {"right", "mistake", "follow-through", "wrong", "unreadable"}


def find_kinds(pairs: list[Pair]) -> set[str]:
    """The kinds of verdicts that are compared."""
    return {pair.marked.split(" ")[0] for pair in pairs}


@GROUP
def test_verdicts_are_those_of_the_marks(marked: Marked) -> None:
    pairs = marked.compare(judge_in_node)
    assert [pair for pair in pairs if not pair.agrees] == []
    assert find_kinds(pairs) >= KINDS


@GROUP
@pytest.mark.parametrize("browser", ["chromium", "firefox"])
def test_a_browser_shows_the_verdicts_of_the_marks(
    marked: Marked, browser: BrowserName, tmp_path: Path
) -> None:
    with open_page(browser) as page:
        pairs = marked.compare(partial(judge_in_page, page, tmp_path))
    assert [pair for pair in pairs if not pair.agrees] == []
    assert find_kinds(pairs) >= KINDS
