"""A translation names bodies for which the catalogues have no word."""

from __future__ import annotations

from pathlib import Path

import pytest

from kinegrade.description.description import describe
from kinegrade.errors import TemplateError
from kinegrade.language import Language
from kinegrade.language.prose.plain import write_prose
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.small_class import kinegrade

TEMPLATE = """family = "lever"
source = "own"
title.en = "Lever with a ram"
statement.en = "The lever $CB$ of length {{ l }} turns about $C$ at {{ omega }}."
joints = [
  "pin C: ground CB",
  "B of CB slides on line(B, pi/2) of ram",
  "E of ram slides on line(E, 0)",
  "ram translates",
]
inputs = [{ motion = "CB turns", velocity = "omega" }]
[parameters]
l = { unit = "mm", draw = "360 .. 480 step 20", means.en = "length" }
omega = { unit = "rad/s", draw = "1 .. 3 step 1", means.en = "rate" }
[points]
C = "(0, 0)"
B = "polar(C, l, pi/3)"
E = "(x(B) - l, 0)"
[bodies]
CB = "C B"
ram = "E"
[asks]
v_E = { quantity = "x(velocity(E))", unit = "m/s", sign = "+x", points = 1, means.en = "speed" }
"""
GERMAN = """title = "Hebel mit Stößel"
statement = "Der Hebel $CB$ der Länge {{ l }} dreht sich um $C$ mit {{ omega }}."
[parameters]
l = "Länge"
omega = "Rate"
[asks]
v_E = "Geschwindigkeit"
"""
NOUN = '[bodies]\nram = "der Stößel|des Stößels|dem Stößel|den Stößel"\n'
PLAIN = '[bodies]\nram = "Stößel"\n'
MISSING = "the body ram has no name in de: worked solutions and figures in words call it ram"


def write(folder: Path, names: str, template: str = TEMPLATE) -> Path:
    """A template with its German translation beside it."""
    (folder / "lever.toml").write_text(template, encoding="utf-8")
    (folder / "lever.de.toml").write_text(f"{GERMAN}{names}", encoding="utf-8")
    return folder / "lever.toml"


def described(path: Path, language: str) -> str:
    """The figure in words."""
    found = describe(solve_template(load_template(str(path)), {}), Language(language))
    assert found is not None
    return "\n".join(write_prose(part.text, "description") for part in found.long)


def test_a_body_is_called_in_each_language_as_the_translation_names_it(tmp_path: Path) -> None:
    path = write(tmp_path, NOUN)
    assert "of ram, along" in described(path, "en")
    german = described(path, "de")
    assert "Der Stößel" in german
    assert "des Stößels" in german
    assert "ram" not in german


def test_a_name_of_one_form_is_used_in_all_places(tmp_path: Path) -> None:
    assert "Stößel" in described(write(tmp_path, PLAIN), "de")


def test_a_template_names_its_bodies_by_language_itself(tmp_path: Path) -> None:
    called = '{ points = "E", called = { en = "the ram", de = "Stößel" } }'
    path = write(tmp_path, "", TEMPLATE.replace('ram = "E"', f"ram = {called}"))
    assert "of the ram, along" in described(path, "en")
    assert "Stößel" in described(path, "de")


def test_check_says_which_body_has_no_name(tmp_path: Path) -> None:
    lacking = kinegrade("check", write(tmp_path, ""), "--sample", "2")
    assert MISSING in lacking.output
    named = kinegrade("check", write(tmp_path, NOUN), "--sample", "2")
    assert "no name in" not in named.output
    assert lacking.exit_code == named.exit_code


@pytest.mark.parametrize(
    ("names", "said"),
    [
        ('[bodies]\nrma = "Stößel"\n', "lever.de.toml:9: bodies.rma: no such text"),
        ('[bodies]\nram = "der Stößel|des Stößels"\n', "a name in one form, or in all of them"),
        ("[bodies]\nram = 3\n", "lever.de.toml:9: bodies.ram: 3"),
    ],
)
def test_a_name_of_no_body_is_a_fault(tmp_path: Path, names: str, said: str) -> None:
    path = write(tmp_path, names)
    with pytest.raises(TemplateError) as refused:
        load_template(str(path))
    assert said in str(refused.value)
    shown = kinegrade("check", path, "--sample", "2")
    assert shown.exit_code == 2
