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


def hold(pairs: list[Pair]) -> None:
    assert [pair for pair in pairs if not pair.agrees] == []
    kinds = {pair.marked.split(" ")[0] for pair in pairs}
    assert {"right", "mistake", "follow-through", "wrong", "unreadable"} <= kinds


@GROUP
def test_verdicts_are_those_of_the_marks(marked: Marked) -> None:
    hold(marked.compare(judge_in_node))


@GROUP
@pytest.mark.parametrize("browser", ["chromium", "firefox"])
def test_a_browser_shows_the_verdicts_of_the_marks(
    marked: Marked, browser: BrowserName, tmp_path: Path
) -> None:
    with open_page(browser) as page:
        hold(marked.compare(partial(judge_in_page, page, tmp_path)))
