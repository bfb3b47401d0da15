"""What the shipped statements print: senses in words and positive numbers; what is asked comes in
the order in which it is found.
"""

from __future__ import annotations

import re

import pytest

from kinegrade.draws.deck import make_deck
from kinegrade.exam.quiz.paper import show_instance
from kinegrade.problem.holding import condition_holds
from kinegrade.problem.needs import find_needs
from kinegrade.problem.statement import list_statement_languages, write_statement
from kinegrade.problem.template.given_marks import ALONG_AXES
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.template import Template

DRAWS = 12


@pytest.mark.parametrize("name", find_template_names())
def test_only_coordinates_have_a_sign_and_no_angle_is_beyond_half_a_turn(name: str) -> None:
    template = load_template(name)
    for given in make_deck(template, "statements", name).first(DRAWS):
        if not all(condition_holds(template, each, given) for each in template.scheme.conditions):
            continue
        shown = show_instance(template, given, template.asks).parameters
        for language in list_statement_languages(template):
            statement = write_statement(template, shown, language)
            signed = re.findall(r"\$([^$ ]+) = -", statement)
            assert [symbol for symbol in signed if not symbol.startswith("x_{")] == []
            angles = re.findall(r"= ([\d.]+)\^\\circ", statement)
            assert [angle for angle in angles if float(angle) > 180] == []


@pytest.mark.parametrize("name", find_template_names())
def test_velocities_are_asked_before_accelerations(name: str) -> None:
    template = load_template(name)
    changing = [is_of_accelerations(template, ask) for ask in template.asks]
    assert changing == sorted(changing)


def is_of_accelerations(template: Template, ask: str) -> bool:
    return find_needs(template, [ask]).changes or template.asks[ask].unit.time == -2


@pytest.mark.parametrize("name", find_template_names())
def test_the_name_of_what_is_asked_leaves_the_positive_sense_to_its_own_line(name: str) -> None:
    """A platform's "acceleration, upwards" would be false where the platform slows down."""
    said = (", to the right", ", to the left", ", upwards", ", downwards", "为正", ", nach ")
    for ask in load_template(name).asks.values():
        if ask.sign in ALONG_AXES:
            for meaning in ask.means.texts:
                assert not [each for each in said if each in meaning], meaning
