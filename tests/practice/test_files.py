"""A practice sheet as files: what it may load, what a SCORM package holds. How large it may be is
a proof ("practice sheet size").
"""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree
from zipfile import ZipFile

import pytest

import kinegrade as api
from kinegrade.language import ENGLISH, Language
from kinegrade.practice.making import make_practice_sheet
from kinegrade.practice.page import write_page
from kinegrade.practice.patterns import pool_texts
from tests.small_class import kinegrade

BANK = 'title = "T"\ncourse = "C"\n\n[[questions]]\ntemplate = "bar-through-swivelling-sleeve"\n'


@pytest.fixture
def bank(tmp_path: Path) -> Path:
    """A bank of one question."""
    file = tmp_path / "bank.toml"
    file.write_text(BANK, encoding="utf-8")
    return file


def test_the_policy_of_the_page_forbids_everything_but_its_own_script(bank: Path) -> None:
    made = make_practice_sheet(api.Bank.read(bank).blueprint, 1, "practice", ENGLISH)
    page = write_page(made.sheet, ENGLISH)
    assert "default-src 'none'; script-src 'sha256-" in page
    assert re.findall(r"""\b(?:src|href)=["'](?!data:)""", page) == []
    assert re.findall(r"https?://(?!www\.w3\.org)", page) == []


def test_the_same_command_gives_the_same_bytes(bank: Path, tmp_path: Path) -> None:
    for name in ("once.html", "again.html"):
        done = kinegrade("practice", bank, "-o", tmp_path / name, "--draws", "2")
        assert done.exit_code == 0, done.stderr
    assert (tmp_path / "again.html").read_bytes() == (tmp_path / "once.html").read_bytes()


@pytest.mark.parametrize(("count", "said"), [(1, "1 question, "), (2, "2 questions, ")])
def test_the_command_says_how_many_questions_there_are(
    count: int, said: str, bank: Path, tmp_path: Path
) -> None:
    question = BANK[BANK.index("[[") :]
    bank.write_text(BANK + question * (count - 1), encoding="utf-8")
    done = kinegrade("practice", bank, "-o", tmp_path / "sheet.html", "--draws", "1")
    assert f"sheet.html: {said}" in done.stdout + done.stderr


def test_too_few_sets_of_numbers_are_told_with_what_helps(bank: Path, tmp_path: Path) -> None:
    few = "draw = { l = ['0.4'], phi = [30, 60], v = ['0.4'], a = [3] }"
    bank.write_text(BANK + few, encoding="utf-8")
    done = kinegrade("practice", bank, "-o", tmp_path / "sheet.html", "--draws", "4")
    assert (
        "q1: only 2 good sets of numbers among the 2 combinations of values - "
        "state more values in the question, as in draw = { l = [...] }"
    ) in done.stderr


def test_a_file_of_another_kind_is_refused(bank: Path, tmp_path: Path) -> None:
    done = kinegrade("practice", bank, "-o", tmp_path / "sheet.pdf", "--draws", "1")
    assert done.exit_code == 2
    assert "no HTML file - expected" in done.stderr or ".html" in done.stderr


def test_a_package_holds_the_page_that_its_manifest_names(bank: Path, tmp_path: Path) -> None:
    done = kinegrade("practice", bank, "-o", tmp_path / "p.zip", "--draws", "1", "--scorm")
    assert done.exit_code == 0, done.stderr
    with ZipFile(tmp_path / "p.zip") as package:
        manifest = ElementTree.fromstring(package.read("imsmanifest.xml"))
        page = package.read("practice.html").decode()
    names = {"cp": "http://www.imsproject.org/xsd/imscp_rootv1p1p2"}
    resource = manifest.find("cp:resources/cp:resource", names)
    assert resource is not None
    assert resource.get("href") == "practice.html"
    assert resource.get("{http://www.adlnet.org/xsd/adlcp_rootv1p2}scormtype") == "sco"
    assert manifest.findtext("cp:metadata/cp:schemaversion", None, names) == "1.2"
    assert "cmi.core.score.raw" in page


def test_draws_that_differ_in_words_have_patterns_of_their_own() -> None:
    pooled = pool_texts([["a 1\nb 2\n"], ["a 3\nc 2\n"]])
    assert len(pooled.patterns) == 3
    filled = [
        "".join(str(piece) if isinstance(piece, str) else numbers.split()[piece]
                for pattern, numbers in lines for piece in pooled.patterns[pattern])
        for (lines,) in pooled.draws
    ]  # fmt: skip
    assert filled == ["a 1\nb 2\n", "a 3\nc 2\n"]


def test_numbers_have_the_decimal_mark_of_the_language(bank: Path) -> None:
    blueprint = api.Bank.read(bank).blueprint
    sheet = make_practice_sheet(blueprint, 1, "practice", Language("de")).sheet
    patterns = [str(piece) for each in sheet.questions for line in each.patterns for piece in line]
    written = "".join(patterns)
    assert re.findall(r"<mn>[0-9]+\.[0-9]", written) == []
    assert re.search("<mn>[0-9]+</mn><mi>,</mi><mn>[0-9]", written)
