"""What is given and asked in one unit of length is worked out in it, from the first line to the
last; anything else in SI.
"""

from __future__ import annotations

import pytest

from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.reading import read_template
from kinegrade.worked.document import Pictures
from kinegrade.worked.solution import write_worked_solution
from kinegrade.worked.unit_of_length import count_lengths_as_given
from tests.problem.turning_crank import changed
from tests.worked.telling import lines

IN_CENTIMETRES = ('unit = "m", draw = [1, "3/2"]', 'unit = "cm", draw = [20, 30]')
ASKED_IN = ('unit = "m/s", means', 'unit = "%s", means')


def tell_crank(*changes: tuple[str, str]) -> list[str]:
    """The lines of the worked solution of the crank with some texts replaced."""
    template = read_template("crank", changed(*changes))
    return list(lines(write_worked_solution(solve_template(template, {}), ["v_A"], "en").blocks))


def asking_in(unit: str) -> tuple[str, str]:
    return ASKED_IN[0], ASKED_IN[1] % unit


@pytest.mark.parametrize("unit", ["cm", "mm", "in", "ft", "km"])
def test_what_is_given_and_asked_in_a_unit_of_length_stays_in_it(unit: str) -> None:
    given = IN_CENTIMETRES[0], IN_CENTIMETRES[1].replace("cm", unit)
    told = "\n".join(tell_crank(given, asking_in(f"{unit}/s")))
    assert rf"= 20\,\unit{{{unit}}} \cdot 2\,\unit{{rad/s}} = " in told
    assert rf"\boxed{{40\,\unit{{{unit}/s}}}}" in told


@pytest.mark.parametrize(
    ("asked", "value"), [("m/s", "0.4"), ("mm/s", "400"), ("cm/min", "2400"), ("km/h", "1.44")]
)
def test_where_units_of_length_differ_the_solution_is_in_si(asked: str, value: str) -> None:
    told = "\n".join(tell_crank(IN_CENTIMETRES, asking_in(asked)))
    assert r"0.2\,\unit{m} \cdot 2\,\unit{rad/s} = " in told
    assert rf"{value}\,\unit{{{asked}}}" in told
    assert r"\unit{cm}" not in told


def test_inches_beside_feet_are_worked_out_in_feet() -> None:
    given = IN_CENTIMETRES[0], IN_CENTIMETRES[1].replace("cm", "in").replace("20", "6")
    told = "\n".join(tell_crank(given, asking_in("ft/s")))
    assert r"0.5\,\unit{ft} \cdot 2\,\unit{rad/s} = " in told
    assert r"\boxed{1\,\unit{ft/s}}" in told
    told = "\n".join(tell_crank(given, asking_in("in/min")))
    assert r"0.1524\,\unit{m} \cdot 2\,\unit{rad/s} = " in told


def test_a_template_that_writes_a_length_as_a_number_is_worked_out_in_si() -> None:
    by_number = 'M = "polar(O, half, phi)"', 'M = "(0.1, 0)"'
    told = "\n".join(tell_crank(IN_CENTIMETRES, asking_in("cm/s"), by_number))
    assert r"0.2\,\unit{m}" in told


@pytest.mark.parametrize(
    "name", ["geneva-drive", "spool-pulled-by-cord", "slotted-bar-between-two-rods"]
)
def test_lines_and_pictures_of_a_solution_in_centimetres_hold_no_metres(name: str) -> None:
    template = load_template(name)
    solution = solve_template(template, {})
    _, unit = count_lengths_as_given(solution, template.asked())
    blocks = write_worked_solution(solution, template.asked(), "en").blocks
    assert unit in ("cm", "mm")
    assert not [line for line in lines(blocks) if r"\unit{m" in line.replace(r"\unit{mm", "")]
    captions = [
        each.caption for one in blocks if isinstance(one, Pictures) for each in one.pictures
    ]
    scales = [caption for caption in captions if "corresponds to" in caption]
    assert [caption for caption in scales if f" {unit}/s" not in caption] == []


def test_motions_of_ten_thousands_of_a_unit_are_worked_out_in_si() -> None:
    fast = 'unit = "rad/s", draw = [2]', 'unit = "rad/s", draw = [200]'
    told = "\n".join(tell_crank(IN_CENTIMETRES, asking_in("cm/s"), fast))
    assert r"0.2\,\unit{m} \cdot 200\,\unit{rad/s}" in told
