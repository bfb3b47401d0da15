"""A point that neither the statement nor the figure letters has no letter in a solution either."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.notation import write_point_symbol
from tests.worked.draws import kept
from tests.worked.telling import displayed, lines, proses


def _list_unlettered(name: str) -> Iterator[str]:
    template = load_template(name)
    for point, label in template.figure.labels.items():
        letter = write_point_symbol(point)
        stated = (text.split("$")[1::2] for text in template.words.statement.texts)
        if label is None and not any(letter in formula for one in stated for formula in one):
            yield letter


def _find_named(name: str) -> list[str]:
    """The letters of such points that the formulas of its solutions have."""
    unlettered = [*_list_unlettered(name)]
    formulas = (
        [one for place in (0, 1) for one in _list_formulas(name, place)] if unlettered else []
    )
    told = re.sub(r"\\[A-Za-z]+", " ", "\n".join(formulas))
    return [letter for letter in unlettered if letter in told]


def _list_formulas(name: str, place: int) -> Iterator[str]:
    blocks = kept(name, place)
    yield from displayed(blocks)
    for text in proses(blocks):
        yield from text.split("$")[1::2]


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_no_solution_names_a_point_that_the_paper_has_no_letter_for(name: str) -> None:
    assert _find_named(name) == []


def test_the_slot_of_a_yoke_has_no_letter() -> None:
    assert [*_list_unlettered("scotch-yoke-driven-by-guide")] == ["B"]
    assert _find_named("scotch-yoke-driven-by-guide") == []


def test_what_is_given_of_a_body_in_translation_is_told_of_the_body() -> None:
    told = tuple(lines(kept("scotch-yoke-driven-by-guide")))
    assert any("Known: the motion of the yoke." in line for line in told), told
    assert "Given: the velocity of the yoke." in told
    (transport,) = (line for line in told if line.startswith(r"    v_{\mathrm{e}} &="))
    assert transport.startswith(r"    v_{\mathrm{e}} &= v = ")
    assert "Given: the acceleration of the yoke." in told


def test_an_acceleration_against_the_velocity_is_told_of_the_body_too() -> None:
    told = tuple(lines(kept("scotch-yoke-driven-by-guide", 1)))
    assert "Given: the acceleration of the yoke, taken positive to the right." in told
