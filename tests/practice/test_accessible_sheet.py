"""Sheets are open to everybody: to WCAG 2.2 AA as far as axe-core sees, in a small window, on
paper, with a screen reader, without motion.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from tests.browsers.page import open_page
from tests.practice.accessible_sheet import find_barriers, list_names
from tests.practice.typed_sheet import open_sheet
from tests.small_class import kinegrade

BANK = """title = "Practice"
course = "Mechanics"

[[questions]]
template = "{template}"
"""
KINDS = [("geneva-drive", "zh"), ("bent-rod-two-sleeves", "en"), ("slider-crank", "de")]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("sheets")


@cache
def write_sheet(template: str, language: str, folder: Path) -> Path:
    """A sheet of one template."""
    bank, file = folder / f"{template}.toml", folder / f"{template}-{language}.html"
    bank.write_text(BANK.format(template=template), encoding="utf-8")
    done = kinegrade("practice", bank, "-o", file, "--draws", "1", "--lang", language)
    assert done.exit_code == 0, done.stderr
    return file


@pytest.mark.parametrize(("template", "language"), KINDS)
def test_nothing_stands_in_the_way(template: str, language: str, folder: Path) -> None:
    with open_page() as page:
        assert list(find_barriers(page, write_sheet(template, language, folder))) == []


def test_what_does_is_found(folder: Path, tmp_path: Path) -> None:
    file = tmp_path / "sheet.html"
    text = write_sheet("slider-crank", "en", folder).read_text(encoding="utf-8")
    text = text.replace("--link: #8fc1ff", "--link: #333").replace("button, .help", ".help")
    text = text.replace("@media screen and (prefers", "@media (prefers")
    broad = '<main style="min-width: 900px">'
    file.write_text(text.replace("<main>", f"{broad}"), encoding="utf-8")
    with open_page() as page:
        found = "\n".join(find_barriers(page, file))
    assert "dark: color-contrast: <button" in found
    assert "pixels wide in a window of 320" in found
    assert "button on paper" in found
    assert "dark on paper" in found


def test_a_screen_reader_has_the_formulas_of_labels_and_the_figure_in_a_sentence(
    folder: Path,
) -> None:
    with open_page() as page:
        open_sheet(page, write_sheet("bent-rod-two-sleeves", "en", folder))
        names = [name for _, name in list_names(page.tree())]
    assert any("of the velocity of point M along AE" in name for name in names), names
    assert "Figure of the mechanism" not in names
    assert any("drawn to scale: points A, E, M" in name for name in names), names


def test_a_mechanism_is_shown_in_still_pictures_to_those_who_want_less_motion(
    folder: Path,
) -> None:
    file = write_sheet("slider-crank", "en", folder)
    with open_page() as page:
        shown = {}
        for wish in ("no-preference", "reduce"):
            page.prefer(reduced_motion=wish)
            open_sheet(page, file)
            page.run("document.querySelector('.motion').open = true")
            page.wait("document.querySelector('.stage .bar')")
            shown[wish] = page.run(
                "new Promise((done) => { const seen = new Set();"
                " document.querySelector('.play').click();"
                " const look = () => {"
                " seen.add(parseFloat(document.querySelector('.motion output').textContent));"
                " if (seen.size < 4) requestAnimationFrame(look); else done([...seen]); };"
                " look(); })"
            )
    assert [angle % 30 for angle in shown["reduce"]] == [0, 0, 0, 0]
    assert [angle % 30 for angle in shown["no-preference"]] != [0, 0, 0, 0]
