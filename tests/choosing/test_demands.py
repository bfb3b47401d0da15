"""What a template takes, counted by hand; the tags of shipped templates are true to their motion."""

from __future__ import annotations

import pytest

from kinegrade.choosing.choice import make_entry
from kinegrade.choosing.demands import find_demands
from kinegrade.language.catalogue import open_catalogue
from kinegrade.language.known import known_languages
from kinegrade.mechanics.ground import GROUND
from kinegrade.mechanics.joints import Arc, Belt, Contact, Roll, Sleeve, Slide
from kinegrade.problem.quantities.functions import find_motion_calls
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import find_template_names, load_template
from kinegrade.problem.template.tags import TAGS, list_tags
from kinegrade.problem.template.template import Template

SHIPPED = find_template_names()


def find_facts(template: Template) -> dict[str, bool]:
    """Which tags follow from the mechanism and what is asked of it."""
    scheme, demands = template.scheme, find_demands(template)
    stated = {joint.stated for joint in scheme.joints}
    carried = {joint.stated for joint in scheme.joints if joint.of != GROUND}
    steps = solve_template(template, {}, template.asked()).motion.plan.steps
    asked = [template.asks[name].quantity for name in template.asked()]
    called = {call.function for tree in asked for call in find_motion_calls(tree)}
    return {
        "coriolis": demands.coriolis,
        "relative-motion": "relative-motion" in demands.methods,
        "base-point": "base-point" in demands.methods,
        "pole": "pole" in called,
        "rolling": Roll in stated,
        "belt": Belt in stated,
        "sleeve": Sleeve in stated,
        "slipping-contact": Contact in stated,
        "slot": Slide in carried,
        "curved-slot": Arc in carried,
        "two-inputs": len(scheme.drivers) > 1,
        "simultaneous": any(len(step.unknowns) > 2 for step in steps),
    }


@pytest.mark.parametrize("name", SHIPPED)
def test_the_tags_of_a_shipped_template_are_true(name: str) -> None:
    template = load_template(name)
    facts = find_facts(template)
    assert set(template.about.tags) & set(facts) == {tag for tag, true in facts.items() if true}


def test_shipped_templates_have_known_tags_and_each_tag_has_a_template_and_a_meaning() -> None:
    used = set().union(*(list_tags(load_template(name)) for name in SHIPPED))
    assert used == set(TAGS)
    for language in known_languages():
        words = open_catalogue(language)
        assert [tag for tag in TAGS if not words.text(f"choosing.tag-{tag}")] == []


def test_a_slider_crank_takes_a_velocity_equation_and_an_acceleration_equation() -> None:
    demands = find_demands(load_template("slider-crank"))
    # The steps 1 and 1.5, four answers of which three have a sense, a point found by sines, two
    # bodies
    assert demands.effort == 1 + 1.5 + 4 * 0.25 + 3 * 0.25 + 0.5 + 2 * 0.25
    assert (demands.difficulty, demands.minutes) == (2, 16)
    assert demands.joints == {"pin", "slide"}
    assert demands.methods == {"base-point", "projection", "pole"}
    assert not demands.coriolis
    assert {"velocity", "acceleration", "omega", "alpha"} <= demands.asked


def test_a_translating_frame_has_no_coriolis_acceleration() -> None:
    assert not find_demands(load_template("parallelogram-with-sliding-rod")).coriolis
    assert find_demands(load_template("bar-through-swivelling-sleeve")).coriolis


def test_what_is_easier_for_an_instructor_is_not_called_harder() -> None:
    order = (
        "pose-cam-tappet",
        "rolling-wheel-rim-points",
        "slider-crank",
        "eccentric-cam-offset-follower",
        "rolling-wheel-pin-slotted-rocker",
        "bar-pushing-rolling-disc",
    )
    efforts = [make_entry(load_template(name)).demands.effort for name in order]
    assert efforts == sorted(efforts)


def test_templates_of_every_difficulty_are_shipped() -> None:
    found = [find_demands(load_template(name)).difficulty for name in SHIPPED]
    assert {level: found.count(level) >= 5 for level in range(1, 6)} == dict.fromkeys(
        range(1, 6), True
    )
