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
from tests.worked.telling import displayed, lines

CONTACT = re.compile(r"touches its track at \$([^$]*)\$\.")
ORIGIN = re.compile(
    r"is the origin of the coordinates|origin of the coordinates is fixed|measured from"
)
COORDINATE = re.compile(r"[xy]_\{[A-Z](?:_\{\w\})?'*\} &=")
FORMULA = re.compile(r"\$([^$]*)\$")
EQUATED = re.compile(r"(r_\{\w+\}) = r_\{\w+\} [+-]")


def pages(name: str) -> Iterator[Sequence[Block]]:
    """Solutions of all asks together, and of those that are asked where a bank names none."""
    for place, solution in enumerate(drawn(name)):
        yield kept(name, place)
        yield write_worked_solution(solution, solution.template.asked(), "en").blocks


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_point_of_contact_is_introduced_where_the_page_goes_on_to_use_it(name: str) -> None:
    for blocks in pages(name):
        page = tuple(lines(blocks))
        for place, line in enumerate(page):
            for letter in CONTACT.findall(line):
                assert letter in _read_formulas(page[place + 1 :]), line


def _read_formulas(page: Sequence[str]) -> str:
    """The formulas of the lines: displays and tables whole, of sentences what is set as math."""
    shown = [line for line in page if line.startswith("    ") and "[picture" not in line]
    said = [one for line in page if line not in shown for one in FORMULA.findall(line)]
    return " ".join((*shown, *said))


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_page_names_the_origin_where_it_states_coordinates_and_there_alone(name: str) -> None:
    for blocks in pages(name):
        stated = [line for line in displayed(blocks) if COORDINATE.match(line)]
        page = "\n".join(lines(blocks))
        named = ORIGIN.search(page) is not None
        assert named == bool(stated) or "measured from" in page, stated or page


@pytest.mark.sampled(12, first=1)
@pytest.mark.parametrize("name", find_template_names())
def test_a_radius_in_a_sentence_is_found_or_given(name: str) -> None:
    for blocks in pages(name):
        found = displayed(blocks)
        given = {one.symbol for one in drawn(name)[0].template.parameters.values()}
        for line in lines(blocks):
            for radius in EQUATED.findall(line):
                known = any(one.startswith(f"{radius} &=") for one in found)
                assert known or radius in given, line
