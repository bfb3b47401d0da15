"""What a notebook shows: it asks an object for its representations, as these tests do; what comes
from templates and rosters is escaped.
"""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

import kinegrade
from kinegrade.files.tables import parse_table
from kinegrade.marks_folder.folder import MarksFolder
from kinegrade.marks_folder.table_html import write_table_html
from kinegrade.public.problem import Problem
from tests.problem.crank import TEXT, crank

HOSTILE = "<script>alert(1)</script> & <img src=x onerror=alert(1)>"


def read_html(html: str) -> ElementTree.Element:
    """The tree of a piece of HTML, which is well-formed XML too."""
    return ElementTree.fromstring(f"<div>{html}</div>")


def test_a_problem_shows_its_statement_its_figure_and_the_names_of_its_answers() -> None:
    html = kinegrade.template("slider-crank")._repr_html_()
    tree = read_html(html)
    assert tree.findtext("h4") == "Slider-crank mechanism"
    assert "The crank" in "".join(tree.itertext())
    assert tree.find("p/math") is not None
    assert html.count("<svg ") == 1
    assert [name.text for name in tree.findall("ul/li/code")] == [
        "v_B",
        "omega_AB",
        "alpha_AB",
        "a_B",
    ]


def test_the_figure_of_a_problem_is_an_svg_document() -> None:
    svg = kinegrade.template("slider-crank")._repr_svg_()
    assert ElementTree.fromstring(svg).tag == "{http://www.w3.org/2000/svg}svg"


def test_a_problem_without_english_is_shown_in_a_language_that_it_has(tmp_path: Path) -> None:
    chinese = re.sub(r'en = (\'\'\'.*?\'\'\'|"[^"]*"),? ?', "", TEXT)
    (tmp_path / "crank.toml").write_text(chinese, encoding="utf-8")
    tree = read_html(kinegrade.template(tmp_path / "crank.toml")._repr_html_())
    assert tree.findtext("h4") == "曲柄"


@pytest.mark.parametrize("old", ["A crank", "The crank", "along x"])
def test_texts_of_a_hostile_template_are_escaped(old: str) -> None:
    html = Problem(crank((old, HOSTILE)))._repr_html_()
    read_html(html)
    assert re.findall("<script|<img", html) == []
    assert "&lt;script&gt;" in html


def test_a_problem_that_cannot_be_shown_says_why() -> None:
    broken = Problem(crank(("$A$", "$\\omgea<b>$")))
    html = broken._repr_html_()
    assert re.fullmatch(r"<pre>[^<]*unknown command [^<]*</pre>", html)
    assert broken._repr_svg_() is not None  # its figure is drawn all the same


@pytest.fixture(scope="module")
def marks(small_class: Path, tmp_path_factory: pytest.TempPathFactory) -> MarksFolder:
    """The marks of the small class, with one student renamed."""
    output = tmp_path_factory.mktemp("marked") / "MARKS"
    exam = kinegrade.open_exam(small_class / "EXAM")
    kinegrade.grade(exam, small_class / "EXAM" / "answers.csv", output)
    grades = output / "grades.csv"
    text = grades.read_text(encoding="utf-8-sig").replace("王伟", "<b>王伟</b>")
    grades.write_text(text, encoding="utf-8")
    return MarksFolder(output)


def test_marks_show_their_table_escaped(marks: MarksFolder) -> None:
    html = marks._repr_html_()
    table = read_html(html).find("table")
    assert table is not None
    heads = [cell.text for cell in table.findall("thead/tr/th")]
    assert heads[:3] == ["student", "name", "q1"]
    assert [row.findtext("td") for row in table.findall("tbody/tr")] == ["007", "0012", "a/b", "=2"]
    assert "&lt;b&gt;王伟&lt;/b&gt;" in html


def test_a_long_table_ends_in_dots() -> None:
    rows = "".join(f"{number},x\n" for number in range(100))
    tree = read_html(write_table_html(parse_table(f"student,name\n{rows}".encode(), "grades.csv")))
    shown = [row.findtext("td") for row in tree.findall("table/tbody/tr")]
    assert (len(shown), shown[-1]) == (61, "…")


def test_what_a_prompt_prints_is_short(small_class: Path) -> None:
    bank = kinegrade.Bank.read(small_class / "bank.toml")
    assert repr(bank) == "<q1: slider-crank, q2: crank, q3: bar-through-swivelling-sleeve>"
    assert repr(kinegrade.template("slider-crank")) == "<slider-crank>"
    assert repr(kinegrade.open_exam(small_class / "EXAM")).startswith("ExamFolder(path=")
    assert len(repr(kinegrade.open_exam(small_class / "EXAM"))) < 300
