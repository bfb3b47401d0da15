"""The page of a cycle in a real browser: it plays, and the slider chooses a drawing."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from kinegrade.cycles.cycle import make_cycle
from kinegrade.language import ENGLISH
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from kinegrade.public.cycles import write_cycle
from tests.browsers.page import Page, open_page

SHOWN = "document.querySelector('output').textContent"
DRAWN = "document.querySelector('g.moving').innerHTML"


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Page]:
    cycle = make_cycle(solve_template(load_template("slider-crank"), {}), ("v_B",), centrodes=True)
    file = tmp_path_factory.mktemp("cycle") / "cycle.html"
    file.write_bytes(write_cycle(cycle, ENGLISH, "html"))
    with open_page() as page:
        page.open(file.as_uri())
        yield page


def test_the_mechanism_moves_when_it_is_played_until_it_is_stopped(page: Page) -> None:
    assert page.run(SHOWN) == "0.0"
    first = page.run(DRAWN)
    page.run("document.querySelector('button').click()")
    page.wait(f"{SHOWN} !== '0.0'")
    page.run("document.querySelector('button').click()")
    assert page.run(DRAWN) != first
    assert page.run("document.querySelector('button').textContent") == "Play"


def test_the_slider_chooses_a_drawing_and_its_end_is_its_beginning(page: Page) -> None:
    choose = (
        "(() => {{ const slider = document.querySelector('input'); slider.value = {};"
        " slider.dispatchEvent(new Event('input')); return {}; }})()"
    )
    assert page.run(choose.format("18", SHOWN)) == "90.0"
    assert page.run(choose.format("slider.max", SHOWN)) == "0.0"


def test_nothing_is_said_or_asked(page: Page) -> None:
    assert [said for said in page.messages() if not said.endswith("/cycle.html")] == []
