"""Formulas in words: as a person says them, whole, and no two alike."""

from __future__ import annotations

import re
from collections import defaultdict

import pytest
from hypothesis import given

from kinegrade.errors import TypesetError
from kinegrade.language import Language
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.language.math.letters import FUNCTIONS, GREEK, SIGNS, name_sign
from kinegrade.language.math.plain import write_plain_math
from kinegrade.language.math.spoken.speaking import speak_math, speak_row
from kinegrade.language.math.spoken.units import speak_unit
from kinegrade.language.math.tree import Number, Row, list_nodes
from kinegrade.numbers.units import TYPED
from tests.language.math.formulas import TREES, list_formulas

SAID = (
    (
        r"v_B = \frac{\sqrt{3}}{2}\,\mathrm{m/s}",
        "v B equals root 3 over 2 metres per second",
        "v B 等于 2 分之根号 3 米每秒",
        "v B gleich Wurzel 3 durch 2 Meter pro Sekunde",
    ),
    (
        r"\frac{a+b}{c} \ne a+\frac{b}{c}",
        "fraction with numerator a plus b and denominator c, end of fraction is not equal to a "
        "plus b over c",
        "分式，分子为 a 加 b，分母为 c，分式结束不等于 a 加 c 分之 b",
        "Bruch mit Zähler a plus b und Nenner c, Ende des Bruchs ungleich a plus b durch c",
    ),
    (
        r"-2\sin^2\varphi, \quad \omega_{AB}' = 1\,\unit{rad/s^2}",
        "minus 2 sine squared phi, omega prime A B equals 1 radian per second squared",
        "负 2 正弦的平方斐，欧米伽撇 A B 等于 1 弧度每二次方秒",
        "minus 2 Sinus Quadrat Phi, Omega Strich A B gleich 1 Radiant pro Sekunde zum Quadrat",
    ),
    (
        r"\boldsymbol{a}_{BA}^{\mathrm{n}} \approx 0{,}5\,\unit{m^2}",
        "vector a B A superscript n is approximately 0,5 square metres",
        "矢量 a B A 上标 n 约等于 0,5 平方米",
        "Vektor a B A oben n ungefähr gleich 0,5 Quadratmeter",
    ),
    (
        r"\left|v_{\mathrm{r}}\right| \perp \overline{AB}",
        "magnitude of v r perpendicular to A B bar",
        "v r 的绝对值垂直于 A B 上横线",
        "Betrag von v r senkrecht zu A B quer",
    ),
    (
        r"\sqrt{a^{-1}+x^{n+1}}, \varphi = 30^\circ - \Delta\alpha",
        "root of a to the power minus 1 plus x to the power n plus 1, end of power, end of root, "
        "phi equals 30 degrees minus capital delta alpha",
        "根号下 a 的负 1 次方加 x 的次方 n 加 1，次方结束，根号结束，斐等于 30 度减大写德尔塔阿尔法",
        "Wurzel aus a hoch minus 1 plus x hoch n plus 1, Ende des Exponenten, Ende der Wurzel, "
        "Phi gleich 30 Grad minus großes Delta Alpha",
    ),
)


@pytest.mark.parametrize(("latex", "english", "chinese", "german"), SAID)
def test_a_formula_is_said_as_in_the_lecture(
    latex: str, english: str, chinese: str, german: str
) -> None:
    said = [speak_math(latex, "q1", Language(name)) for name in ("en", "zh", "de")]
    assert said == [english, chinese, german]


@pytest.mark.parametrize("language", known_languages())
def test_every_formula_of_the_templates_is_said_and_none_like_another(language: Language) -> None:
    said = defaultdict(set)
    for latex in list_formulas():
        words = speak_math(latex, "corpus", language)
        assert words
        assert "\\" not in words
        said[words].add(write_plain_math(latex).replace(" ", ""))
    assert [formulas for formulas in said.values() if len(formulas) > 1] == []


@given(TREES)
def test_every_tree_is_said_in_one_line_with_all_its_numbers(row: Row) -> None:
    words = speak_row(row, Language("en"))
    assert not re.search(r"\s\s|[\n\t]", words)
    for node in list_nodes(row):
        assert not isinstance(node, Number) or node.digits in words


@pytest.mark.parametrize("language", known_languages())
def test_every_letter_sign_function_and_unit_has_its_word(language: Language) -> None:
    catalogue = open_catalogue(language)
    letters = {f"letter-{name.lower().removeprefix('var')}" for name in GREEK}
    functions = {f"function-{name}" for name in FUNCTIONS}
    signs = {f"sign-{name_sign(sign)}" for sign in SIGNS if sign != "{,}"}
    units = {f"unit-{name}" for name in TYPED if name.isalnum() and name != "turn"}
    keys = letters | functions | signs | units
    assert {key for key in keys if not catalogue.has(f"spoken.{key}")} == set()
    words = [catalogue.text(f"spoken.{key}", count=2) for key in keys]
    assert len(set(words)) == len(words)


def test_a_unit_without_words_is_said_as_it_is_printed() -> None:
    assert speak_unit("hp*s^2", open_catalogue(Language("en"))) == "hp·s²"
    assert speak_unit("1", open_catalogue(Language("en"))) == "no unit"


def test_a_formula_that_cannot_be_read_is_refused_by_name() -> None:
    with pytest.raises(TypesetError, match="q1"):
        speak_math(r"\evil", "q1", Language("en"))
