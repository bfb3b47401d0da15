"""What a screen reader says of a paper, as the documentation shows it."""

from __future__ import annotations

from pathlib import Path

from kinegrade.exam.printing.sample import print_sample
from kinegrade.problem.template.library.library import load_template
from tests.press.heard import say

PAGE = Path(__file__).parents[3] / "docs" / "explanation" / "accessible-pages.md"


def test_the_documentation_shows_what_is_said_of_a_paper() -> None:
    said = say(print_sample(load_template("slider-crank"), "heard", "en"))
    assert "heading 2: 1 Slider-crank mechanism" in said.splitlines()
    page = PAGE.read_text(encoding="utf-8")
    assert f"```text\n{said}\n```" in page, said
