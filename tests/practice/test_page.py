"""The page in real browsers, opened from a file: it works, asks nothing of anybody, says nothing on
the console.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from msgspec import structs

from kinegrade import Bank
from kinegrade.language import ENGLISH
from kinegrade.practice.making import make_practice_sheet
from kinegrade.practice.page import write_page
from tests.browsers.page import Page, open_page
from tests.practice.typed_sheet import open_sheet
from tests.small_class import kinegrade

INPUTS = "document.querySelectorAll('section:first-of-type input[type=text]')"
SAID = "document.querySelectorAll('section:first-of-type .verdict')"


GROUP = pytest.mark.xdist_group("firefox")  # one process starts it, and makes the English sheet


@cache
def write_sheet(language: str, folder: Path) -> Path:
    """The demonstration's sheet in a language."""
    file = folder / f"{language}.html"
    done = kinegrade("practice", "demo", "-o", file, "--draws", "2", "--lang", language)
    assert done.exit_code == 0, done.stderr
    return file


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("practice")


@pytest.fixture(
    params=[
        pytest.param(("chromium", "en"), marks=GROUP),
        pytest.param(("chromium", "zh"), marks=GROUP),
        pytest.param(
            ("chromium", "de"), marks=[GROUP, pytest.mark.left(beside="test_it_fits_a_telephone")]
        ),
        pytest.param(("firefox", "en"), marks=GROUP),
    ],
    ids=" ".join,
)
def page(request: pytest.FixtureRequest, folder: Path) -> Iterator[Page]:
    """The sheet, opened."""
    browser, language = request.param
    with open_page(browser) as page:
        open_sheet(page, write_sheet(language, folder))
        yield page


def find_right_answers(page: Page) -> list[str]:
    """What is baked for the first question's first draw."""
    keys = page.run(
        "unpack(document.querySelector('#baked').textContent)"
        ".then(({ sheet }) => sheet.questions[0].draws[0].keys.map(([value]) => value))"
    )
    return [f"{float(value):.5g}" for value in keys]


def test_a_student_types_and_reads_the_verdicts(page: Page) -> None:
    right = find_right_answers(page)
    page.run(f"{INPUTS}[0].focus()")
    page.type(right[0].replace(".", ","))
    page.press("Tab")
    page.type("abc")
    page.press("Enter")
    kinds = page.run(f"[...{SAID}].map((each) => each.dataset.kind)")
    assert kinds == ["right", "unreadable", "blank"]
    assert '"abc"' in page.run(f"{SAID}[1].textContent")
    assert page.run(f"{INPUTS}[1].getAttribute('aria-invalid')") == "true"
    assert re.search(r"\b3\b.*\b34\b", page.run("document.querySelector('#score').textContent"))


def test_the_solution_comes_step_by_step_and_then_answers_do_not_count(page: Page) -> None:
    count = "document.querySelectorAll('section:first-of-type .steps > div').length"
    page.run("document.querySelector('.hint').click()")
    assert page.run(count) == 1
    page.run("document.querySelector('.solution').click()")
    assert page.run(count) > 2
    assert page.run("document.querySelector('.hint').disabled")
    page.run(f"{INPUTS}[0].value = '{find_right_answers(page)[0]}'")
    page.run("document.querySelector('form').requestSubmit()")
    assert page.run(f"{SAID}[0].dataset.kind") == "right"
    assert re.search(r"\b0\b.*\b34\b", page.run("document.querySelector('#score').textContent"))


def test_new_numbers_are_another_draw_with_its_own_figure(page: Page) -> None:
    shown = "document.querySelector('section .statement').textContent"
    figure = "document.querySelector('section .figure').innerHTML"
    first, drawn = page.run(shown), page.run(figure)
    page.run("document.querySelector('.another').click()")
    assert page.run(shown) != first
    assert page.run(figure) != drawn
    page.run("document.querySelector('.another').click()")
    assert page.run(shown) == first


def test_every_draw_is_shown_whole(page: Page) -> None:
    assert page.run("document.querySelectorAll('section').length") > 0
    for _draw in range(2):
        shown = page.run(
            "Array.from(document.querySelectorAll('section'), (box) => {"
            " box.querySelector('.solution').click();"
            " box.querySelector('.motion').open = true;"
            " return box.textContent; })"
        )
        assert [text for text in shown if re.search("undefined|NaN", text)] == []
        page.run("for (const each of document.querySelectorAll('.another')) each.click()")


def test_it_fits_a_telephone(page: Page) -> None:
    page.size(360, 740)
    page.run("for (const each of document.querySelectorAll('.solution')) each.click()")
    assert page.run("document.documentElement.scrollWidth") <= 360


def test_nothing_is_asked_of_anybody_or_said_on_the_console(page: Page) -> None:
    page.run("for (const each of document.querySelectorAll('button')) each.click()")
    itself = f"request: {page.run('location.href')}"
    assert [said for said in page.messages() if said != itself] == []


@GROUP
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nothing_stands_in_the_way_of_anybody(folder: Path, scheme: str) -> None:
    with open_page() as page:
        page.prefer(color_scheme=scheme)
        open_sheet(page, write_sheet("en", folder))
        page.run(
            "for (const each of document.querySelectorAll('details')) each.open = true;"
            f"{INPUTS}[0].value = 'abc'; {INPUTS}[1].value = '3';"
            "document.querySelector('form').requestSubmit();"
            "document.querySelector('.solution').click()"
        )
        assert page.faults() == []
        page.run(f"{INPUTS}[1].removeAttribute('id'); {INPUTS}[1].removeAttribute('aria-label')")
        assert [fault for fault in page.faults() if fault.startswith("label: ")] != []


def test_every_box_and_button_says_what_it_is(page: Page) -> None:
    assert page.run(
        "[...document.querySelectorAll('button, summary')].every((each) => each.textContent.trim())"
        " && [...document.querySelectorAll('main input')].every((each) => each.labels.length"
        " || each.getAttribute('aria-label'))"
    )
    marked = page.run("[...document.querySelectorAll('[id]')].map((each) => each.id)")
    assert len(set(marked)) == len(marked)


SLIDER = "document.querySelector('.motion input[type=range]')"
SHOWN = "document.querySelector('.motion output').textContent"


def test_the_mechanism_moves_when_it_is_played_dragged_or_moved_by_a_key(page: Page) -> None:
    page.run("document.querySelector('.motion').open = true")
    page.run("new Promise((done) => setTimeout(done, 100))")
    start = page.run(SHOWN)
    assert start == "0°"
    page.run("document.querySelector('.play').click()")
    page.run("new Promise((done) => setTimeout(done, 400))")
    page.run("document.querySelector('.play').click()")
    played = page.run(SHOWN)
    assert played != start
    page.run(f"{SLIDER}.focus()")
    page.press("ArrowRight")
    keyed = page.run(SHOWN)
    assert keyed != played
    x, y = page.run(
        "(() => { const stage = document.querySelector('.stage svg');"
        " stage.scrollIntoView();"
        " const box = stage.querySelectorAll('.joint')[1].getBoundingClientRect();"
        " return [box.x + box.width / 2, box.y + box.height / 2]; })()"
    )
    for across in (40, -40):  # along the crank nothing would turn
        page.drag((x, y), (x + across, y + 40))
    assert page.run(SHOWN) != keyed


def test_nothing_moves_by_itself(page: Page) -> None:
    page.run("for (const each of document.querySelectorAll('.motion')) each.open = true")
    page.run("new Promise((done) => setTimeout(done, 300))")
    assert page.run(SHOWN) == "0°"
    assert page.run("document.getAnimations().length") == 0


def test_arrows_and_curves_are_drawn(page: Page) -> None:
    page.run("document.querySelector('.motion').open = true")
    page.run("new Promise((done) => setTimeout(done, 100))")
    arrows = "[...document.querySelectorAll('.stage .{}')].filter((each) => each.getAttribute('d'))"
    assert page.run(f"{arrows.format('velocity')}.length") > 0
    assert page.run(f"{arrows.format('acceleration')}.length") == 0
    page.run("document.querySelector('.accelerations').click()")
    assert page.run(f"{arrows.format('acceleration')}.length") > 0
    assert page.run("document.querySelectorAll('section:first-of-type .graph .curve').length") == 3
    assert not page.run("/NaN|undefined/.test(document.querySelector('.motion').innerHTML)")


LETTERS_ON_BARS = """(() => {
  const stage = document.querySelector(".stage svg"), slider = document.querySelector(".motion input[type=range]");
  const found = [];
  for (let share = 0; share < 1; share += 0.07) {
    slider.value = String(share * slider.max);
    slider.dispatchEvent(new Event("input"));
    for (const letter of stage.querySelectorAll("text.letter")) {
      const [x, y] = [letter.getAttribute("x"), letter.getAttribute("y") - 1.1];
      const bars = [...stage.querySelectorAll(".bar")].filter((bar) =>
        [...bar.points].some((corner) => Math.hypot(corner.x - x, corner.y - y) < 5));
      for (const bar of bars) {
        const length = bar.getTotalLength();
        for (let along = 0; along <= length; along += 0.5) {
          const place = bar.getPointAtLength(along);
          if (letter.textContent && Math.hypot(place.x - x, place.y - y) < 1.5) found.push([share, letter.textContent]);
        }
      }
    }
  }
  return found;
})()"""


def test_letters_keep_off_the_bars_of_their_points(page: Page) -> None:
    page.run("document.querySelector('.motion').open = true")
    page.wait("document.querySelector('.stage .bar')")
    assert page.run(LETTERS_ON_BARS) == []


def test_paths_poles_and_centrodes_are_drawn_when_they_are_asked_for(page: Page) -> None:
    page.run("document.querySelector('.motion').open = true")
    page.wait("document.querySelector('.stage .bar')")
    count = "[...document.querySelectorAll('.stage {}')].filter((each) => !each.matches('[hidden]')).length"
    asked = {"paths": ".trace", "poles": "circle.pole", "centrodes": ".moving-centrode"}
    assert [page.run(count.format(drawn)) for drawn in asked.values()] == [2, 0, 0]
    for box in asked:
        page.run(f"document.querySelector('.{box}').click()")
    assert [page.run(count.format(drawn)) for drawn in asked.values()] == [0, 1, 1]


def test_boxes_for_poles_are_there_where_a_body_has_one(page: Page) -> None:
    page.run("for (const each of document.querySelectorAll('.motion')) each.open = true")
    page.wait("document.querySelectorAll('.stage .bar').length > 4")
    boxes = "document.querySelectorAll('.motion')[{}].querySelectorAll('.of-poles:not([hidden])').length"
    assert [page.run(boxes.format(number)) for number in range(4)] == [2, 2, 0, 2]


def test_no_boxes_for_poles_are_there_where_positions_are_too_few_to_tell_them(
    tmp_path: Path,
) -> None:
    whole = Bank.read("demo").blueprint
    first = structs.replace(whole, slots=whole.slots[:1])
    sheet = make_practice_sheet(first, 1, "poles", ENGLISH).sheet
    question = sheet.questions[0]
    assert question.draws[0].motion is not None
    draw = replace(question.draws[0], motion=replace(question.draws[0].motion, poles=False))
    file = tmp_path / "sheet.html"
    page_of = replace(sheet, questions=(replace(question, draws=(draw,)),))
    file.write_text(write_page(page_of, ENGLISH), encoding="utf-8")
    with open_page() as page:
        open_sheet(page, file)
        page.run("document.querySelector('.motion').open = true")
        page.wait("document.querySelectorAll('.stage *').length > 4")
        assert page.run("document.querySelectorAll('.motion .of-poles').length") == 2
        assert page.run("document.querySelectorAll('.of-poles:not([hidden])').length") == 0
