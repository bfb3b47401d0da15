"""Templates as an author writes them, of mechanisms of which the shipped ones have none: cylinders
that extend at a given rate, a point that is driven along both axes.
"""

from __future__ import annotations

from functools import cache
from math import cos, hypot, radians, sin
from pathlib import Path

import pytest

from kinegrade.problem.solution import Solution
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.problem.template.template import Template
from kinegrade.proof.claims.claims import find_false_claims
from kinegrade.proof.clauses.clauses import find_false_clauses
from kinegrade.worked.document import Block
from kinegrade.worked.solution import write_worked_solution
from tests.problem.draws import draw_filter, drawn
from tests.said import all_said
from tests.worked.reader.laws import find_faults
from tests.worked.telling import displayed, proses

HERE = Path(__file__).parent
NAMES = sorted(path.stem for path in HERE.glob("*.toml"))
ANGLES = frozenset({"theta", "phi", "psi"})


@cache
def read(name: str) -> Template:
    """The template of that name here."""
    return read_template(name, (HERE / f"{name}.toml").read_text(encoding="utf-8"))


@cache
def dealt(name: str) -> Solution:
    """An instance that a paper may have."""
    template = read(name)
    return solve_template(template, drawn(draw_filter(template), 1)[0].values)


@cache
def blocks(name: str) -> tuple[Block, ...]:
    """Its worked solution, for all asks."""
    solution = dealt(name)
    return write_worked_solution(solution, solution.template.asks, "en").blocks


def values(name: str) -> dict[str, float]:
    """The givens: angles in radians, all else as stated."""
    given = {one: each.value for one, each in dealt(name).parameters.items()}
    return {one: radians(value) if one in ANGLES else value for one, value in given.items()}


def answer(name: str, ask: str) -> float:
    """The key's value."""
    return dealt(name).answers[ask].value


@pytest.mark.parametrize("name", NAMES)
def test_its_solution_keeps_the_laws_of_print(name: str) -> None:
    faults = list(find_faults(blocks(name), dealt(name)))
    assert faults == [], "\n".join(f"{each.law}: {each.line}" for each in faults)


@pytest.mark.parametrize("name", NAMES)
def test_what_it_says_is_true(name: str) -> None:
    said = (
        *find_false_claims(read(name), (dealt(name),)),
        *find_false_clauses(read(name), (dealt(name),)),
    )
    assert all_said(said) == []


def test_a_cylinder_turns_the_body_by_the_law_of_cosines() -> None:
    """CA^2 = a^2 + b^2 - 2ab cos(theta), differentiated."""
    of = values("tipper")
    a, b, theta, u = of["a"], of["b"], of["theta"], of["u"]
    extended = hypot(b * cos(theta) - a, b * sin(theta))
    assert answer("tipper", "omega_OA") == pytest.approx(u * extended / (a * b * sin(theta)))


def test_each_of_two_cylinders_turns_its_own_body() -> None:
    of = values("excavator")
    first = hypot(of["d"] * cos(of["phi"]) - of["c"], of["d"] * sin(of["phi"]))
    boom = of["u_1"] * first / (of["c"] * of["d"] * sin(of["phi"]))
    assert answer("excavator", "omega_OA") == pytest.approx(boom)
    half, e, psi = of["l"] / 2, of["e"], of["psi"]
    second = hypot(half + e * cos(psi), e * sin(psi))
    stick = -of["u_2"] * second / (half * e * sin(psi))
    assert answer("excavator", "omega_r") == pytest.approx(stick)


def test_an_arm_that_is_led_at_its_tip_moves_it_as_given() -> None:
    of, places = values("led-arm"), dealt("led-arm").assembly.values
    (x, y), (tip_x, tip_y) = ((float(places[one].x), float(places[one].y)) for one in ("A", "P"))
    arm, forearm = answer("led-arm", "omega_OA"), answer("led-arm", "omega_AP")
    assert -arm * y - forearm * (tip_y - y) == pytest.approx(-of["u"])
    assert arm * x + forearm * (tip_x - x) == pytest.approx(of["w"])


@pytest.mark.parametrize(
    ("name", "letters"),
    [
        ("tipper", (r"v_{\mathrm{r}}",)),
        ("excavator", (r"v_{\mathrm{r}}", r"v_{\mathrm{r}E}")),
    ],
)
def test_the_rate_of_a_cylinder_is_known_before_motions_are_composed(
    name: str, letters: tuple[str, ...]
) -> None:
    """It was sought by the equation in which it stands, and v_e came from nowhere."""
    lines = displayed(blocks(name))
    for letter in letters:
        assert any(line.startswith(f"{letter} &= u") for line in lines), lines
    ways = [text for text in proses(blocks(name)) if text.startswith("Given: the velocity")]
    assert len(ways) == len(letters)
    assert all("positive from $" in text for text in ways), ways


def test_components_that_drivers_give_have_letters_of_their_own() -> None:
    """Both were v_P, with two values."""
    lines = displayed(blocks("led-arm"))
    assert any(line.startswith(r"v_{P,x} &= -u") for line in lines), lines
    assert any(line.startswith(r"v_{P,y} &= w") for line in lines), lines
    (idea,) = (text for text in proses(blocks("led-arm")) if "Known: " in text)
    assert idea.count("the motion of $P$") == 1
