"""The worked example of CONTRIBUTING is a sound template, and its side remarks are true."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from kinegrade import template
from kinegrade.problem.template.library.library import find_template_names
from tests.small_class import kinegrade

TEXT = (Path(__file__).parent.parent / "CONTRIBUTING.md").read_text(encoding="utf-8")


@pytest.fixture
def worked_example(tmp_path: Path) -> Path:
    (block,) = re.findall(r"^```toml\n(.*?)^```", TEXT, re.MULTILINE | re.DOTALL)
    path = tmp_path / "scissor-lift.toml"
    path.write_text(block, encoding="utf-8")
    return path


def test_the_worked_example_is_new_and_check_accepts_it(worked_example: Path) -> None:
    assert "scissor-lift" not in find_template_names()
    result = kinegrade("check", worked_example, "--sample", "60")
    assert (result.exit_code, result.stdout.splitlines()[0]) == (0, "scissor-lift: sound")
    assert "published results proved exactly: 25" in result.stdout


def test_the_asks_that_are_suggested_for_it_work(worked_example: Path) -> None:
    suggested = re.findall(r"`((?:x|magnitude|radius)\(\w+\(.*?\)\))`", TEXT)
    assert len(suggested) == 3
    means = 'means = { en = "more", zh = "另一问" }'
    lines = [
        f'more_{index} = {{ quantity = "{quantity}", unit = "{unit}", {means} }}\n'
        for index, (quantity, unit) in enumerate(zip(suggested, ("m", "m/s^2", "m"), strict=True))
    ]
    text = worked_example.read_text(encoding="utf-8").replace(
        "[asks]\n", "[asks]\n" + "".join(lines)
    )
    worked_example.write_text(text, encoding="utf-8")
    answers = template(str(worked_example)).solve(l=2, theta=30, u="1/2")
    assert [answers[f"more_{index}"].exact for index in range(3)] == ["sqrt(3)", "1/2", "2"]
