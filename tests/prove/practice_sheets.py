"""A practice sheet in a browser says of what students type what `kinegrade grade` says, template by
template, and is as small as is promised.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path

import kinegrade
from kinegrade.language import ENGLISH
from kinegrade.practice.making import make_practice_sheet
from kinegrade.practice.page import write_page
from tests.browsers.page import BrowserName, open_page
from tests.practice.graded import Pair, mark_answers
from tests.practice.test_reader import list_unlike_made_up
from tests.practice.typed_sheet import judge_in_page
from tests.prove.draws import seeded_template

DRAWS, TEXTS = 12, 2_000
FOUR_OF_TWENTY, FURTHER = 300_000, 2_500  # bytes of four questions of 20 draws; of a further draw
FEWER = 15
BROWSERS: tuple[BrowserName, ...] = ("chromium", "chromium", "chromium", "firefox")
BANK = """title = "Practice"
course = "Mechanics"

[[questions]]
template = "{template}"
"""


def hold(seed: int, folder: Path) -> int:
    """Compare the verdicts on a class's answers to the template of a seed; gives how many."""
    pairs = list_pairs(seed, folder)
    unlike = [pair for pair in pairs if not pair.agrees]
    assert not unlike, " ".join(map(str, unlike))
    return len(pairs)


def hold_texts(seed: int, _: Path) -> int:
    """Read texts as people might type them in the script of the page, and as a file of answers."""
    unlike = list_unlike_made_up(seed, TEXTS)
    assert not unlike, "; ".join(unlike)
    return TEXTS


def hold_size(seed: int, _: Path) -> None:
    """Measure the page of four questions of twenty draws, and what the last few of them add."""
    blueprint = kinegrade.Bank.read("demo").blueprint
    sheet = make_practice_sheet(blueprint, 20, f"prove {seed}", ENGLISH).sheet
    assert [len(question.draws) for question in sheet.questions] == [20] * 4
    whole = len(write_page(sheet, ENGLISH))
    assert whole <= FOUR_OF_TWENTY
    fewer = tuple(replace(each, draws=each.draws[:FEWER]) for each in sheet.questions)
    small = len(write_page(replace(sheet, questions=fewer), ENGLISH))
    assert (whole - small) / (4 * (20 - FEWER)) <= FURTHER


def list_pairs(seed: int, folder: Path) -> list[Pair]:
    """The marks of the answers beside what a browser shows, which says and asks nothing else."""
    bank = folder / f"practice-{seed}.toml"
    bank.write_text(BANK.format(template=seeded_template(seed).name), encoding="utf-8")
    work = folder / f"practice-{seed}"
    work.mkdir(parents=True, exist_ok=True)
    marked = mark_answers(bank, work, DRAWS, seed)
    with open_page(BROWSERS[seed % len(BROWSERS)]) as page:
        pairs = marked.compare(partial(judge_in_page, page, work))
        said = [each for each in page.messages() if "sheet.html" not in each]
    assert not said, " ".join(said)
    return pairs
