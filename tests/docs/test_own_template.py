"""The worked example of the tutorial is a new template, and what the page suggests for it works."""

from __future__ import annotations

import re
from pathlib import Path

from kinegrade import template
from kinegrade.problem.template.library.library import find_template_names
from tests.docs.pages import DOCS, File, read_steps

PAGE = DOCS / "tutorial" / "own-template.md"


def worked_example() -> str:
    (text,) = (
        step.text
        for step in read_steps(PAGE)
        if isinstance(step, File) and step.name == "lifting-table.toml"
    )
    return text


def test_the_worked_example_is_new_and_its_parts_stand_on_the_page_alone() -> None:
    assert "lifting-table" not in find_template_names()
    parts = re.findall(r"^```toml\n(.*?)^```", PAGE.read_text("utf-8"), re.MULTILINE | re.DOTALL)
    assert len(parts) == 2
    assert [part for part in parts if part not in worked_example()] == []


def test_the_asks_that_are_suggested_for_it_work(tmp_path: Path) -> None:
    suggested = re.findall(
        r"`((?:x|magnitude|radius)\(\w+\(.*?\)\))`", PAGE.read_text(encoding="utf-8")
    )
    assert len(suggested) == 3
    lines = [
        f'more_{index} = {{ quantity = "{quantity}", unit = "{unit}", means = "more {index}" }}\n'
        for index, (quantity, unit) in enumerate(zip(suggested, ("m", "m/s^2", "m"), strict=True))
    ]
    path = tmp_path / "lifting-table.toml"
    text = worked_example().replace("[asks]\n", "[asks]\n" + "".join(lines))
    path.write_text(text, encoding="utf-8")
    answers = template(str(path)).solve(l=2, theta=30, u="1/2")
    assert [answers[f"more_{index}"].exact for index in range(3)] == ["sqrt(3)", "1/2", "2"]
