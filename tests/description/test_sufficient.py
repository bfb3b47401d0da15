"""A description suffices: whoever has it alone finds the key."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from tests.description.questions import list_differences, write_question
from tests.description.reader import solve
from tests.description.reader.positions import NotPlaced
from tests.description.reader.sentences import NotUnderstood

READER = Path(__file__).parent / "reader"


@pytest.mark.sampled(8, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_the_key_is_found_from_the_words_alone(name: str) -> None:
    solution = solve_template(load_template(name), {})
    asks = solution.template.asked()
    assert not list_differences(solution, asks, solve(dict(write_question(solution, asks))))


def test_the_reader_shares_nothing_with_the_writer() -> None:
    imported = set[str]()
    for file in READER.glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                imported |= {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                imported.add(node.module or "")
    assert not {name for name in imported if name.startswith("kinegrade")}
    ours = {name for name in imported if name.startswith("tests")}
    assert [name for name in ours if not name.startswith("tests.description.reader")] == []


@pytest.mark.parametrize("left_out", range(3))
def test_no_sentence_on_positions_may_be_missing(left_out: int) -> None:
    solution = solve_template(load_template("slider-crank"), {})
    question = dict(write_question(solution, ("v_B",)))
    *before, places, motions = question["description"]
    sentences = places.split(". ")
    assert len(sentences) == 3
    kept = ". ".join(one for number, one in enumerate(sentences) if number != left_out)
    question["description"] = [*before, kept.removesuffix(".") + ".", motions]
    with pytest.raises(NotPlaced):
        solve(question)


def test_a_sentence_that_nobody_understands_is_named() -> None:
    solution = solve_template(load_template("slider-crank"), {})
    question = dict(write_question(solution, ("v_B",)))
    question["description"] = [*question["description"], "The crank wobbles."]
    with pytest.raises(NotUnderstood, match="not understood: The crank wobbles"):
        solve(question)
