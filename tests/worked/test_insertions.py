"""Unknowns that several equations share: what is inserted into what is said."""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.worked.solution import write_worked_solution
from tests.worked.draws import kept, stated
from tests.worked.telling import displayed, lines


def _read_after(name: str, start: str, count: int, language: Language = "en") -> list[str]:
    """The lines of a template's solution from the first one that begins so."""
    told = [" ".join(line.split()) for line in lines(kept(name, 0, None, language), boxes=False)]
    place = next(place for place, line in enumerate(told) if line.startswith(start))
    return told[place : place + count]


def test_relations_between_rates_are_inserted_into_the_projection() -> None:
    # three values were given after "These equations together give"
    announced, inserted, omega, *_ = _read_after(
        "slider-driven-gear-on-rack", "By the relations above", 5
    )
    assert announced == (
        r"By the relations above, $v_{O} = -0.16\,\unit{m} \cdot \omega_{O}$, "
        r"$v_{AO} = 0.1\,\unit{m} \cdot \omega_{O}$; inserted into the projection, this "
        r"leaves only $\omega_{O}$ unknown:"
    )
    assert inserted == (
        r"0.2\,\unit{m/s} \cdot \sin 30^\circ &= 0.16\,\unit{m} \cdot \omega_{O}\cos 30^\circ"
        r" + 0.1\,\unit{m} \cdot \omega_{O}\cos 30^\circ"
    )
    assert omega.startswith(r"\omega_{O} &= \frac{10\sqrt{3}}{39}\,\unit{rad/s} \approx 0.4441")


def test_what_a_relation_adds_is_inserted_too() -> None:
    announced, inserted, *_ = _read_after(
        "slider-crank-relative-rotation-driver", "By the relations above", 2
    )
    assert r"v_{BA} = 0.2\,\unit{m} \cdot \omega_{OA} + 0.8\,\unit{m/s}$" in announced
    assert r"v_{A} \approx 0.34641\,\unit{m} \cdot \omega_{OA}$" in announced
    assert inserted.endswith(r"+ 0.8\,\unit{m/s} \cdot \cos 60^\circ")


def test_what_a_later_projection_takes_is_found_though_no_answer_needs_it() -> None:
    # -10.71 m/s^2 stood in the second projection, and nowhere before
    given = {"l_1": "0.64", "theta": "15", "psi": "60", "omega_r": "5", "alpha_r": "-5"}
    template = load_template("slider-crank-relative-rotation-driver")
    solution = solve_template(template, given)
    told = list(lines(write_worked_solution(solution, template.asked(), "en").blocks))
    (found,) = (line for line in told if r"a_{BA}^{\mathrm{t}} &=" in line)
    assert r"\approx -10.714\,\unit{m/s^2}" in found
    assert [line for line in told if "\\alpha_{AB} &=" in line] == []


def test_the_last_of_two_projections_is_inserted_into_the_first() -> None:
    announced, inserted, _, second = _read_after(
        "crank-slider-in-floating-link", "The last equation gives", 4
    )
    assert announced == (
        r"The last equation gives $\omega_{BC} \approx -0.86603\omega_{O_{1}B}$; inserted into the "
        r"first one, this leaves only $\omega_{O_{1}B}$ unknown:"
    )
    assert inserted.endswith(r"- 0.23094\,\unit{m} \cdot 0.86603\omega_{O_{1}B}")
    assert second.startswith(r"\omega_{BC} &= -0.86603 \cdot (-1\,\unit{rad/s}) \approx 0.86603")


def test_a_projection_in_which_one_unknown_is_left_gives_it_at_once() -> None:
    (speed,) = _read_after("square-on-two-fixed-points", "v_{O,x} &=", 1)
    assert speed.startswith(r"v_{O,x} &= -v_{A'O}\sin\psi_{OA} = -0.2236")


@pytest.mark.parametrize(
    ("language", "start"), [("de", "Nach den Beziehungen oben ist"), ("zh", "由以上关系得")]
)
def test_it_is_said_in_every_language(language: Language, start: str) -> None:
    announced, inserted = _read_after("slider-driven-gear-on-rack", start, 2, language)
    assert announced.endswith((r"$\omega_{O}$ unbekannt:", r"$\omega_{O}$："))
    assert r"\cdot \omega_{O}\cos 30^\circ" in inserted


def test_a_component_has_each_of_its_factors_in_numbers() -> None:
    values = {"gamma": "60", "v_A": "0.4", "a_A": "0", "v_B": "0.2", "a_B": "0"}
    (line,) = (
        line
        for line in displayed(stated("two-rods-driven-ends", **values))
        if line.startswith("v_{C,x} &=")
    )
    assert r"= 0.4\,\unit{m/s} \cdot \cos 60^\circ" in line
