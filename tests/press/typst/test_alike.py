"""Papers that are filled up when they are first printed are those that are printed once more."""

from __future__ import annotations

import pytest

from kinegrade.press.protocol import Press
from kinegrade.press.sheet import Paper
from kinegrade.press.typst.press import TypstPress
from tests.press.papers import BOUNDS, UNEVEN


@pytest.mark.parametrize(("pages", "longest"), BOUNDS)
def test_papers_filled_up_at_first_are_those_that_are_printed_once_more(
    pages: int | None, longest: int
) -> None:
    press = TypstPress()
    assert press.alike(UNEVEN, pages, longest) == Press.alike(press, UNEVEN, pages, longest)


def test_only_those_before_the_longest_are_printed_once_more(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    printed: list[str] = []
    usual = TypstPress.paper

    def paper(press: TypstPress, sheet: Paper) -> bytes:
        printed.append(sheet.code)
        return usual(press, sheet)

    monkeypatch.setattr(TypstPress, "paper", paper)
    of_one_language = {name: UNEVEN[name] for name in ("early", "long", "late")}
    _, counts = TypstPress().alike(of_one_language, None)
    assert set(counts.values()) == {2}
    assert printed == ["A-0001", "A-0001", "B-0002", "A-0001"]
