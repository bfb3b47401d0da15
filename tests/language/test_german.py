"""German, the language that was added by the recipe alone: its nouns decline, its numbers have commas."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from kinegrade.grading.typed.unit_spelling import read_unit
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.decimal_mark import write_decimals_of_math, write_decimals_of_prose
from kinegrade.language.message import Message, list_all
from kinegrade.press.paper_parts import write_points_text
from kinegrade.problem.solving import solve_template
from kinegrade.problem.statement import write_statement
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.solution import write_worked_solution
from tests.small_class import kinegrade
from tests.worked.telling import boxed, displayed

GERMAN = Language("de")
WORDS = open_catalogue(GERMAN)


def test_a_body_is_declined_as_its_sentence_needs() -> None:
    rod, wheel = Message("solution.body-rod"), Message("solution.body-wheel")
    assert WORDS.write(rod) == "die Stange"
    assert WORDS.write(wheel, "genitive") == "des Rades"
    assert WORDS.write(list_all([rod, wheel]), "dative") == "der Stange und dem Rad"


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ("body-wheel", "Gegeben: die Winkelgeschwindigkeit des Rades relativ zum Rad."),
        ("body-rod", "Gegeben: die Winkelgeschwindigkeit der Stange relativ zur Stange."),
    ],
)
def test_a_preposition_and_the_article_that_fills_a_place_are_one_word(
    body: str, said: str
) -> None:
    name = Message(f"solution.{body}")
    given = Message("solution.given-relative-rotation-velocity", body=name, other=name)
    assert WORDS.write(given) == said


def test_a_relative_pronoun_is_not_drawn_together_with_its_preposition() -> None:
    assert "einen Körper, von dem die" in WORDS.text("solution.method-idle")


def test_numbers_have_a_comma_in_words_and_in_formulas() -> None:
    assert WORDS.write(Fraction(5, 2)) == "2,5"
    assert write_points_text(Fraction(5, 2), GERMAN) == "2,5"
    assert write_decimals_of_math(r"0.25\,\unit{m/s}", GERMAN) == r"0{,}25\,\unit{m/s}"
    assert write_decimals_of_prose("Bild 1.2 mit $r = 0.5$.", GERMAN) == "Bild 1.2 mit $r = 0{,}5$."


def test_a_statement_and_a_worked_solution_hold_no_decimal_point() -> None:
    solution = solve_template(load_template("slider-crank"), {"r": "3/20", "phi": "40"})
    statement = write_statement(solution.template, solution.parameters, GERMAN)
    assert r"0{,}15" in statement
    blocks = write_worked_solution(solution, ("v_B", "a_B"), GERMAN).blocks
    lines = displayed(blocks)
    assert not [line for line in lines if "0." in line]
    exact = (solution.answers[name].decimal(5) for name in ("v_B", "a_B"))
    assert [value.split(r"\,")[0] for value in boxed(blocks)] == [
        text.replace(".", "{,}") for text in exact
    ]


def test_the_demonstration_exam_is_set_in_german(tmp_path: Path) -> None:
    (tmp_path / "roster.csv").write_text("student,name\n1,Ann\n", encoding="utf-8")
    made = kinegrade(
        "generate", "demo", tmp_path / "roster.csv", "-o", tmp_path / "EXAM", "--lang", "de",
        "--reproducible", "words", "--also", "html", "--jobs", 1,
    )  # fmt: skip
    assert made.exit_code == 0
    (page,) = (tmp_path / "EXAM" / "papers").glob("*.html")
    text = page.read_text(encoding="utf-8")
    assert [
        words
        for words in ("Kinematik: Beispielklausur", "Schubkurbelgetriebe", "Ihre Antwort", "Punkte")
        if words not in text
    ] == []
    assert '<html lang="de"' in text


@pytest.mark.parametrize("typed", ["cm pro Sekunde", "Zentimeter/s"])
def test_a_unit_is_read_in_german(typed: str) -> None:
    unit = read_unit(typed)
    assert unit is not None
    assert unit == read_unit("cm/s")
