"""A sum of angles is worked out before a sine or a cosine takes it."""

from __future__ import annotations

import pytest

from kinegrade.language import Language
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.worked.draws import kept, told
from tests.worked.telling import lines, proses


def test_a_sum_has_its_value_before_the_law_of_sines_takes_it() -> None:
    first, *taken = (line for line in lines(kept("stone-crusher")) if "21.141" in line)
    assert r"$\delta + \psi_{EG} = 15^\circ + 6.141^\circ \approx 21.141^\circ$" in first
    assert any("cos" in line for line in taken), taken


def test_the_angles_of_a_projection_are_worked_out_once() -> None:
    """The velocities use two of them, and the accelerations the same again."""
    told = list(proses(kept("pin-in-two-rings")))
    for sum_of_two in (
        r"\angle O_{2}O_{1}M + \psi_{CM} = 36.870^\circ + 18.435^\circ \approx 55.305^\circ$",
        r"\angle O_{2}O_{1}M - \psi_{AM} = 36.870^\circ - 18.435^\circ \approx 18.435^\circ$",
    ):
        assert sum(text.count(sum_of_two) for text in told) == 1


def test_a_sum_of_whole_degrees_is_read_at_a_glance() -> None:
    """sin(beta + gamma), then sin 120 degrees."""
    said = proses(kept("stone-crusher"))
    assert [text for text in said if "\\beta + \\gamma =" in text] == []


@pytest.mark.parametrize(
    ("language", "start"), [("de", "$\\angle OPC$ ist"), ("zh", "$\\angle OPC$ 等于")]
)
def test_it_is_said_in_the_language_of_the_page(language: Language, start: str) -> None:
    blocks = told(solve_template(load_template("geneva-drive"), {}), language=language)
    (found,) = (text for text in proses(blocks) if r"\varphi + \psi_{CP} =" in text)
    assert found.startswith(start)


def test_a_sum_is_worked_out_once_though_its_doubles_differ() -> None:
    """Two projections found the same angle, apart in the last place of a double."""
    given = {"l_OA": "10", "l_OB": "45", "l_BD": "30", "phi": "30", "omega_0": "5"}
    name = "crank-bar-through-sleeve-with-arm"
    said = proses(told(solve_template(load_template(name), given)))
    assert sum(r"\varphi + \psi_{BA} =" in text for text in said) == 1
