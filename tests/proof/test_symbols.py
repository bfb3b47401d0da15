"""`check` says which symbols two givens share, and which letters of the figure nothing explains."""

from __future__ import annotations

import pytest

from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.library.starter import write_starter_text
from kinegrade.problem.template.template import Template
from kinegrade.proof.letters import note_letters
from tests.said import all_said

UNEXPLAINED = (
    "figure: k is the symbol of no given and of nothing asked, and the statement does not say what "
    "it is: print it there, or mark what is given"
)


def starter(before: str, after: str) -> Template:
    """The starter with a passage replaced wherever it stands."""
    text = write_starter_text()
    assert before in text
    return read_template("rocker", text.replace(before, after))


def test_two_givens_with_one_symbol_are_noted() -> None:
    template = starter("b     = {", 'b = { symbol = "r",')
    assert "r and b are both printed as r: give one of them another symbol" in all_said(
        note_letters(template)
    )


@pytest.mark.parametrize(
    ("symbol", "noted"),
    [
        ("k", True),
        ("k r", True),
        ("\\\\frac{k}{2}", True),
        ("\\\\frac{r}{2}", False),
        ("2r", False),
        ("r \\\\varphi", False),
        ("r_1", True),
        ("OA", False),  # as the statement calls the crank
    ],
)
def test_a_letter_of_the_figure_that_nothing_explains_is_noted(symbol: str, noted: bool) -> None:
    template = starter('symbol = "r", from', f'symbol = "{symbol}", from')
    said = [each.split(": ")[1] for each in all_said(note_letters(template))]
    assert [each.split(" is the symbol of no given")[0] for each in said] == [
        symbol.replace("\\\\", "\\")
    ] * noted


def test_it_is_said_what_to_do() -> None:
    assert all_said(note_letters(starter('symbol = "r", from', 'symbol = "k", from'))) == [
        UNEXPLAINED
    ]


@pytest.mark.parametrize("name", find_template_names())
def test_no_template_that_is_shipped_has_such_a_letter(name: str) -> None:
    assert list(note_letters(load_template(name))) == []
