"""Types answers into a practice sheet in a browser, and reads there what is said of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from kinegrade.language import ENGLISH
from kinegrade.practice.document import PracticeSheet
from kinegrade.practice.page import write_page
from kinegrade.practice.wording import collect_wording
from tests.browsers.page import Page
from tests.practice.node import Shown, Typed


def open_sheet(page: Page, file: Path) -> None:
    """Opens a sheet, and waits for its questions."""
    page.open(file.as_uri())
    page.wait("document.querySelector('main section')")


def judge_in_page(
    page: Page, folder: Path, sheet: PracticeSheet, typed: Typed
) -> list[list[list[Shown]]]:
    """The verdicts that the page shows on what was typed into it, in the same order; mistakes are
    told by their sentences.
    """
    file = folder / "sheet.html"
    file.write_text(write_page(sheet, ENGLISH), encoding="utf-8")
    open_sheet(page, file)
    return [
        [_answer(page, place, draw, sheet.mistakes) for draw in draws]
        for place, draws in enumerate(typed)
    ]


def _answer(
    page: Page, place: int, typed: Sequence[str], mistakes: Mapping[str, str]
) -> list[Shown]:
    """Types the answers to the draw that is shown, reads the verdicts, and asks for another."""
    section = f"document.querySelectorAll('main section')[{place}]"
    page.run(f"{section}.querySelector('input[type=text]').focus()")
    for number, text in enumerate(typed):
        if number:
            page.press("Tab")
        page.type(text)
    page.press("Enter")
    earned, verdicts = page.run(
        f"(() => {{ const box = {section};"
        " const said = [...box.querySelectorAll('.verdict')]"
        ".map((each) => [each.dataset.kind, each.textContent]);"
        " const earned = box.querySelector('.earned').textContent;"
        " box.querySelector('.another').click(); return [earned, said]; })()"
    )
    is_cut_off = collect_wording(ENGLISH).texts["no-following"] in earned
    return [Shown(kind, _name_mistakes(text, mistakes), is_cut_off) for kind, text in verdicts]


def _name_mistakes(text: str, mistakes: Mapping[str, str]) -> tuple[str, ...]:
    """The mistakes whose sentences stand in a text, in its order."""
    told = [name for name, sentence in mistakes.items() if sentence in text]
    return tuple(sorted(told, key=lambda name: text.index(mistakes[name])))
