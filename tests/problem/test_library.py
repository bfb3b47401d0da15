"""Templates are found by name among the shipped ones, and by path anywhere; what cannot be read
says why.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.errors import TemplateError
from kinegrade.problem.template.library.library import (
    find_shipped,
    find_template_names,
    load_template,
)
from kinegrade.problem.template.sections.keys import MAX_CHARACTERS
from tests.problem.crank import crank_text


def refusal(name: str | Path, folder: Path | None = None) -> str:
    with pytest.raises(TemplateError) as caught:
        load_template(str(name), folder)
    (problem,) = caught.value.problems
    return problem


def test_the_shipped_templates_are_found_by_name() -> None:
    assert {"slider-crank", "bar-through-swivelling-sleeve"} <= set(find_template_names())
    assert [name for name in find_template_names() if load_template(name).name != name] == []
    text = (find_shipped("templates") / "slider-crank.toml").read_text(encoding="utf-8")
    assert load_template("slider-crank").file.text == text


def test_any_file_is_found_by_its_path_and_any_folder_may_serve(tmp_path: Path) -> None:
    (tmp_path / "crank.toml").write_text(crank_text(), encoding="utf-8-sig")
    assert load_template(str(tmp_path / "crank.toml")) == load_template("crank", tmp_path)
    assert refusal("slider-crank", tmp_path) == 'no template "slider-crank": known here: crank'


@pytest.mark.parametrize(
    "name", ["slider", "Slider-Crank", "../templates/slider-crank", "slider-crank/"]
)
def test_an_unknown_name_is_refused_with_the_nearest_ones(name: str) -> None:
    assert refusal(name).startswith(f'no template "{name}": did you mean ')
    assert "slider-crank" in refusal(name)
    assert refusal(name).count('"') <= 2 + 2 * 3


def test_a_name_like_no_other_lists_three_of_all() -> None:
    message = refusal("")
    assert message.endswith(f" and {len(find_template_names()) - 3} more")
    assert sum(name in message for name in find_template_names()) == 3


def test_a_file_that_cannot_be_read_says_why(tmp_path: Path) -> None:
    file = tmp_path / "crank.toml"
    missing = "cannot be read (No such file or directory) - expected a template - check the name"
    assert refusal(file) == f"{file}: {missing}"
    file.write_bytes(b"title = '\xff'")
    assert refusal(file) == f"{file}: not UTF-8 at byte 9 - expected a template in UTF-8 - fix it"
    file.write_text("曲" * (2 * MAX_CHARACTERS), encoding="utf-8")
    assert refusal(file).startswith(f"{file}: too large - expected a template of at most ")
