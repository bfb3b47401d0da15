"""What a page introduces it uses, and what it uses it has introduced: points of contact, the origin
of coordinates, radii.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import pytest

from kinegrade.problem.template.library.library import find_template_names
from kinegrade.worked.document import Block
from kinegrade.worked.solution import write_worked_solution
from tests.worked.draws import drawn, kept
from tests.worked.telling import displayed, lines, proses

CONTACT = re.compile(r"(?:touches its track at|[Pp]oint of contact) \$([^$]*)\$")
ORIGIN = re.compile(
    r"is the origin of the coordinates|origin of the coordinates is fixed|measured from"
)
COORDINATE = re.compile(r"[xy]_\{[A-Z](?:_\{\w\})?'*\} &=")
FORMULA = re.compile(r"\$([^$]*)\$")
RADIUS = re.compile(r"(?<![A-Za-z\\])r_\{\w+\}")
# Templates of which pages surely have what a law is about
NAMED_CONTACTS = ("rolling-wheel-rim-points", "spool-pulled-by-cord")
STATED_COORDINATES = ("rod-ground-and-incline",)
NAMED_RADII = ("differential-epicyclic-train", "hoist-with-gears")


def pages(name: str) -> Iterator[Sequence[Block]]:
    """Solutions of all asks together, and of those that are asked where a bank names none."""
    for place, solution in enumerate(drawn(name)):
        yield kept(name, place)
        yield write_worked_solution(solution, solution.template.asked(), "en").blocks


@pytest.mark.sampled(12, first=1, also=NAMED_CONTACTS)
@pytest.mark.parametrize("name", find_template_names())
def test_a_point_of_contact_is_introduced_where_the_page_goes_on_to_use_it(name: str) -> None:
    seen = False
    for blocks in pages(name):
        page = tuple(lines(blocks))
        for place, line in enumerate(page):
            for letter in CONTACT.findall(line):
                seen = True
                assert _read_formulas(page[place:]).count(letter) > 1, line
    assert seen or name not in NAMED_CONTACTS


def _read_formulas(page: Sequence[str]) -> str:
    """The formulas of the lines: displays and tables whole, of sentences what is set as math."""
    shown = [line for line in page if line.startswith("    ") and "[picture" not in line]
    said = [one for line in page if line not in shown for one in FORMULA.findall(line)]
    return " ".join((*shown, *said))


@pytest.mark.sampled(12, first=1, also=STATED_COORDINATES)
@pytest.mark.parametrize("name", find_template_names())
def test_a_page_names_the_origin_where_it_states_coordinates_and_there_alone(name: str) -> None:
    for blocks in pages(name):
        stated = [line for line in displayed(blocks) if COORDINATE.match(line)]
        page = "\n".join(lines(blocks))
        named = ORIGIN.search(page) is not None
        assert named == bool(stated) or "measured from" in page, stated or page
        assert stated or name not in STATED_COORDINATES


@pytest.mark.sampled(12, first=1, also=NAMED_RADII)
@pytest.mark.parametrize("name", find_template_names())
def test_a_radius_in_a_sentence_is_found_or_given(name: str) -> None:
    seen = set[str]()
    for blocks in pages(name):
        found = displayed(blocks)
        given = {one.symbol for one in drawn(name)[0].template.parameters.values()}
        formulas = [one for text in proses(blocks) for one in FORMULA.findall(text)]
        for radius in {one for formula in formulas for one in RADIUS.findall(formula)}:
            seen.add(radius)
            known = any(one.startswith(f"{radius} &=") for one in found)
            assert known or radius in given, radius
    assert seen or name not in NAMED_RADII
