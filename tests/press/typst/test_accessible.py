"""Every page that the embedded typesetter prints can be heard: it passes PDF/UA-1, joined or alone."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from io import BytesIO
from itertools import pairwise
from pathlib import Path

import pikepdf
import pytest

from kinegrade.exam.printing.sample import print_sample, print_worked_solution
from kinegrade.language import ENGLISH, Language
from kinegrade.press.formula_sheet import bind
from kinegrade.press.join import join_pages, open_volume
from kinegrade.press.sheet import FormulaSheet
from kinegrade.press.typst.compiler import make_compiler
from kinegrade.press.typst.press import TypstPress
from kinegrade.problem.solving import solve_template
from kinegrade.problem.template.library.library import load_template
from tests.press.accessible import list_failed_rules
from tests.press.heard import say
from tests.press.papers import CHINESE
from tests.press.papers import ENGLISH as PAPER

LANGUAGES: tuple[Language, ...] = ("en", "zh", "de")
HEADS = {"en": "Find", "de": "Gesucht", "zh": "求"}
TEMPLATES = ("slider-crank", "bar-through-swivelling-sleeve")


def list_alternatives(pdf: bytes, kind: str) -> list[str]:
    """What stands in for the elements of a kind."""
    with pikepdf.open(BytesIO(pdf)) as document:
        return [
            str(each.get("/Alt", ""))
            for each in document.objects
            if isinstance(each, pikepdf.Dictionary) and each.get("/S") == f"/{kind}"
        ]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", TEMPLATES)
def test_papers_and_solutions_pass(name: str, language: Language) -> None:
    template = load_template(name)
    paper = print_sample(template, "heard", language)
    solution = print_worked_solution(solve_template(template, {}), language)
    for pdf in (paper, solution, join_pages([paper, solution])):
        assert list_failed_rules(pdf) == []
        for kind in ("Formula", "Figure"):
            said = list_alternatives(pdf, kind)
            assert said
            assert all(said), said


def list_headings(pdf: bytes) -> list[int]:
    """The levels of the headings, in the order in which they are read."""

    def walk(element: pikepdf.Object) -> Iterator[int]:
        if not isinstance(element, pikepdf.Dictionary):
            return
        if re.fullmatch("/H[1-6]", str(element.get("/S"))):
            yield int(str(element.S)[2:])
        kids = element.get("/K", ())
        for kid in kids if isinstance(kids, pikepdf.Array) else [kids]:
            yield from walk(kid)

    with pikepdf.open(BytesIO(pdf)) as document:
        return list(walk(document.Root.StructTreeRoot))


def test_pages_have_headings_of_which_no_level_is_left_out() -> None:
    assert list_headings(TypstPress().paper(PAPER)) == [1, *(2 for _ in PAPER.questions)]
    assert list_headings(TypstPress().paper(replace(PAPER, large=True))) == [1, 2]
    worked = print_worked_solution(solve_template(load_template(TEMPLATES[0]), {}), "en")
    levels = list_headings(worked)
    assert levels[0] == 1
    assert {2, 3} <= set(levels)
    assert [
        (before, after) for before, after in pairwise(levels) if not (after <= before + 1)
    ] == []
    assert list_headings(join_pages([worked, worked])) == [*levels, *levels]


@pytest.mark.parametrize(
    ("body", "levels"),
    [
        ('strong("A")', [1]),
        ('box(width: 7mm, strong("1")) + strong("")', [1]),
        ("strong([$x$])", [1]),
        ('strong("") + h(1em) + [ ]', []),
        ("none", []),
    ],
)
def test_what_has_nothing_to_say_is_no_heading(body: str, levels: list[int]) -> None:
    source = f'#import "/page.typ": headed\n#set document(title: "T")\n#headed(1, 12pt, {body})x'
    compiled = make_compiler().compile(source.encode(), format="pdf", pdf_tags=True, timestamp=0)
    assert isinstance(compiled, bytes)
    assert list_headings(compiled) == levels


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_column_of_a_paper_is_without_a_header(language: Language) -> None:
    said = say(TypstPress().paper(replace(PAPER, language=language)))
    heads = next(line for line in said.splitlines() if line.startswith(f"| {HEADS[language]} |"))
    assert "| |" not in heads


def test_formulas_are_said_in_the_language_of_the_paper() -> None:
    template = load_template("slider-crank")
    said = [
        list_alternatives(print_sample(template, "heard", each), "Formula") for each in LANGUAGES
    ]
    for words, equals in zip(said, ("equals", "等于", "gleich"), strict=True):
        assert any(equals in each for each in words), words


def test_a_volume_passes_and_has_the_structure_of_all_its_parts(tmp_path: Path) -> None:
    press = TypstPress()
    parts = [press.paper(PAPER), press.paper(CHINESE), press.paper(PAPER)]
    with open_volume(tmp_path / "papers.pdf", duplex=True) as append:
        for part in parts:
            append(part)
    whole = (tmp_path / "papers.pdf").read_bytes()
    assert list_failed_rules(whole) == []
    for kind in ("Formula", "Table", "TH", "Figure"):
        alone = sum(len(list_alternatives(part, kind)) for part in parts)
        assert len(list_alternatives(whole, kind)) == alone


def test_structures_are_packed_in_a_volume() -> None:
    pdf = TypstPress().paper(PAPER)
    assert len(join_pages([pdf, pdf])) < 0.7 * 2 * len(pdf)


def test_the_header_cells_of_a_volume_have_names_of_their_own() -> None:
    pdf = TypstPress().paper(PAPER)
    with pikepdf.open(BytesIO(join_pages([pdf, pdf]))) as whole:
        cells = [each for each in whole.objects if isinstance(each, pikepdf.Dictionary)]
        names = [str(each.ID) for each in cells if "/ID" in each]
        meant = {
            str(name)
            for each in cells
            if each.get("/S") == "/TD"
            for attributes in each.get("/A", ())
            for name in attributes.get("/Headers", ())
        }
    assert names
    assert len(set(names)) == len(names)
    assert meant <= set(names)


def test_a_paper_with_a_formula_sheet_passes() -> None:
    sheet = FormulaSheet(text="Speed: $v = r\\omega$", pdf=b"")
    assert list_failed_rules(bind(TypstPress().paper(PAPER), sheet, ENGLISH, "a4")) == []


def test_pages_that_somebody_brought_are_not_said_to_be_tagged() -> None:
    brought = BytesIO()
    with pikepdf.new() as blank:
        blank.add_blank_page()
        blank.save(brought)
    whole = join_pages([TypstPress().paper(PAPER), brought.getvalue()])
    with pikepdf.open(BytesIO(whole)) as document:
        assert document.Root.MarkInfo.Marked is False
