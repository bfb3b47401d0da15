"""`kinegrade gallery`: every template with what it asks and how it looks; what cannot be shown says
why.
"""

from __future__ import annotations

import re
from io import BytesIO
from pathlib import Path

import pytest
from pypdf import PdfReader

from kinegrade.choosing.demands import find_demands
from kinegrade.language import Language
from kinegrade.problem.template.library.library import load_template
from kinegrade.problem.template.library.starter import write_starter_text
from kinegrade.problem.template.tags import list_tags
from tests.small_class import kinegrade

NAMES = ("slider-crank", "bar-through-swivelling-sleeve")


def write(folder: Path, name: str, *changes: tuple[str, str]) -> Path:
    """The starter with some texts replaced, as a file."""
    text = write_starter_text()
    for old, new in changes:
        text = text.replace(old, new)
    path = folder / f"{name}.toml"
    path.write_text(text, encoding="utf-8")
    return path


def pages(file: Path) -> list[str]:
    """The text of each page, on one line."""
    return [
        " ".join(page.extract_text().split())
        for page in PdfReader(BytesIO(file.read_bytes())).pages
    ]


def gallery(folder: Path, *arguments: str | Path) -> tuple[int, str, list[str]]:
    """Exit status, complaints and the text of each page."""
    result = kinegrade("gallery", *arguments, "-o", folder / "gallery.pdf", "--force")
    assert result.stdout == ""
    return result.exit_code, result.stderr, pages(folder / "gallery.pdf")


@pytest.mark.parametrize("language", ["en", "zh"])
def test_each_template_stands_there_with_title_name_and_number_of_combinations(
    language: Language, tmp_path: Path
) -> None:
    status, complaints, (page,) = gallery(tmp_path, *NAMES, "--lang", language)
    assert (status, complaints) == (0, "")
    for template in map(load_template, NAMES):
        assert template.about.title.in_language(language) in page
        assert template.name in page
        assert template.about.family in page
        assert f"{template.combinations} " in page
        demands = find_demands(template)
        level = {
            "en": f"difficulty {demands.difficulty} of 5, about {demands.minutes} min",
            "zh": f"难度 {demands.difficulty}（共 5 级），约 {demands.minutes} 分钟",
        }[language]
        assert level in page
        assert ", ".join(sorted(list_tags(template))) in page
    assert ("page 1 of 1" if language == "en" else "第 1 页，共 1 页") in page
    assert page.count("Asked:" if language == "en" else "所求：") == 2


def test_templates_are_grouped_by_family_and_pages_numbered(tmp_path: Path) -> None:
    rows = [line.split("\t") for line in kinegrade("list").stdout.splitlines()]
    few = [name for name, family, *_ in rows if family in ("slider-crank", "pose", "trammel")]
    status, complaints, sheets = gallery(tmp_path, *few, "--draws", "1")
    assert (status, complaints) == (0, "")
    text = " ".join(sheets)
    families = sorted({family for name, family, *_ in rows if name in few})
    members = [
        name for family in families for name, own, *_ in rows if own == family and name in few
    ]
    places = [re.search(rf"{name} +Asked", text) for name in members]
    starts = [place.start() for place in places if place is not None]
    assert len(starts) == len(few)
    assert starts == sorted(starts)
    assert [
        (number, page)
        for number, page in enumerate(sheets, start=1)
        if f"page {number} of {len(sheets)}" not in page
    ] == []


def test_the_draws_are_as_many_as_asked_for_and_the_same_every_time(tmp_path: Path) -> None:
    _, _, (one,) = gallery(tmp_path, "slider-crank", "--draws", "1")
    first = (tmp_path / "gallery.pdf").read_bytes()
    _, _, (five,) = gallery(tmp_path, "slider-crank", "--draws", "5")
    assert (one.count("rad/s"), five.count("rad/s")) == (
        2,
        10,
    )  # angular velocity and acceleration of the crank
    gallery(tmp_path, "slider-crank", "slider-crank", "--draws", "1")
    assert (tmp_path / "gallery.pdf").read_bytes() == first


def test_a_long_title_wraps_and_math_in_it_is_set(tmp_path: Path) -> None:
    words = " ".join(f"word{number}" for number in range(30))
    path = write(
        tmp_path, "long", ('en = "Crank and slotted rocker"', f'en = "{words} $\\\\omega_1$"')
    )
    status, _, (page,) = gallery(tmp_path, path)
    assert status == 0
    assert words in page
    assert "omega" not in page


def test_a_template_that_cannot_be_drawn_is_shown_with_the_reason(tmp_path: Path) -> None:
    path = write(tmp_path, "never", ('conditions = ["5*r <= 4*b"]', 'conditions = ["5*r < 0"]'))
    status, complaints, (page,) = gallery(tmp_path, path, "slider-crank")
    reason = (
        "gallery (never): none of the first 60 of the 5390 combinations of values is fit for "
        "students (condition 60)"
    )
    assert status == 1
    assert complaints.startswith(f"complaint: {reason}")
    assert f"Cannot be shown: {reason}" in page
    assert "Slider-crank mechanism" in page


def test_a_template_that_cannot_be_read_or_printed_spoils_nothing(tmp_path: Path) -> None:
    files = (
        write(tmp_path, "unread", ("[bodies]", "[wheels]")),
        write(
            tmp_path, "formula", ('en = "Crank and slotted rocker"', 'en = "Rocker $\\\\nosuch$"')
        ),
        write(tmp_path, "glyph", ('en = "Crank and slotted rocker"', 'en = "Rocker 😀"')),
        write(tmp_path, "key", ("tags = []", '"😀" = 1')),
    )
    line = 1 + files[0].read_text(encoding="utf-8").splitlines().index("[wheels]")
    status, complaints, (page,) = gallery(tmp_path, *files, "slider-crank")
    assert status == 1
    for reason in (
        f"unread.toml:{line}: wheels: unknown table or key",
        "formula, title: formula $\\nosuch$: unknown command",
        "glyph: no font prints [U+1F600]",
        "key.toml:9: [U+1F600]: unknown table or key",
    ):
        assert f"complaint: {reason}" in complaints
        assert reason in page
    assert page.index("Slider-crank mechanism") < page.index(
        "Templates that cannot be read or printed"
    )


def test_nothing_to_show_is_a_refusal_and_writes_nothing(tmp_path: Path) -> None:
    result = kinegrade("gallery", "slider-krank", "-o", tmp_path / "gallery.pdf")
    assert result.exit_code == 2
    assert result.stderr.startswith(
        'error: no template "slider-krank": did you mean "slider-crank"?'
    )
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_is_there_is_kept_unless_forced(tmp_path: Path) -> None:
    file = tmp_path / "gallery.pdf"
    file.write_bytes(b"mine")
    result = kinegrade("gallery", "slider-crank", "-o", file)
    assert (result.exit_code, file.read_bytes()) == (2, b"mine")
    assert "exists" in result.stderr
