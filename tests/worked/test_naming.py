"""What bodies are called in a worked solution: the paper's letters, else words that a sentence can
decline.
"""

from __future__ import annotations

import re

import pytest

from kinegrade.language import ENGLISH, Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.math.reading import read_math
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.worked.case import write_row
from kinegrade.worked.formulas.symbols import read_symbol
from kinegrade.worked.solution import write_worked_solution
from kinegrade.worked.words.bodies import name_by_number, name_kind
from kinegrade.worked.words.body_names import BodyNames
from kinegrade.worked.words.naming import Naming
from tests.worked.draws import drawn, kept
from tests.worked.reader.givens import find_letters
from tests.worked.telling import lines, tidy

POLE = re.compile(r"velocity pole \$([^$]*)\$")


@pytest.mark.parametrize(
    ("template", "body", "english", "chinese", "letters"),
    [
        ("slider-crank", "AB", "$AB$", "$AB$", "AB"),
        ("slider-crank", "ground", "the ground", "固定面", None),
        ("stone-crusher", "crank", "the crank $OE$", "曲柄 $OE$", "OE"),
        ("two-rods-driven-ends", "rod_AC", "the rod $AC$", "杆 $AC$", "AC"),
        ("rolling-wheel-rim-points", "W", "the wheel", "轮", r"\text{wheel}"),
        ("two-wheels-on-cylinder", "W2", "wheel 2", "轮 2", r"\text{wheel 2}"),
        ("planetary-gear-external-rim-velocities", "II", "gear II", "齿轮 II", r"\text{gear II}"),
        ("pin-in-two-rings", "ring1", "ring 1", "圆环 1", r"\text{ring 1}"),
        ("pose-cam-tappet", "tappet", "the follower", "从动件", r"\text{follower}"),
    ],
)
def test_a_body_is_called_by_its_letters_or_by_its_kind(
    template: str, body: str, english: str, chinese: str, letters: str | None
) -> None:
    naming = Naming(load_template(template), Language("en"))
    name = naming.body(body)
    assert open_catalogue(Language("en")).write(name) == english
    assert open_catalogue(Language("zh")).write(name) == chinese
    assert letters is None or write_row(naming.letters(body)) == letters


@pytest.mark.parametrize(
    ("template", "body", "letters"),
    [
        # their n_P and n_C are asked
        ("differential-epicyclic-train", "planet", r"\omega_{P}"),
        ("two-stage-belt-drive", "dynamo", r"\omega_{C}"),
    ],
)
def test_an_angular_velocity_has_the_index_of_the_rotational_speed(
    template: str, body: str, letters: str
) -> None:
    naming = Naming(load_template(template), Language("en"))
    assert write_row(naming.omega(body).print()) == letters


@pytest.mark.parametrize(
    ("language", "body", "letters"),
    [("en", "planet", "planet"), ("de", "cam", "Kurve"), ("de", "pulley", "Scheibe")],
)
def test_a_word_in_a_subscript_is_short(language: Language, body: str, letters: str) -> None:
    naming = Naming(load_template("slider-crank"), language)
    assert write_row(naming.letters(body)) == rf"\text{{{letters}}}"


@pytest.mark.parametrize(
    ("body", "german", "english"),
    [
        ("Trommel", "die Trommel", "the drum"),
        ("Hebel2", "Hebel 2", "lever 2"),
        ("Schwinge_CD", "die Schwinge $CD$", "the rocker $CD$"),
        ("Greifer", "Greifer", "Greifer"),
    ],
)
def test_a_word_of_any_language_is_no_symbol(body: str, german: str, english: str) -> None:
    naming = Naming(load_template("slider-crank"), Language("de"))
    name = naming.body(body)
    assert open_catalogue(Language("de")).write(name) == german
    assert open_catalogue(Language("en")).write(name) == english


@pytest.mark.parametrize(
    ("template", "ask", "poles"),
    [
        ("stone-crusher", "EC1", {"C_{1}"}),
        ("stone-crusher", "BC2", {"C_{1}", "C_{2}"}),
        ("guided-rack-and-gear", "SA", {"S"}),
        ("crank-slider-in-floating-link", "l_AP", {"P"}),
        ("elliptic-trammel-crank-driven", "ic_x", {"P"}),
    ],
)
def test_a_pole_has_the_letter_that_the_ask_gives_it(
    template: str, ask: str, poles: set[str]
) -> None:
    solution = solve_template(load_template(template), {})
    told = lines(write_worked_solution(solution, (ask,), ENGLISH).blocks)
    found = {tidy(letter) for text in told for letter in POLE.findall(text)}
    assert found == {tidy(pole) for pole in poles}


def test_a_word_that_no_catalogue_has_stays_as_the_template_writes_it() -> None:
    chinese = open_catalogue(Language("zh"))
    assert chinese.write(name_kind("cylinder")) == "气缸"
    assert chinese.write(name_kind("gripper")) == "gripper"
    assert chinese.write(name_by_number("gripper", "2")) == "gripper 2"


POINT = re.compile(r"[A-Z](?:'|_\{?\w+\}?)*")
RIM = re.compile(r"rim of (?:radius \$(?P<first>[^$]+)\$ of )?(?P<body>the \w+)")
OF_RADIUS = re.compile(r"of radius \$([^$]+)\$")


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_rim_is_that_of_the_body_to_which_the_statement_gives_its_radius(name: str) -> None:
    """The gear's rim was said to have the radius of the drum, which is fixed to it."""
    parameters = load_template(name).parameters.values()
    meanings = {read_symbol(one.symbol).row: one.means.in_language("en") for one in parameters}
    for line in lines(kept(name)):
        for found in RIM.finditer(line):
            for radius in OF_RADIUS.findall(line):
                assert found["body"] in meanings[read_math(radius, "")]


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_body_has_letters_of_the_statement(name: str) -> None:
    """A rod was called ED, where no point is E."""
    known = find_letters(drawn(name)[0])
    template = load_template(name)
    for body in template.scheme.bodies:
        letters = BodyNames(template).label(body.name).letters
        assert {*POINT.findall(letters)} <= known
